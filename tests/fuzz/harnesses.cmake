# The harnesses, one for each thing that reads: ARMTOL_FUZZ_HARNESSES has their names, and
# armtol_fuzz_program(NAME TARGET [SOURCE...]) makes one, driven by libFuzzer or by the given source in its place.
set(ARMTOL_FUZZ_HARNESSES arm_file axes dialogue lists numbers numerics options region tally)
get_target_property(armtol_cli_sources armtol_cli SOURCES)
if(urdf/urdf.c IN_LIST armtol_cli_sources)
  list(APPEND ARMTOL_FUZZ_HARNESSES urdf)
endif()

set(ARMTOL_FUZZ_FOLDER ${CMAKE_CURRENT_LIST_DIR})

function(armtol_fuzz_program name target)
  set(sources fuzz_${name}.c bytes.c caught.c motion.c ../support/random.c)
  list(TRANSFORM sources PREPEND ${ARMTOL_FUZZ_FOLDER}/)
  add_executable(${target} ${sources} ${ARGN})
  target_include_directories(${target} PRIVATE ${ARMTOL_FUZZ_FOLDER}/..)
  target_compile_definitions(${target} PRIVATE _GNU_SOURCE)
  target_link_libraries(${target} PRIVATE armtol_strict armtol_cli armtol_yield armtol_orders)
  if(name STREQUAL "dialogue")
    target_link_options(${target} PRIVATE -Wl,--wrap=isatty,--wrap=outfiles_write)
  endif()
endfunction()
