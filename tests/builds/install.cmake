# Install into an empty prefix and move it elsewhere: the programs run there, and programs of somebody else's are built
# against both libraries and run.
include(${CMAKE_CURRENT_LIST_DIR}/run.cmake)

file(REMOVE_RECURSE ${BINARY})
run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${BINARY}/here)
set(prefix ${BINARY}/elsewhere)
file(RENAME ${BINARY}/here ${prefix})

set(question 0,0.8,-3,0,0.8,0 --accuracy 0.5,0.5,0.5,0.002,0.002,0.002)
foreach(program armtol intella adpta)
  run(${prefix}/bin/${program} --version)
  string(REPLACE "armtol (armtol)" "armtol" name "${program} (armtol)")
  if(NOT run_output STREQUAL "${name} ${VERSION}\n")
    message(FATAL_ERROR "${program} --version said ${run_output}")
  endif()
  if(NOT EXISTS ${prefix}/${MANDIR}/man1/${program}.1)
    message(FATAL_ERROR "the manual page of ${program} was not installed")
  endif()
  # with the library in it, a program needs nothing of the prefix
  file(STRINGS ${prefix}/bin/${program} named REGEX "libarmtol[.]so")
  if(named)
    message(FATAL_ERROR "${program} needs ${named} to run")
  endif()
endforeach()
run(${prefix}/bin/armtol puma560 --joints ${question})
set(said "${run_output}")
run(${BUILD}/armtol puma560 --joints ${question})
if(said STREQUAL "" OR NOT said STREQUAL run_output)
  message(FATAL_ERROR "where it was installed armtol said\n${said}but where it was built\n${run_output}")
endif()

# What one minor version promises, another does not.
function(asked_for_version asked)
  execute_process(COMMAND ${CMAKE_COMMAND} -S ${CONSUMER} -B ${BINARY}/asked-${asked} -D CMAKE_PREFIX_PATH=${prefix}
    -D CMAKE_C_COMPILER=${COMPILER} -D CMAKE_C_FLAGS=${FLAGS} -D LANGUAGE=C -D VERSION=${asked}
    RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(result STREQUAL "0" OR NOT output MATCHES "version: ${VERSION}")
    message(FATAL_ERROR "the package was found by one who asked for armtol ${asked}:\n${output}")
  endif()
endfunction()
asked_for_version(${OTHER_VERSION})

set(languages C)
if(CXX_COMPILER)
  list(APPEND languages CXX)
endif()
foreach(language IN LISTS languages)
  set(folder ${BINARY}/consumer-${language})
  run(${CMAKE_COMMAND} -S ${CONSUMER} -B ${folder} -D CMAKE_PREFIX_PATH=${prefix} -D CMAKE_C_COMPILER=${COMPILER}
    -D CMAKE_C_FLAGS=${FLAGS} -D CMAKE_CXX_COMPILER=${CXX_COMPILER} -D CMAKE_CXX_FLAGS=${FLAGS}
    -D LANGUAGE=${language} -D VERSION=${VERSION})
  run(${CMAKE_COMMAND} --build ${folder})
  foreach(consumer consumer consumer_shared)
    run(${folder}/${consumer})
    if(NOT run_output STREQUAL "${VERSION} 32\n")
      message(FATAL_ERROR "${consumer}, in ${language} and built against the installed library, said ${run_output}")
    endif()
  endforeach()
  # the one has the library in it, the other asks for the library of this minor version
  file(STRINGS ${folder}/consumer named REGEX "libarmtol[.]so")
  file(STRINGS ${folder}/consumer_shared named_shared REGEX "libarmtol[.]so[.]${SOVERSION}")
  if(named OR NOT named_shared)
    message(FATAL_ERROR "in ${language} the consumers were linked to '${named}' and '${named_shared}'")
  endif()
endforeach()
