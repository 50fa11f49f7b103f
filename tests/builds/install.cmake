# Install into an empty prefix, run the programs there, build and run a program of somebody else's against it.
include(${CMAKE_CURRENT_LIST_DIR}/run.cmake)

file(REMOVE_RECURSE ${BINARY})
run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${BINARY}/prefix)
foreach(program armtol intella adpta)
  run(${BINARY}/prefix/bin/${program} --version)
  string(REPLACE "armtol (armtol)" "armtol" name "${program} (armtol)")
  if(NOT run_output STREQUAL "${name} ${VERSION}\n")
    message(FATAL_ERROR "${program} --version said ${run_output}")
  endif()
  if(NOT EXISTS ${BINARY}/prefix/${MANDIR}/man1/${program}.1)
    message(FATAL_ERROR "the manual page of ${program} was not installed")
  endif()
endforeach()

run(${CMAKE_COMMAND} -S ${CONSUMER} -B ${BINARY}/consumer -D CMAKE_PREFIX_PATH=${BINARY}/prefix
  -D CMAKE_C_COMPILER=${COMPILER} -D CMAKE_C_FLAGS=${FLAGS} -D VERSION=${VERSION})
run(${CMAKE_COMMAND} --build ${BINARY}/consumer)
run(${BINARY}/consumer/consumer)
if(NOT run_output STREQUAL "${VERSION} 32\n")
  message(FATAL_ERROR "the program built against the installed library said ${run_output}")
endif()
