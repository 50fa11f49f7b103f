# cmake -D VALGRIND -D FAULTY -D ARMTOL -D INTELLA -D LEAKING -D INPUT -D URDF -D SCRATCH -P memcheck.cmake
#
# Whole programs, one allocation of which fails, under valgrind: no access to what is not there, no memory lost. That
# the programs keep nothing at all is seen for every allocation by fault_memory; this is also about libc's part of it.

get_filename_component(ARMTOL "${ARMTOL}" REALPATH)
get_filename_component(INTELLA "${INTELLA}" REALPATH)
file(REMOVE_RECURSE "${SCRATCH}")
file(MAKE_DIRECTORY "${SCRATCH}")

# LD_PRELOAD is cut at blanks, which the path may have.
get_filename_component(faulty_folder "${FAULTY}" DIRECTORY)
get_filename_component(faulty_name "${FAULTY}" NAME)

# run(STATUS ALLOCATION PROGRAM ARGUMENT...): the routines of the shared object are not to be valgrind's.
function(run expected allocation program)
  execute_process(
    COMMAND ${CMAKE_COMMAND} -E env LD_PRELOAD=${faulty_name} LD_LIBRARY_PATH=${faulty_folder}
      FAULT_PROGRAM=${program} FAULT_ALLOCATION=${allocation}
      ${VALGRIND} --quiet --error-exitcode=99 --leak-check=full --soname-synonyms=somalloc=nouserintercepts
      ${program} ${ARGN}
    INPUT_FILE "${INPUT}" WORKING_DIRECTORY "${SCRATCH}" RESULT_VARIABLE status OUTPUT_QUIET ERROR_VARIABLE said)
  if(NOT status EQUAL expected)
    message(FATAL_ERROR "${program} ${ARGN}, allocation ${allocation}: expected ${expected}, got ${status}\n${said}")
  endif()
endfunction()

# That this would be seen: a program that loses a block.
get_filename_component(LEAKING "${LEAKING}" REALPATH)
run(99 9999 ${LEAKING})

foreach(allocation 1 5 9)
  run(1 ${allocation} ${INTELLA})
endforeach()
run(0 9999 ${INTELLA})

set(pose --joints 10,-80,70,-60,50,40 --degrees --accuracy .5,.5,.5,.01,.01,.01)
foreach(allocation 1 30 90)
  run(1 ${allocation} ${ARMTOL} ${URDF} --tip tool0 ${pose})
endforeach()
foreach(allocation 8 30)
  run(1 ${allocation} ${ARMTOL} puma560 --joints 0,.8,-1.6,0,.8,0 --accuracy 1,1,1,1,1,1 --verify 9000 --threads 3)
endforeach()
run(0 9999 ${ARMTOL} ${URDF} --tip tool0 ${pose})
