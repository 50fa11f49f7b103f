# Install into an empty prefix, build docs/example against it by every one of WAYS, move the prefix and do so again: the
# program has to say the same each time.
include(${CMAKE_CURRENT_LIST_DIR}/run.cmake)

function(build_by_cmake prefix folder)
  run(${CMAKE_COMMAND} -S ${EXAMPLE} -B ${folder} -D CMAKE_PREFIX_PATH=${prefix} -D CMAKE_C_COMPILER=${COMPILER}
    -D CMAKE_C_FLAGS=${FLAGS})
  run(${CMAKE_COMMAND} --build ${folder})
endfunction()

# compile_by_pkg_config(PREFIX FOLDER LIBRARIES [FLAG...]): what pkg-config says for LIBRARIES, with FLAGs of the
# compiler
function(compile_by_pkg_config prefix folder libraries)
  set(ENV{PKG_CONFIG_PATH} ${prefix}/${LIBDIR}/pkgconfig)
  run(${PKG_CONFIG} --modversion armtol)
  if(NOT run_output STREQUAL "${VERSION}\n")
    message(FATAL_ERROR "pkg-config --modversion armtol said ${run_output}")
  endif()
  run(${PKG_CONFIG} --cflags ${libraries} armtol)
  separate_arguments(flags UNIX_COMMAND "${FLAGS} ${run_output}")
  file(MAKE_DIRECTORY ${folder})
  run(${COMPILER} ${ARGN} -o ${folder}/tolerances ${EXAMPLE}/tolerances.c ${flags})
endfunction()

# The shared library, which is found when the program runs; a program that is static throughout.
function(build_by_pkg_config prefix folder)
  compile_by_pkg_config(${prefix} ${folder} --libs)
  file(STRINGS ${folder}/tolerances named REGEX "libarmtol[.]so")
  if(NOT named)
    message(FATAL_ERROR "what pkg-config --libs armtol gave is not linked to the shared library")
  endif()
endfunction()

function(build_by_pkg_config_static prefix folder)
  compile_by_pkg_config(${prefix} ${folder} "--static;--libs" -static)
endfunction()

file(REMOVE_RECURSE ${BINARY})
run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${BINARY}/here)
foreach(place here elsewhere)
  if(place STREQUAL "elsewhere")
    file(RENAME ${BINARY}/here ${BINARY}/elsewhere)
  endif()
  foreach(way IN LISTS WAYS)
    set(folder ${BINARY}/${place}-${way})
    cmake_language(CALL build_by_${way} ${BINARY}/${place} ${folder})
    set(ENV{LD_LIBRARY_PATH} "")
    if(way STREQUAL "pkg_config")
      set(ENV{LD_LIBRARY_PATH} ${BINARY}/${place}/${LIBDIR})
    endif()
    run(${folder}/tolerances)
    if(NOT DEFINED said)
      set(said "${run_output}")
    elseif(NOT run_output STREQUAL said)
      message(FATAL_ERROR "first the example said\n${said}but built by ${way} with the prefix ${place}\n${run_output}")
    endif()
  endforeach()
endforeach()

if(NOT said MATCHES "^(link [0-9]+  [a-z]+ +[0-9.]+ (mm|rad)\n)+$")
  message(FATAL_ERROR "the example said\n${said}")
endif()

# What the README shows is the beginning of it.
file(READ ${EXAMPLE}/README.md readme)
string(REGEX MATCHALL "\n    link [^\n]*" shown "${readme}")
list(TRANSFORM shown REPLACE "\n    " "")
list(JOIN shown "\n" shown)
string(FIND "${said}" "${shown}\n" at)
if(shown STREQUAL "" OR NOT at EQUAL 0)
  message(FATAL_ERROR "the example said\n${said}but its README shows\n${shown}")
endif()
