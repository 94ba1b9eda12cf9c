# pelage_library(NAME [COLD] [DEPS lib...]): makes a static library of the .cpp files of this folder, without main.cpp.
# COLD marks code that no frame and no stroke waits for. Releases optimise it less (-Og), which halves its compile time.
# Includes are written from the top of the repository; links are PRIVATE, so a folder sees only the libraries that it names.
function(pelage_library NAME)
  cmake_parse_arguments(ARG "COLD" "" "DEPS" ${ARGN})
  file(GLOB SOURCES CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*.cpp)
  list(FILTER SOURCES EXCLUDE REGEX "/main\\.cpp$")
  if(SOURCES)
    add_library(${NAME} STATIC ${SOURCES})
    target_include_directories(${NAME} PRIVATE ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/..)
    target_link_libraries(${NAME} PRIVATE ${ARG_DEPS})
    if(ARG_COLD)
      target_compile_options(${NAME} PRIVATE $<$<CONFIG:Release>:-Og>)
    endif()
  else()
    add_library(${NAME} INTERFACE)
  endif()
endfunction()

# pelage_for_each_instruction_set(FILE): has Highway compile a file of this folder for SSSE3, AVX2 and AVX-512; the CPU
# decides at run time which version is used.
function(pelage_for_each_instruction_set FILE)
  set_source_files_properties(${FILE} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON COMPILE_DEFINITIONS HWY_DISABLED_TARGETS=HWY_SSE4)
endfunction()

# pelage_program(NAME SOURCE [DEPS lib...]): makes a program in build/<preset>/bin. SOURCE is compiled as COLD: libraries do
# the work.
function(pelage_program NAME SOURCE)
  cmake_parse_arguments(ARG "" "" "DEPS" ${ARGN})
  add_executable(${NAME} ${SOURCE})
  target_include_directories(${NAME} PRIVATE ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/..)
  target_link_libraries(${NAME} PRIVATE ${ARG_DEPS})
  target_compile_options(${NAME} PRIVATE $<$<CONFIG:Release>:-Og>)
endfunction()
