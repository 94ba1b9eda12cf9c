# pelage_shaders(TARGET file...): expands, checks and embeds shaders. shells/fur/fur.frag becomes
# `extern const char* const pelage::shaders::fur_frag`. An invalid shader fails the build.
find_package(Python3 REQUIRED COMPONENTS Interpreter)
find_program(GLSLANG_VALIDATOR glslangValidator REQUIRED)

# Generates renderer/shaders/constants.h from constants.glsl when CMake runs, and again when the shader changes.
set(PELAGE_CONSTANTS ${CMAKE_SOURCE_DIR}/renderer/shaders/constants.glsl)
set(PELAGE_CONSTANTS_PROGRAM ${CMAKE_CURRENT_LIST_DIR}/shared_constants.py)
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${PELAGE_CONSTANTS} ${PELAGE_CONSTANTS_PROGRAM})
execute_process(COMMAND ${Python3_EXECUTABLE} ${PELAGE_CONSTANTS_PROGRAM} ${PELAGE_CONSTANTS}
                        ${CMAKE_BINARY_DIR}/generated/renderer/shaders/constants.h
                COMMAND_ERROR_IS_FATAL ANY)
include_directories(${CMAKE_BINARY_DIR}/generated)

function(pelage_shaders TARGET)
  file(GLOB SHARED CONFIGURE_DEPENDS ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/../renderer/shaders/*.glsl
       ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/../renderer/shaders/shared/*.glsl ${CMAKE_CURRENT_SOURCE_DIR}/*.glsl)
  foreach(SHADER ${ARGN})
    get_filename_component(NAME ${SHADER} NAME)
    string(REPLACE "." "_" SYMBOL ${NAME})
    set(OUTPUT ${CMAKE_CURRENT_BINARY_DIR}/${SYMBOL}.cpp)
    add_custom_command(
      OUTPUT ${OUTPUT}
      COMMAND Python3::Interpreter ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/expand_shader.py ${CMAKE_CURRENT_SOURCE_DIR}/${SHADER}
              ${OUTPUT} ${SYMBOL} ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/../renderer/shaders
      DEPENDS ${SHADER} ${SHARED} ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/expand_shader.py
      VERBATIM)
    target_sources(${TARGET} PRIVATE ${OUTPUT})
  endforeach()
endfunction()
