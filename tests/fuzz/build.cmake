# Builds the harnesses with libFuzzer and the sanitizers: -D SOURCE, BINARY, CLANG.
function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT result EQUAL 0)
    message(FATAL_ERROR "${output}")
  endif()
endfunction()

run(${CMAKE_COMMAND} -S ${SOURCE} -B ${BINARY} -D CMAKE_C_COMPILER=${CLANG} -D CMAKE_C_FLAGS=)
run(${CMAKE_COMMAND} --build ${BINARY} --parallel 2)
