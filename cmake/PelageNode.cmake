# Finds Node.js and npm, fetches npm packages, and adds tests that run on Node. Call the functions only if PELAGE_STUDIO
# is ON, which means that Node and npm were found.
find_program(PELAGE_NODE NAMES node nodejs)
find_program(PELAGE_NPM NAMES npm)
set(PELAGE_STUDIO OFF CACHE INTERNAL "Whether there are node and npm to build the studio")
if(PELAGE_NODE)
  execute_process(COMMAND ${PELAGE_NODE} --version OUTPUT_VARIABLE NODE_VERSION OUTPUT_STRIP_TRAILING_WHITESPACE)
  string(REGEX REPLACE "^v" "" NODE_VERSION "${NODE_VERSION}")
endif()
if(NOT PELAGE_NODE OR NOT PELAGE_NPM OR NODE_VERSION VERSION_LESS 18)
  message(STATUS "No node of version 18 or newer with npm: the server is built without the studio")
else()
  set(PELAGE_STUDIO ON CACHE INTERNAL "Whether there are node and npm to build the studio")
endif()

# Adds a target NAME that fetches the packages of this folder's package-lock.json once; WHAT ends its progress message.
# Sets NAME_STAMP to the file that exists once they are fetched.
function(pelage_npm_packages NAME WHAT)
  set(STAMP ${CMAKE_CURRENT_BINARY_DIR}/packages.stamp)
  add_custom_command(
    OUTPUT ${STAMP}
    COMMAND ${PELAGE_NPM} ci --ignore-scripts --no-progress --loglevel=error
    COMMAND ${CMAKE_COMMAND} -E touch ${STAMP}
    DEPENDS package.json package-lock.json .npmrc
    WORKING_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR}
    COMMENT "Fetching the packages ${WHAT}" VERBATIM)
  add_custom_target(${NAME} ALL DEPENDS ${STAMP})
  set(${NAME}_STAMP ${STAMP} PARENT_SCOPE)
endfunction()

# pelage_check_types(NAME DEPENDS file...): adds a target that checks this folder's TypeScript against the contract. It is a part of
# `all`, and no program waits for it.
function(pelage_check_types NAME)
  cmake_parse_arguments(ARG "" "" "DEPENDS" ${ARGN})
  set(CONTRACT ${CMAKE_RUNTIME_OUTPUT_DIRECTORY}/openapi.json)
  set(CHECK ${CMAKE_SOURCE_DIR}/cmake/check_types.mjs)
  set(STAMP ${CMAKE_CURRENT_BINARY_DIR}/types.stamp)
  add_custom_command(
    OUTPUT ${STAMP}
    COMMAND ${PELAGE_NODE} ${CHECK} ${CONTRACT} ${CMAKE_CURRENT_SOURCE_DIR} ${CMAKE_CURRENT_BINARY_DIR}
    COMMAND ${CMAKE_COMMAND} -E touch ${STAMP}
    DEPENDS ${ARG_DEPENDS} ${CONTRACT} ${CHECK} tsconfig.json
    COMMENT "Checking types of ${CMAKE_CURRENT_SOURCE_DIR}" VERBATIM)
  add_custom_target(${NAME} ALL DEPENDS ${STAMP})
endfunction()

# Adds a test NAME that runs Node with the remaining arguments in this folder, for at most TIMEOUT seconds.
function(pelage_node_test NAME TIMEOUT)
  add_test(NAME ${NAME} COMMAND ${PELAGE_NODE} ${ARGN} WORKING_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR})
  set_tests_properties(${NAME} PROPERTIES TIMEOUT ${TIMEOUT}
    ENVIRONMENT "PELAGE_BIN=${CMAKE_RUNTIME_OUTPUT_DIRECTORY};PELAGE_MCP=${PELAGE_MCP}")
endfunction()

# Adds one test that runs all *.test.mjs of this folder on Node's test runner.
function(pelage_node_tests NAME TIMEOUT)
  file(GLOB FILES CONFIGURE_DEPENDS RELATIVE ${CMAKE_CURRENT_SOURCE_DIR} ${CMAKE_CURRENT_SOURCE_DIR}/*.test.mjs)
  pelage_node_test(${NAME} ${TIMEOUT} --test ${FILES})
endfunction()
