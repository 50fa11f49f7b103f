# The whole project is built for another system by zig's compiler, which brings that system's C library with it: TARGET
# as zig names it, SYSTEM and PROCESSOR as CMake does. Built for this machine (RUNS) it has to write the bytes of
# golden/.
include(${CMAKE_CURRENT_LIST_DIR}/run.cmake)

set(ENV{ZIG_GLOBAL_CACHE_DIR} ${BINARY}/zig-cache)
set(ENV{ZIG_LOCAL_CACHE_DIR} ${BINARY}/zig-cache)

# CMake wants each tool to be one program.
set(cc cc -target ${TARGET})
foreach(tool cc ar ranlib)
  if(NOT DEFINED ${tool})
    set(${tool} ${tool})
  endif()
  list(JOIN ${tool} " " call)
  file(WRITE "${BINARY}/${tool}" "#!/bin/sh\nexec '${ZIG}' ${call} \"$@\"\n")
  file(CHMOD "${BINARY}/${tool}" PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE)
endforeach()

# Unless told otherwise zig has undefined behaviour trapped, by a library of its own. expat is not there for other
# systems.
run(${CMAKE_COMMAND} -S ${SOURCE} -B ${BINARY}/tree
  -D CMAKE_SYSTEM_NAME=${SYSTEM} -D CMAKE_SYSTEM_PROCESSOR=${PROCESSOR}
  -D CMAKE_C_COMPILER=${BINARY}/cc -D CMAKE_AR=${BINARY}/ar -D CMAKE_RANLIB=${BINARY}/ranlib
  -D CMAKE_C_FLAGS=-fno-sanitize=undefined -D ARMTOL_URDF=OFF -D BUILD_TESTING=OFF)
run(${CMAKE_COMMAND} --build ${BINARY}/tree)
foreach(program intella adpta armtol reproduce yield joint-orders)
  if(NOT EXISTS ${BINARY}/tree/${program})
    message(FATAL_ERROR "${program} was not built")
  endif()
endforeach()

if(RUNS)
  run(${CMAKE_COMMAND} -D BUILD=${BINARY}/tree -D SOURCE=${SOURCE} -D OUT=${BINARY}/out
    -P ${CMAKE_CURRENT_LIST_DIR}/golden.cmake)
endif()
