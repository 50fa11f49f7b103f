# A clone may lie anywhere: in a folder whose path has more than 200 characters, blanks and letters beyond ASCII
# `make run` works, and so do tests that hold what is said against names of files.
include(${CMAKE_CURRENT_LIST_DIR}/run.cmake)

file(REMOVE_RECURSE "${BINARY}")
set(folder "${BINARY}")
string(LENGTH "${folder}" length)
while(length LESS 200)
  string(APPEND folder "/ein Ordner mit Wörtern")
  string(LENGTH "${folder}" length)
endwhile()
foreach(part .ci CMakeLists.txt Makefile docs golden include legacy src tests)
  file(COPY ${SOURCE}/${part} DESTINATION "${folder}")
endforeach()

# The test framework that this build tree has fetched, if it has.
if(EXISTS ${BUILD}/unity)
  file(COPY ${BUILD}/unity DESTINATION "${folder}/build")
endif()

set(flags "-DCMAKE_BUILD_TYPE=None -DCMAKE_C_COMPILER=${COMPILER}")
run(${CMAKE_COMMAND} -E env --unset=MAKEFLAGS --unset=MFLAGS --unset=MAKELEVEL
  ${MAKE} -C ${folder} run JOBS=2 "CMAKE_FLAGS=${flags}")
if(NOT run_output MATCHES "\n66 of 66 ")
  message(FATAL_ERROR "make run said\n${run_output}")
endif()

set(tests test_joint_orders_program test_published test_reproduce test_yield test_arm_file test_options
  test_reproduce_memory test_yield_memory)
run(${CMAKE_COMMAND} -S "${folder}" -B "${folder}/build" -D BUILD_TESTING=ON)
run(${CMAKE_COMMAND} --build "${folder}/build" --parallel 2 --target ${tests})
list(JOIN tests "|" names)
run(${CMAKE_CTEST_COMMAND} --test-dir "${folder}/build" --tests-regex "^(${names})$" --output-on-failure
  --no-tests=error)
