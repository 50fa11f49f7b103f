# A few seconds of libFuzzer, from the same start each time: -D PROGRAM, SECONDS, CORPUS, HARNESS. What it finds stays
# in the folder of the corpus.
set(kept ${CMAKE_CURRENT_LIST_DIR}/seeds/${HARNESS})
if(EXISTS ${CMAKE_CURRENT_LIST_DIR}/findings/${HARNESS})
  list(APPEND kept ${CMAKE_CURRENT_LIST_DIR}/findings/${HARNESS})
endif()
if(EXISTS ${CMAKE_CURRENT_LIST_DIR}/dictionaries/${HARNESS}.dict)
  set(dictionary -dict=${CMAKE_CURRENT_LIST_DIR}/dictionaries/${HARNESS}.dict)
endif()
file(REMOVE_RECURSE ${CORPUS})
file(MAKE_DIRECTORY ${CORPUS}/new)
execute_process(
  COMMAND ${PROGRAM} -seed=1987 -max_total_time=${SECONDS} -max_len=2048 -timeout=20 -print_final_stats=1
    -artifact_prefix=${CORPUS}/ ${dictionary} ${CORPUS}/new ${kept}
  RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
if(NOT result EQUAL 0)
  message(FATAL_ERROR "${output}")
endif()
string(REGEX MATCH "stat::number_of_executed_units: *([0-9]+)" executions "${output}")
if(NOT CMAKE_MATCH_1)
  message(FATAL_ERROR "no input was run:\n${output}")
endif()
message(STATUS "${CMAKE_MATCH_1} inputs")
