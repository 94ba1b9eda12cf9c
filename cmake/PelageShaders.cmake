# pelage_shaders(TARGET file...): expands, checks and embeds shaders. passes/fur/fur.frag becomes
# `extern const char* const pelage::shaders::fur_frag`. A typo in a shader fails the build.
find_package(Python3 REQUIRED COMPONENTS Interpreter)
find_program(GLSLANG_VALIDATOR glslangValidator REQUIRED)

function(pelage_shaders TARGET)
  file(GLOB SHARED CONFIGURE_DEPENDS ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/../renderer/shaders/*.glsl)
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
