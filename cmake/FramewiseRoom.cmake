# SPDX-FileCopyrightText: 2026 The Framewise authors
# SPDX-License-Identifier: BSD-3-Clause
#
# framewise_room(NAME DEPENDS targets...): a folder is a room, and a room is one library.
# Every foo.cc in the folder belongs to the room; every foo_test.cc belongs to its test program.
# A room of headers alone is an interface library.
#
# With FRAMEWISE_PRECOMPILED_HEADERS what most sources of a room include is read once, and a room that says FEW_UNITS
# is compiled in units of six sources (their unnamed namespaces must not clash). Sources that are compiled for
# several instruction sets see none of it: code for newer processors must not leak into shared inline functions.
# What follows WITHOUT is left out of a room by an option of the build.
include(GNUInstallDirs)
if(FRAMEWISE_BUILD_TESTS)
  include(GoogleTest)
endif()

function(framewise_room name)
  cmake_parse_arguments(ROOM "FEW_UNITS" "" "DEPENDS;PRIVATE_DEPENDS;TEST_DEPENDS;PRECOMPILE;SEVERAL_INSTRUCTION_SETS;WITHOUT" ${ARGN})
  file(GLOB sources CONFIGURE_DEPENDS *.cc)
  file(GLOB tests CONFIGURE_DEPENDS *_test.cc)
  if(tests)
    list(REMOVE_ITEM sources ${tests})
  endif()

  list(TRANSFORM ROOM_WITHOUT PREPEND ${CMAKE_CURRENT_SOURCE_DIR}/)
  if(ROOM_WITHOUT)
    list(REMOVE_ITEM sources ${ROOM_WITHOUT})
    list(REMOVE_ITEM tests ${ROOM_WITHOUT})
  endif()

  set(target framewise_${name})
  if(sources)
    set(scope PUBLIC)
    add_library(${target} STATIC ${sources})
    set_target_properties(${target} PROPERTIES POSITION_INDEPENDENT_CODE ON)
    target_link_libraries(${target} PRIVATE ${ROOM_PRIVATE_DEPENDS})
  else()
    set(scope INTERFACE)
    add_library(${target} INTERFACE)
  endif()
  add_library(Framewise::${name} ALIAS ${target})
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${name})
  target_compile_features(${target} ${scope} cxx_std_20)
  target_include_directories(${target} ${scope}
    $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/src> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
  target_link_libraries(${target} ${scope} ${ROOM_DEPENDS})

  if(FRAMEWISE_PRECOMPILED_HEADERS AND sources)
    target_precompile_headers(${target} PRIVATE ${ROOM_PRECOMPILE})
    set_target_properties(${target} PROPERTIES UNITY_BUILD ${ROOM_FEW_UNITS} UNITY_BUILD_BATCH_SIZE 6)
    set_source_files_properties(${ROOM_SEVERAL_INSTRUCTION_SETS} PROPERTIES
      SKIP_PRECOMPILE_HEADERS ON SKIP_UNITY_BUILD_INCLUSION ON)
  endif()

  install(TARGETS ${target} EXPORT FramewiseTargets)
  install(DIRECTORY ./ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/framewise/${name}
          FILES_MATCHING PATTERN "*.h" PATTERN "*_for_tests.h" EXCLUDE)

  if(FRAMEWISE_BUILD_TESTS AND tests)
    add_executable(${name}_test ${tests})
    target_link_libraries(${name}_test PRIVATE
      ${target} ${ROOM_TEST_DEPENDS} GTest::gtest GTest::gmock GTest::gtest_main)
    target_compile_definitions(${name}_test PRIVATE FRAMEWISE_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
    gtest_discover_tests(${name}_test TEST_PREFIX "${name}: " PROPERTIES TIMEOUT 300 LABELS "${name}")
  endif()
endfunction()
