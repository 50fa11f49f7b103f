# The tarball of `make dist` has the same bytes the next time, and `make run` works in it, without a .git.
include(${CMAKE_CURRENT_LIST_DIR}/run.cmake)

file(REMOVE_RECURSE ${BINARY})
# make started by make is not to take the other's options
set(make ${CMAKE_COMMAND} -E env --unset=MAKEFLAGS --unset=MFLAGS --unset=MAKELEVEL ${MAKE})
set(name armtol-${VERSION})
# from the sources on: a make variable may not have the blanks that a path may have
file(RELATIVE_PATH build ${SOURCE} ${BINARY})
run(${make} -C ${SOURCE} dist BUILD=${build}/one)
set(ENV{TZ} Asia/Tokyo)
# gzip would write down when it was called, in seconds
run(${CMAKE_COMMAND} -E sleep 1.1)
run(${make} -C ${SOURCE} dist BUILD=${build}/other)
run(${CMAKE_COMMAND} -E compare_files ${BINARY}/one/${name}.tar.gz ${BINARY}/other/${name}.tar.gz)

run(${CMAKE_COMMAND} -E tar xzf ${BINARY}/one/${name}.tar.gz WORKING_DIRECTORY ${BINARY})
# the clone around this folder is not to be found
set(ENV{GIT_CEILING_DIRECTORIES} ${BINARY})
run(${make} -C ${BINARY}/${name} run JOBS=2 "CMAKE_FLAGS=-DCMAKE_C_COMPILER=${COMPILER}")
if(NOT run_output MATCHES "66 of 66 published numbers reproduced")
  message(FATAL_ERROR "make run in the tarball printed:\n${run_output}")
endif()
