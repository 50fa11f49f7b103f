# Built twice, in folders of other names and at another time, and installed in other ways, all files are the same: no
# path and no date gets in, not even with what a debugger wants to know.
include(${CMAKE_CURRENT_LIST_DIR}/run.cmake)

set(one ${BINARY}/one)
set(other "${BINARY}/the other")
file(REMOVE_RECURSE ${BINARY})
foreach(place "${one}" "${other}")
  file(COPY ${SOURCE}/.ci ${SOURCE}/CMakeLists.txt ${SOURCE}/Makefile ${SOURCE}/docs ${SOURCE}/include ${SOURCE}/legacy
    ${SOURCE}/src DESTINATION "${place}")
  file(COPY ${SOURCE}/tests/bench DESTINATION "${place}/tests")
endforeach()

# As the README has it, with DESTDIR and PREFIX.
run(${CMAKE_COMMAND} -E env --unset=MAKEFLAGS --unset=MFLAGS --unset=MAKELEVEL
  ${MAKE} -C ${one} install JOBS=2 "CMAKE_FLAGS=-DCMAKE_C_COMPILER=${COMPILER} -DCMAKE_C_FLAGS=-g"
  "DESTDIR=${BINARY}/dest dir" PREFIX=/opt/armtol)
set(one_prefix "${BINARY}/dest dir/opt/armtol")

# By CMake alone, the build tree outside the sources.
set(ENV{TZ} Asia/Tokyo)
set(other_prefix "${BINARY}/prefix")
set(tree ${BINARY}/tree)
run(${CMAKE_COMMAND} -S "${other}" -B ${tree} -D CMAKE_C_COMPILER=${COMPILER} -D CMAKE_C_FLAGS=-g)
run(${CMAKE_COMMAND} --build ${tree} --target armtol armtol_shared intella adpta armtol_program_any)
run(${CMAKE_COMMAND} --install ${tree} --prefix "${other_prefix}")

file(GLOB_RECURSE installed RELATIVE "${one_prefix}" "${one_prefix}/*")
file(GLOB_RECURSE installed_other RELATIVE "${other_prefix}" "${other_prefix}/*")
list(LENGTH installed count)
if(NOT installed STREQUAL installed_other OR count LESS 35)
  message(FATAL_ERROR "installed were ${installed}\nand the other time ${installed_other}")
endif()
foreach(file IN LISTS installed)
  execute_process(COMMAND ${CMAKE_COMMAND} -E compare_files "${one_prefix}/${file}" "${other_prefix}/${file}"
    RESULT_VARIABLE differs OUTPUT_QUIET ERROR_QUIET)
  file(STRINGS "${one_prefix}/${file}" paths REGEX "${BINARY}")
  if(differs OR paths)
    message(SEND_ERROR "${file} differs from one build to the other or has a path in it: ${paths}")
  endif()
endforeach()
message(STATUS "${count} files are the same")
