# Built where expat is not to be found, armtol answers for a table of links and says of a URDF what it lacks.
include(${CMAKE_CURRENT_LIST_DIR}/run.cmake)

run(${CMAKE_COMMAND} -S ${SOURCE} -B ${BINARY} -D CMAKE_BUILD_TYPE=None -D CMAKE_C_COMPILER=${COMPILER}
  -D CMAKE_C_FLAGS=${FLAGS} -D BUILD_TESTING=OFF -D CMAKE_DISABLE_FIND_PACKAGE_EXPAT=ON)
run(${CMAKE_COMMAND} --build ${BINARY} --target all)

set(question --joints 0,0.8,-3,0,0.8,0 --accuracy 0.5,0.5,0.5,0.002,0.002,0.002 --csv)
run(${BINARY}/armtol puma560 ${question})
set(of_name "${run_output}")
run(${BINARY}/armtol puma560 --show)
file(WRITE ${BINARY}/puma.csv "${run_output}")
run(${BINARY}/armtol ${BINARY}/puma.csv ${question})
if(NOT run_output STREQUAL of_name)
  message(FATAL_ERROR "asked by name armtol said\n${of_name}but for the table of the same arm\n${run_output}")
endif()

file(WRITE ${BINARY}/robot.urdf "<robot name=\"r\"><link name=\"base\"/></robot>\n")
execute_process(COMMAND ${BINARY}/armtol ${BINARY}/robot.urdf ${question}
  RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE error)
if(NOT result MATCHES "^[12]$" OR NOT output STREQUAL ""
   OR NOT error MATCHES "^armtol: [^\n]*expat[^\n]*install[^\n]*\n$")
  message(FATAL_ERROR "for a URDF armtol ended with ${result} and said\n${output}${error}")
endif()
