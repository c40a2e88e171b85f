# SPDX-License-Identifier: GPL-3.0-or-later
# Applies `patch` to a copy, in `tree`, of the two files of `source` that it may change.
file(REMOVE_RECURSE ${tree})
file(COPY ${source}/device/family/families.cpp DESTINATION ${tree}/device/family)
file(COPY ${source}/device/CMakeLists.txt DESTINATION ${tree}/device)
execute_process(COMMAND patch --strip=1 --fuzz=0 --batch --input=${patch}
  WORKING_DIRECTORY ${tree} OUTPUT_VARIABLE text ERROR_VARIABLE text RESULT_VARIABLE status)
if(NOT status EQUAL 0)
  message(FATAL_ERROR "${patch} fits no more: what adding a sensor family takes has changed.\n${text}")
endif()
