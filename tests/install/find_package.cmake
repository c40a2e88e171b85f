# SPDX-License-Identifier: GPL-3.0-or-later
# Installs the libraries of `build`, then configures, builds and runs consumer/ against them alone.
set(folder ${build}/tests/install/work)
file(REMOVE_RECURSE ${folder})

function(run)
  execute_process(COMMAND ${ARGN} OUTPUT_VARIABLE text ERROR_VARIABLE text RESULT_VARIABLE status)
  if(NOT status EQUAL 0)
    message(FATAL_ERROR "${ARGN}\n${text}")
  endif()
  set(output "${text}" PARENT_SCOPE)
endfunction()

run(${CMAKE_COMMAND} --install ${build} --prefix ${folder}/prefix --component development)
set(flags "")
if(sanitize)
  set(flags -fsanitize=${sanitize})
endif()
run(${CMAKE_COMMAND} -S ${CMAKE_CURRENT_LIST_DIR}/consumer -B ${folder}/build -G ${generator}
  -D CMAKE_PREFIX_PATH=${folder}/prefix -D CMAKE_BUILD_TYPE=${build_type}
  -D CMAKE_CXX_COMPILER=${compiler} -D CMAKE_CXX_COMPILER_LAUNCHER=${launcher}
  -D CMAKE_CXX_FLAGS=${flags})
run(${CMAKE_COMMAND} --build ${folder}/build)
run(${folder}/build/consumer)
# 1 N on 1 kg for 10 ms, a body moved by 1 m, and what the device reports that this program presses.
set(expected "x = 5e-05 m\nbody at x = 1.000 m\nsim://me?rate=100: thumb 2 N\n")
if(NOT output STREQUAL expected)
  message(FATAL_ERROR "the program printed\n${output}instead of\n${expected}")
endif()

# The package knows its version: one with other interfaces does not pass for it.
file(WRITE ${folder}/wrong/CMakeLists.txt "cmake_minimum_required(VERSION 3.25)
project(Wrong LANGUAGES CXX)
foreach(other 0.1 99)
  find_package(IsoGrasp \${other} QUIET)
  if(IsoGrasp_FOUND)
    message(FATAL_ERROR \"version \${other} was found\")
  endif()
endforeach()
find_package(IsoGrasp ${version} REQUIRED)
")
run(${CMAKE_COMMAND} -S ${folder}/wrong -B ${folder}/wrong/build -G ${generator}
  -D CMAKE_PREFIX_PATH=${folder}/prefix -D CMAKE_CXX_COMPILER=${compiler})
file(REMOVE_RECURSE ${folder})
