# SPDX-License-Identifier: GPL-3.0-or-later
# isograsp_module(<folder> SOURCES … [USES <folders>] [PUBLIC_LIBS …] [PRIVATE_LIBS …])
#   one static library per folder, alias isograsp::<folder>.
# isograsp_test(<folder> SOURCES … [USES <folders>] [LIBS …])
#   one GoogleTest program tests_<folder>; every case is its own CTest entry "<folder>/<case>".

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
endif()

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
endfunction()

function(isograsp_test name)
  cmake_parse_arguments(ARG "" "" "SOURCES;USES;LIBS" ${ARGN})
  list(TRANSFORM ARG_USES PREPEND isograsp::)
  add_executable(tests_${name} ${ARG_SOURCES})
  target_include_directories(tests_${name} PRIVATE ${PROJECT_SOURCE_DIR})
  target_link_libraries(tests_${name}
    PRIVATE isograsp_options ${ARG_USES} ${ARG_LIBS} GTest::gtest_main)
  target_compile_definitions(tests_${name} PRIVATE
    ISOGRASP_SOURCE_DIR="${PROJECT_SOURCE_DIR}"
    ISOGRASP_EXECUTABLE="$<TARGET_FILE_DIR:isograsp>/isograsp")
  gtest_discover_tests(tests_${name} TEST_PREFIX ${name}/ PROPERTIES TIMEOUT 300
    DISCOVERY_TIMEOUT 60)
endfunction()
