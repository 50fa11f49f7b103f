# What the programs of the build tree BUILD write into OUT has to be golden/, byte for byte.
include(${CMAKE_CURRENT_LIST_DIR}/run.cmake)

file(REMOVE_RECURSE ${OUT})
run(${BUILD}/reproduce --quiet ${BUILD} ${SOURCE}/golden/published.tsv ${OUT})
run(${SOURCE}/tests/machines/answers ${BUILD}/armtol ${SOURCE}/golden/armtol ${OUT}/armtol)

file(GLOB_RECURSE files RELATIVE ${OUT} ${OUT}/*)
file(GLOB_RECURSE golden RELATIVE ${SOURCE}/golden
  ${SOURCE}/golden/1987/* ${SOURCE}/golden/armtol/* ${SOURCE}/golden/corrected/*)
if(NOT files STREQUAL golden)
  message(FATAL_ERROR "golden/ has the files ${golden}\nbut this build wrote ${files}")
endif()
foreach(file IN LISTS golden)
  run(${CMAKE_COMMAND} -E compare_files ${OUT}/${file} ${SOURCE}/golden/${file})
endforeach()
