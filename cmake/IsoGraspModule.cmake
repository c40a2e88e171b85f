# SPDX-License-Identifier: GPL-3.0-or-later
# isograsp_module(<folder> SOURCES … [USES <folders>] [PUBLIC_LIBS …] [PRIVATE_LIBS …])
#   one static library per folder, alias isograsp::<folder>.
# isograsp_test(<folder> SOURCES … [USES <folders>] [LIBS …] [TOGETHER <suites>] [REAL_TIME <suites>]
#   [LONG_IF_SANITIZED <suites>])
#   one GoogleTest program tests_<folder>; every case is its own CTest entry "<folder>/<case>". Suites
#   whose cases share what takes long to make run TOGETHER, in one process each: their entry is
#   "<folder>/<suite>", its output names the cases. So do those that live in REAL_TIME: only one other
#   test runs beside them (the presets start three at a time), and they begin first (COST), so that the
#   others run beside them and none is left for the end. LONG_IF_SANITIZED: with sanitizers only where
#   there is time (ISOGRASP_LONG_TESTS), because they would take long and tell little more. With
#   sanitizers four processes share the cases of a program: "<folder>/shard_0" … 3.

add_library(isograsp_options INTERFACE)
target_compile_features(isograsp_options INTERFACE cxx_std_20)
target_compile_options(isograsp_options INTERFACE
  -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Wold-style-cast -Wnon-virtual-dtor
  -Woverloaded-virtual -Wdouble-promotion
  # A fused multiply-add rounds once where two instructions round twice: results would then
  # depend on the machine. Bit-identical replay needs both roundings.
  -ffp-contract=off)
option(ISOGRASP_WERROR "Treat warnings as errors" OFF)
if(ISOGRASP_WERROR)
  target_compile_options(isograsp_options INTERFACE -Werror)
endif()
# What is installed reads files and datagrams of others: an overrun stack or buffer ends the program
# where it happens, addresses are random, and what the loader has filled in cannot be overwritten. No
# computed bit changes (scripts/compare_builds reads the executable and compares).
target_compile_options(isograsp_options INTERFACE $<$<CONFIG:Release>:
  -fstack-protector-strong -U_FORTIFY_SOURCE -D_FORTIFY_SOURCE=2 -fPIE>)
target_link_options(isograsp_options INTERFACE $<$<CONFIG:Release>:-pie -Wl,-z,relro,-z,now>)
# Clang 14 (fuzzers) calls consteval functions in templates where the program runs, and has none there.
target_compile_definitions(isograsp_options INTERFACE
  $<$<AND:$<CXX_COMPILER_ID:Clang>,$<VERSION_LESS:$<CXX_COMPILER_VERSION>,15>>:consteval=constexpr>)
set(ISOGRASP_SANITIZE "" CACHE STRING "Sanitizers, e.g. address,undefined")
if(ISOGRASP_SANITIZE)
  target_compile_options(isograsp_options INTERFACE
    -fsanitize=${ISOGRASP_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer
    # The packaged SOCI does not export the type information that vptr needs. The other four make
    # Eigen compile twice as long to say what the address sanitizer or the processor says anyway.
    -fno-sanitize=vptr,null,alignment,object-size,pointer-overflow
    # False in libstdc++'s <regex> with sanitizers (GCC bug 105562); the other builds still warn.
    $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
  target_link_options(isograsp_options INTERFACE -fsanitize=${ISOGRASP_SANITIZE})
  if(ISOGRASP_SANITIZE STREQUAL "thread")
    # Asio's executors have a fence that the thread sanitizer does not see; what crosses threads here are
    # atomics of Latest and Ring, which it does.
    target_compile_options(isograsp_options INTERFACE $<$<CXX_COMPILER_ID:GNU>:-Wno-tsan>)
  endif()
endif()

# Loops over numbers run twice as long at -Og, which compiles a fifth faster (docs/testing.md). Nobody reads
# errno after a root: without it a root is one instruction, of four numbers as of one.
function(isograsp_numerics target)
  target_compile_options(${target} PRIVATE -fno-math-errno $<$<CONFIG:Debug>:-O1>)
endfunction()

# Files, pages, windows and commands wait for people, disks and libraries: there is less to optimise, and a
# compiler takes a tenth to a quarter less. What is measured is computed elsewhere and stays the same bits.
function(isograsp_no_numerics target)
  target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O1>)
endfunction()

# A unit of as many files as the preset says may take a compiler more than 1.5 GB in this folder.
function(isograsp_at_most files target)
  if(CMAKE_UNITY_BUILD_BATCH_SIZE GREATER files)
    set_target_properties(${target} PROPERTIES UNITY_BUILD_BATCH_SIZE ${files})
  endif()
endfunction()

# These files of the target alone read a library that costs a compiler much: they are compiled together,
# which reads it and makes what they use of it once. The others stay as they were.
function(isograsp_together target)
  if(NOT CMAKE_UNITY_BUILD)
    return()
  endif()
  get_target_property(size ${target} UNITY_BUILD_BATCH_SIZE)
  get_target_property(others ${target} SOURCES)
  list(REMOVE_ITEM others ${ARGN})
  set(place 0)
  foreach(file ${others})
    math(EXPR batch "${place} / ${size}")
    set_source_files_properties(${file} PROPERTIES UNITY_GROUP ${batch})
    math(EXPR place "${place} + 1")
  endforeach()
  set_source_files_properties(${ARGN} PROPERTIES UNITY_GROUP together)
  set_target_properties(${target} PROPERTIES UNITY_BUILD_MODE GROUP)
endfunction()

# Objects say beside their code what they define (GCC's link-time optimisation, which nothing is linked
# with): tests/one_definition compares all of the program. It costs a compiler nothing that one can measure.
option(ISOGRASP_ONE_DEFINITION "Test that no name of the program is defined twice (GCC)" OFF)
function(isograsp_remember_definitions target)
  if(ISOGRASP_ONE_DEFINITION)
    target_compile_options(${target} PRIVATE -flto -ffat-lto-objects)
    set_property(GLOBAL APPEND PROPERTY ISOGRASP_DEFINING ${target})
  endif()
endfunction()

function(isograsp_module name)
  cmake_parse_arguments(ARG "" "" "SOURCES;USES;PUBLIC_LIBS;PRIVATE_LIBS" ${ARGN})
  add_library(isograsp_${name} STATIC ${ARG_SOURCES})
  add_library(isograsp::${name} ALIAS isograsp_${name})
  target_include_directories(isograsp_${name} PUBLIC
    $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}> $<INSTALL_INTERFACE:include/isograsp>)
  list(TRANSFORM ARG_USES PREPEND isograsp::)
  target_link_libraries(isograsp_${name}
    PUBLIC ${ARG_USES} ${ARG_PUBLIC_LIBS}
    PRIVATE $<BUILD_INTERFACE:isograsp_options> ${ARG_PRIVATE_LIBS})
  target_compile_features(isograsp_${name} PUBLIC cxx_std_20)
  isograsp_remember_definitions(isograsp_${name})
endfunction()

function(isograsp_test name)
  cmake_parse_arguments(ARG "" "" "SOURCES;USES;LIBS;TOGETHER;REAL_TIME;LONG_IF_SANITIZED" ${ARGN})
  list(TRANSFORM ARG_USES PREPEND isograsp::)
  add_executable(tests_${name} ${ARG_SOURCES})
  set_target_properties(tests_${name} PROPERTIES UNITY_BUILD_BATCH_SIZE 16)
  # Its operators new and delete are not for the eyes of a compiler that works on others' files.
  set_source_files_properties(../support/no_alloc.cpp PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
  target_include_directories(tests_${name} PRIVATE ${PROJECT_SOURCE_DIR})
  target_link_libraries(tests_${name}
    PRIVATE isograsp_options ${ARG_USES} ${ARG_LIBS} GTest::gtest_main)
  target_compile_definitions(tests_${name} PRIVATE
    ISOGRASP_SOURCE_DIR="${PROJECT_SOURCE_DIR}"
    ISOGRASP_EXECUTABLE="$<TARGET_FILE_DIR:isograsp>/isograsp")
  # Emergency files of tests stay with the build.
  set(environment "XDG_STATE_HOME=${CMAKE_CURRENT_BINARY_DIR}/state")
  set(others "")
  if(ARG_LONG_IF_SANITIZED AND ISOGRASP_SANITIZE)
    list(REMOVE_ITEM ARG_TOGETHER ${ARG_LONG_IF_SANITIZED})
    list(REMOVE_ITEM ARG_REAL_TIME ${ARG_LONG_IF_SANITIZED})
    if(ISOGRASP_LONG_TESTS)
      list(APPEND ARG_TOGETHER ${ARG_LONG_IF_SANITIZED})
    else()
      list(TRANSFORM ARG_LONG_IF_SANITIZED APPEND ".*" OUTPUT_VARIABLE others)
    endif()
  endif()
  foreach(suite ${ARG_TOGETHER} ${ARG_REAL_TIME})
    add_test(NAME ${name}/${suite} COMMAND tests_${name} --gtest_filter=${suite}.*)
    set_tests_properties(${name}/${suite} PROPERTIES
      TIMEOUT 600 ENVIRONMENT "${environment}" FAIL_REGULAR_EXPRESSION "0 tests from 0 test suites")
    if(suite IN_LIST ARG_REAL_TIME)
      # Beside it two others at most: five at a time on two slow processors held up an emulated sensor
      # for so long that its driver took it for one that began anew.
      set_tests_properties(${name}/${suite} PROPERTIES PROCESSORS 3 COST 100)
    endif()
    list(APPEND others "${suite}.*")
  endforeach()
  list(JOIN others ":" others)
  if(ISOGRASP_SANITIZE)
    # Such a process takes as long to begin and to end as many a test: a few of them share the cases.
    # Folders that stand higher in the house take longer and begin first.
    get_property(place GLOBAL PROPERTY ISOGRASP_TEST_PLACE)
    math(EXPR place "0${place} + 1")
    set_property(GLOBAL PROPERTY ISOGRASP_TEST_PLACE ${place})
    foreach(shard RANGE 3)
      add_test(NAME ${name}/shard_${shard} COMMAND tests_${name} --gtest_filter=*-${others})
      set_tests_properties(${name}/shard_${shard} PROPERTIES TIMEOUT 900 COST ${place}
        ENVIRONMENT "${environment};GTEST_TOTAL_SHARDS=4;GTEST_SHARD_INDEX=${shard}")
    endforeach()
    return()
  endif()
  gtest_discover_tests(tests_${name} TEST_PREFIX ${name}/ TEST_FILTER "*-${others}" DISCOVERY_TIMEOUT 60
    PROPERTIES TIMEOUT 300 ENVIRONMENT "${environment}")
endfunction()
