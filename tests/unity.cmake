# The target unity::framework, the test framework Unity, from the first of these that has it:
#
#   1. the folder of -DARMTOL_UNITY_SOURCE=FOLDER, which holds unity.c, unity.h and unity_internals.h;
#   2. an installed package, 2.5.1 or newer (not with -DCMAKE_DISABLE_FIND_PACKAGE_unity=ON);
#   3. the upstream repository, at one pinned commit;
#   4. Debian's source package cjson, which carries Unity in tests/unity.
#
# What is fetched stays in the build tree, and is fetched once. Nothing asks a question, needs root or changes the
# system.

set(ARMTOL_UNITY_SOURCE "" CACHE PATH "Folder with unity.c, unity.h and unity_internals.h")
set(ARMTOL_UNITY_REPOSITORY "https://github.com/ThrowTheSwitch/Unity" CACHE STRING "Where Unity is fetched from")
set(unity_commit cbcd08fa7de711053a3deec6339ee89cad5d2697) # v2.6.1: a tag can be moved

# Not ours to mend: its headers are the system's, and neither warnings nor analysers are asked. Doubles are off by
# default.
function(unity_library folder)
  add_library(armtol_unity STATIC ${folder}/unity.c)
  add_library(unity::framework ALIAS armtol_unity)
  target_include_directories(armtol_unity SYSTEM PUBLIC ${folder})
  target_compile_definitions(armtol_unity PUBLIC UNITY_INCLUDE_DOUBLE)
  target_compile_options(armtol_unity PRIVATE -w)
  set_target_properties(armtol_unity PROPERTIES C_CLANG_TIDY "" C_CPPCHECK "")
  message(STATUS "Unity: ${folder}")
endfunction()

# The output of a command, or the first of what it complained of.
function(unity_run seconds why_var)
  execute_process(COMMAND ${CMAKE_COMMAND} -E env GIT_TERMINAL_PROMPT=0 ${ARGN} TIMEOUT ${seconds}
    WORKING_DIRECTORY ${unity_folder} RESULT_VARIABLE result OUTPUT_QUIET ERROR_VARIABLE errors)
  string(REGEX MATCH "[^\n]+" why "${errors}")
  if(result EQUAL 0)
    set(why "")
  elseif(NOT why)
    set(why "${result}")
  endif()
  set(${why_var} "${why}" PARENT_SCOPE)
endfunction()

# FetchContent gives up the whole configuration where it cannot fetch: so the repository is asked for first.
function(unity_from_upstream source_var why_var)
  find_program(ARMTOL_GIT git NO_CMAKE_SYSTEM_PATH)
  mark_as_advanced(ARMTOL_GIT)
  set(why "no git")
  if(ARMTOL_GIT)
    unity_run(20 why ${ARMTOL_GIT} ls-remote --quiet ${ARMTOL_UNITY_REPOSITORY} HEAD)
  endif()
  if(NOT why)
    include(FetchContent)
    FetchContent_Declare(unity_upstream GIT_REPOSITORY ${ARMTOL_UNITY_REPOSITORY} GIT_TAG ${unity_commit}
      SOURCE_DIR ${unity_folder}/upstream SOURCE_SUBDIR nothing) # its own build would install Unity with the project
    FetchContent_MakeAvailable(unity_upstream)
    set(${source_var} ${unity_upstream_SOURCE_DIR}/src PARENT_SCOPE)
  endif()
  set(${why_var} "${why}" PARENT_SCOPE)
endfunction()

# An apt of our own, which needs no root: its lists and its cache are in the build tree, and its sources are the
# system's with deb-src in the place of deb. Hooks are left out, since some clean the system's cache.
function(unity_write_apt)
  file(MAKE_DIRECTORY ${unity_folder}/state/lists/partial ${unity_folder}/cache/archives/partial
    ${unity_folder}/sources)
  file(WRITE ${unity_folder}/apt.conf
    "Dir::State \"${unity_folder}/state\"; Dir::Cache \"${unity_folder}/cache\";\n"
    "Dir::Etc::SourceList \"/dev/null\"; Dir::Etc::SourceParts \"${unity_folder}/sources\";\n"
    "Acquire::Retries \"0\"; Acquire::http::Timeout \"15\"; Acquire::https::Timeout \"15\";\n"
    "#clear APT::Update::Pre-Invoke;\n#clear APT::Update::Post-Invoke;\n#clear APT::Update::Post-Invoke-Success;\n")
  file(GLOB lists /etc/apt/sources.list /etc/apt/sources.list.d/*.list /etc/apt/sources.list.d/*.sources)
  foreach(list IN LISTS lists)
    file(READ ${list} text)
    string(REGEX REPLACE "(^|\n)(Types:)[^\n]*" "\\1\\2 deb-src" text "${text}")
    string(REGEX REPLACE "(^|\n)deb[ \t]" "\\1deb-src " text "${text}")
    get_filename_component(name ${list} NAME)
    file(WRITE ${unity_folder}/sources/${name} "${text}")
  endforeach()
endfunction()

# An update that fails in part may have brought what is needed: the download decides, and the update has the better
# reason.
function(unity_from_debian source_var why_var)
  find_program(ARMTOL_APT_GET apt-get NO_CMAKE_SYSTEM_PATH)
  mark_as_advanced(ARMTOL_APT_GET)
  if(NOT ARMTOL_APT_GET)
    set(${why_var} "no apt-get" PARENT_SCOPE)
    return()
  endif()
  unity_write_apt()
  set(apt_get ${ARMTOL_APT_GET} -c ${unity_folder}/apt.conf --quiet)
  unity_run(90 update_why ${apt_get} update)
  unity_run(60 why ${apt_get} source --download-only --only-source cjson)
  if(why AND update_why)
    set(why "${update_why}")
  endif()
  file(GLOB archive ${unity_folder}/cjson_*.orig.tar.gz)
  if(NOT why)
    unity_run(60 why ${CMAKE_COMMAND} -E tar xf "${archive}")
  endif()
  file(GLOB source ${unity_folder}/*/tests/unity/src)
  if(NOT why AND NOT source)
    set(why "no tests/unity/src in it")
  endif()
  set(${source_var} "${source}" PARENT_SCOPE)
  set(${why_var} "${why}" PARENT_SCOPE)
endfunction()

function(unity_fetch)
  set(unity_folder ${CMAKE_BINARY_DIR}/unity)
  file(REMOVE_RECURSE ${unity_folder})
  file(MAKE_DIRECTORY ${unity_folder})
  unity_from_upstream(source upstream_why)
  if(upstream_why)
    unity_from_debian(source debian_why)
  endif()
  if(upstream_why AND debian_why)
    message(FATAL_ERROR " The tests need the test framework Unity, which was not to be had. Tried:\n"
      " - an installed package: no unityConfig.cmake of 2.5.1 or newer\n"
      " - ${ARMTOL_UNITY_REPOSITORY}: ${upstream_why}\n"
      " - Debian's source package cjson: ${debian_why}\n"
      " What to do: bring the folder src of ${ARMTOL_UNITY_REPOSITORY} to this machine and configure again with"
      " -DARMTOL_UNITY_SOURCE=FOLDER.")
  endif()
  set(ARMTOL_UNITY_FETCHED ${source} CACHE INTERNAL "Unity as an earlier configuration fetched it")
endfunction()

if(ARMTOL_UNITY_SOURCE)
  unity_library(${ARMTOL_UNITY_SOURCE})
  return()
endif()
find_package(unity 2.5.1 CONFIG QUIET)
if(NOT TARGET unity::framework)
  if(NOT EXISTS "${ARMTOL_UNITY_FETCHED}/unity.c")
    unity_fetch()
  endif()
  unity_library(${ARMTOL_UNITY_FETCHED})
endif()
