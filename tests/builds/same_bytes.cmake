# Build the programs with COMPILER and FLAGS and compare what they write with golden/, byte for byte.
include(${CMAKE_CURRENT_LIST_DIR}/run.cmake)

run(${CMAKE_COMMAND} -S ${SOURCE} -B ${BINARY} -D CMAKE_BUILD_TYPE=None -D CMAKE_C_COMPILER=${COMPILER}
  -D CMAKE_C_FLAGS=${FLAGS} -D BUILD_TESTING=OFF)
run(${CMAKE_COMMAND} --build ${BINARY} --target intella adpta armtol_program_any reproduce)
run(${CMAKE_COMMAND} -D BUILD=${BINARY} -D SOURCE=${SOURCE} -D OUT=${BINARY}/out
  -P ${CMAKE_CURRENT_LIST_DIR}/golden.cmake)
