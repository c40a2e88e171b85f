# SPDX-License-Identifier: GPL-3.0-or-later
# Applies `patch` to a copy, in `tree`, of the `files` of `source` that it may change.
file(REMOVE_RECURSE ${tree})
foreach(file ${files})
  get_filename_component(folder ${file} DIRECTORY)
  file(COPY ${source}/${file} DESTINATION ${tree}/${folder})
endforeach()
execute_process(COMMAND patch --strip=1 --fuzz=0 --batch --input=${patch}
  WORKING_DIRECTORY ${tree} OUTPUT_VARIABLE text ERROR_VARIABLE text RESULT_VARIABLE status)
if(NOT status EQUAL 0)
  message(FATAL_ERROR "${patch} fits no more: what such an addition takes has changed.\n${text}")
endif()
