# Build the programs with COMPILER and FLAGS and compare what they write with golden/, byte for byte.
include(${CMAKE_CURRENT_LIST_DIR}/run.cmake)

run(${CMAKE_COMMAND} -S ${SOURCE} -B ${BINARY} -D CMAKE_BUILD_TYPE=None -D CMAKE_C_COMPILER=${COMPILER}
  -D CMAKE_C_FLAGS=${FLAGS} -D BUILD_TESTING=OFF)
run(${CMAKE_COMMAND} --build ${BINARY} --target intella adpta armtol_program_any reproduce)

set(out ${BINARY}/out)
file(REMOVE_RECURSE ${out})
run(${BINARY}/reproduce --quiet ${BINARY} ${SOURCE}/golden/published.tsv ${out})
run(${SOURCE}/tests/machines/answers ${BINARY}/armtol ${SOURCE}/golden/armtol ${out}/armtol)

file(GLOB_RECURSE files RELATIVE ${out} ${out}/*)
file(GLOB_RECURSE golden RELATIVE ${SOURCE}/golden
  ${SOURCE}/golden/1987/* ${SOURCE}/golden/armtol/* ${SOURCE}/golden/corrected/*)
if(NOT files STREQUAL golden)
  message(FATAL_ERROR "golden/ has the files ${golden}\nbut this build wrote ${files}")
endif()
foreach(file IN LISTS golden)
  run(${CMAKE_COMMAND} -E compare_files ${out}/${file} ${SOURCE}/golden/${file})
endforeach()
