# Every public header can be included alone and twice, in C and, where there is a compiler, in C++; the umbrella has
# all.
include(${CMAKE_CURRENT_LIST_DIR}/run.cmake)

file(REMOVE_RECURSE ${BINARY})
file(MAKE_DIRECTORY ${BINARY})
file(READ ${INCLUDE}/armtol/armtol.h umbrella)
file(GLOB headers RELATIVE ${INCLUDE} ${INCLUDE}/armtol/*.h)
foreach(header IN LISTS headers)
  set(text "#include \"${header}\"\n#include \"${header}\"\nextern int nothing;\n")
  file(WRITE ${BINARY}/alone.c "${text}")
  run(${COMPILER} -std=c99 -Wall -Wextra -pedantic -Werror -I ${INCLUDE} -c ${BINARY}/alone.c -o ${BINARY}/alone.o)
  if(CXX_COMPILER)
    file(WRITE ${BINARY}/alone.cpp "${text}")
    run(${CXX_COMPILER} -std=c++11 -Wall -Wextra -pedantic -Werror -I ${INCLUDE}
      -c ${BINARY}/alone.cpp -o ${BINARY}/alone.o)
  endif()
  if(NOT header STREQUAL "armtol/armtol.h" AND NOT umbrella MATCHES "\n#include \"${header}\"\n")
    message(FATAL_ERROR "armtol/armtol.h does not include ${header}")
  endif()
endforeach()
