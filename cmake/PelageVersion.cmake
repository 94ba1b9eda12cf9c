# Generates what --version prints: the version of the project, the commit that was built and the version of the contract.
# After a commit CMake configures again, which is cheap: it compiles one file.
file(STRINGS ${CMAKE_SOURCE_DIR}/protocol/openapi/openapi.yaml PELAGE_CONTRACT_LINE REGEX "^  version: " LIMIT_COUNT 1)
string(REGEX REPLACE "^  version: *" "" PELAGE_CONTRACT "${PELAGE_CONTRACT_LINE}")

set(PELAGE_COMMIT "unknown")
find_package(Git QUIET)
if(Git_FOUND)
  execute_process(COMMAND ${GIT_EXECUTABLE} -C ${CMAKE_SOURCE_DIR} rev-parse --short=12 HEAD
    OUTPUT_VARIABLE PELAGE_FOUND_COMMIT OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET RESULT_VARIABLE PELAGE_GIT_FAILED)
  execute_process(COMMAND ${GIT_EXECUTABLE} -C ${CMAKE_SOURCE_DIR} rev-parse --git-path logs/HEAD
    OUTPUT_VARIABLE PELAGE_GIT_LOG OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
  if(PELAGE_GIT_FAILED EQUAL 0)
    set(PELAGE_COMMIT ${PELAGE_FOUND_COMMIT})
    get_filename_component(PELAGE_GIT_LOG "${PELAGE_GIT_LOG}" ABSOLUTE BASE_DIR ${CMAKE_SOURCE_DIR})
    if(EXISTS ${PELAGE_GIT_LOG})
      set_property(DIRECTORY ${CMAKE_SOURCE_DIR} APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${PELAGE_GIT_LOG})
    endif()
  endif()
endif()

configure_file(${CMAKE_SOURCE_DIR}/base/version/version.cpp.in ${CMAKE_BINARY_DIR}/generated/version.cpp @ONLY)
