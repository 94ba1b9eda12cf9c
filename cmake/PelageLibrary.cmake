# pelage_library(NAME [DEPS lib...]): one folder, one idea, one static library made of the folder's .cpp files.
# Includes are written from the top of the repository; links are PRIVATE, so a folder sees only what it names.
function(pelage_library NAME)
  cmake_parse_arguments(ARG "" "" "DEPS" ${ARGN})
  file(GLOB SOURCES CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*.cpp)
  list(FILTER SOURCES EXCLUDE REGEX "/main\\.cpp$")
  if(SOURCES)
    add_library(${NAME} STATIC ${SOURCES})
    target_include_directories(${NAME} PRIVATE ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/..)
    target_link_libraries(${NAME} PRIVATE ${ARG_DEPS})
  else()
    add_library(${NAME} INTERFACE)
  endif()
endfunction()

# pelage_program(NAME SOURCE [DEPS lib...]): a program in build/<preset>/bin.
function(pelage_program NAME SOURCE)
  cmake_parse_arguments(ARG "" "" "DEPS" ${ARGN})
  add_executable(${NAME} ${SOURCE})
  target_include_directories(${NAME} PRIVATE ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/..)
  target_link_libraries(${NAME} PRIVATE ${ARG_DEPS})
endfunction()
