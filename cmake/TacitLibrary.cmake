# Libraries and programs of the tree.
#
# Every library sees only its own folder and those of the libraries it links, through a folder of
# links in the build tree (an include view). An include that the link graph does not allow does
# not compile.

# tacit_view(<target> <folder> <scope>): adds the include view of <folder> to <target>.
function(tacit_view target folder scope)
  set(view ${CMAKE_BINARY_DIR}/views/${target})
  get_filename_component(parent ${folder} DIRECTORY)
  file(MAKE_DIRECTORY ${view}/${parent})
  file(CREATE_LINK ${CMAKE_SOURCE_DIR}/${folder} ${view}/${folder} SYMBOLIC)
  target_include_directories(${target} ${scope} ${view})
endfunction()

# tacit_library(<name> <folder> SOURCES ... [PUBLIC ...] [PRIVATE ...])
function(tacit_library name folder)
  cmake_parse_arguments(ARG "" "" "SOURCES;PUBLIC;PRIVATE" ${ARGN})
  list(TRANSFORM ARG_SOURCES PREPEND ${CMAKE_SOURCE_DIR}/${folder}/)
  if(ARG_SOURCES)
    add_library(${name} STATIC ${ARG_SOURCES})
    tacit_view(${name} ${folder} PUBLIC)
    target_link_libraries(${name} PUBLIC ${ARG_PUBLIC} PRIVATE ${ARG_PRIVATE} tacit_flags)
  else()
    add_library(${name} INTERFACE)
    tacit_view(${name} ${folder} INTERFACE)
    target_link_libraries(${name} INTERFACE ${ARG_PUBLIC})
  endif()
endfunction()

# tacit_program(<name> <folder> SOURCES ... LINK ...)
function(tacit_program name folder)
  cmake_parse_arguments(ARG "" "" "SOURCES;LINK" ${ARGN})
  list(TRANSFORM ARG_SOURCES PREPEND ${CMAKE_SOURCE_DIR}/${folder}/)
  add_executable(${name} ${ARG_SOURCES})
  tacit_view(${name} ${folder} PRIVATE)
  target_link_libraries(${name} PRIVATE ${ARG_LINK} tacit_flags)
  set_target_properties(${name} PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/bin)
endfunction()

# tacit_test(<name> <folder under tests> SOURCES ... LINK ... [LABELS ...] [TIMEOUT s]
#            [RESOURCES ...] [PROPERTIES ...]): one GoogleTest program, one ctest entry per case.
function(tacit_test name folder)
  cmake_parse_arguments(ARG "" "TIMEOUT" "SOURCES;LINK;LABELS;PROPERTIES" ${ARGN})
  if(NOT ARG_TIMEOUT)
    set(ARG_TIMEOUT 60)
  endif()
  if(NOT ARG_LABELS)
    set(ARG_LABELS unit)
  endif()
  list(TRANSFORM ARG_SOURCES PREPEND ${CMAKE_SOURCE_DIR}/tests/${folder}/)
  add_executable(${name} ${ARG_SOURCES})
  tacit_view(${name} tests/${folder} PRIVATE)
  target_link_libraries(${name} PRIVATE ${ARG_LINK} tacit_flags GTest::gtest_main)
  target_compile_definitions(${name} PRIVATE TACIT_SOURCE_DIR="${CMAKE_SOURCE_DIR}"
                                             TACIT_BIN_DIR="${CMAKE_BINARY_DIR}/bin")
  gtest_discover_tests(${name} DISCOVERY_TIMEOUT 60
    PROPERTIES TIMEOUT ${ARG_TIMEOUT} LABELS "${ARG_LABELS}" ${ARG_PROPERTIES})
endfunction()
