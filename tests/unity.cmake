# Provides the target unity::framework, the test framework Unity, or stops the configuration with a
# report of what was tried. Unity is taken from the first of these that has it:
#
#   1. an installed package (2.5 or newer), found by CMake;
#   2. the folder given with -DARMTOL_UNITY_SOURCE=DIR; where one is given, nothing is fetched;
#   3. what an earlier configuration of this build tree fetched;
#   4. the upstream repository, at one pinned commit;
#   5. Debian's source package cjson, which carries a copy of Unity.
#
# Whatever is fetched stays in the build tree, in the folder unity. No step asks a question, needs
# root or changes the system. To pass over an installed package, configure with
# -DCMAKE_DISABLE_FIND_PACKAGE_unity=ON.

set(ARMTOL_UNITY_SOURCE "" CACHE PATH
    "Folder with unity.c, unity.h and unity_internals.h, or with a folder src that holds them")
set(ARMTOL_UNITY_REPOSITORY "https://github.com/ThrowTheSwitch/Unity" CACHE STRING
    "Repository that Unity is fetched from when it is not installed")

# v2.6.1. A commit and not the tag, because a tag can be moved.
set(ARMTOL_UNITY_COMMIT "cbcd08fa7de711053a3deec6339ee89cad5d2697")

# --- the steps ------------------------------------------------------------------------------------
# Each step is called with the names of two variables. It either provides unity::framework and sets
# the first to what is used, or sets the second to a line that says why it could not.

# An installed Unity is the system's own and needs no network. No version is asked for: the package
# of 2.5.0 has no version file, and it exports the target as plain `unity`.
function(unity_from_package used_var why_var)
    find_package(unity CONFIG QUIET)
    if(NOT TARGET unity::framework AND TARGET unity)
        add_library(unity::framework ALIAS unity)
    endif()
    if(TARGET unity::framework)
        if(NOT unity_VERSION)
            set(unity_VERSION "2.5.0 or so")
        endif()
        set(${used_var} "${unity_VERSION}, installed package in ${unity_DIR}" PARENT_SCOPE)
    elseif(unity_FOUND)
        set(${why_var} "installed package: ${unity_DIR} has no target unity::framework" PARENT_SCOPE)
    else()
        set(${why_var} "installed package: no unityConfig.cmake found" PARENT_SCOPE)
    endif()
endfunction()

# A folder that the user names is for machines without a network and for trying another Unity.
function(unity_from_given_folder used_var why_var)
    unity_build("${ARMTOL_UNITY_SOURCE}" version why)
    if(why)
        set(${why_var} "ARMTOL_UNITY_SOURCE: ${why}" PARENT_SCOPE)
    else()
        set(${used_var} "${version}, from ${ARMTOL_UNITY_SOURCE}" PARENT_SCOPE)
    endif()
endfunction()

# A build tree fetches once: configuring again must not depend on the network. The commit is part of
# the folder's name, so that a new pin is not answered with the old one.
function(unity_from_earlier_fetch used_var why_var)
    unity_folders(upstream debian scratch)
    foreach(folder IN ITEMS "${upstream}" "${debian}")
        unity_build("${folder}" version why)
        if(NOT why)
            set(${used_var} "${version}, fetched earlier into ${folder}" PARENT_SCOPE)
            return()
        endif()
    endforeach()
    set(${why_var} "earlier fetch: none in ${CMAKE_BINARY_DIR}/unity" PARENT_SCOPE)
endfunction()

# The upstream repository has the newest Unity, and the pin makes every machine test with the same.
function(unity_from_upstream used_var why_var)
    unity_folders(upstream debian scratch)
    unity_fetch_upstream("${scratch}" why)
    unity_keep("${scratch}" "${upstream}" "${why}" version why)
    if(why)
        set(${why_var} "${ARMTOL_UNITY_REPOSITORY}: ${why}" PARENT_SCOPE)
    else()
        set(${used_var} "${version}, from ${ARMTOL_UNITY_REPOSITORY}" PARENT_SCOPE)
    endif()
endfunction()

# A Debian or Ubuntu machine that reaches its package mirror and nothing else can still run the tests.
function(unity_from_debian used_var why_var)
    unity_folders(upstream debian scratch)
    unity_fetch_debian("${scratch}" found why)
    unity_keep("${found}" "${debian}" "${why}" version why)
    if(why)
        set(${why_var} "Debian's source package cjson: ${why}" PARENT_SCOPE)
    else()
        set(${used_var} "${version}, from Debian's source package cjson" PARENT_SCOPE)
    endif()
endfunction()

# --- folders and the library ----------------------------------------------------------------------

# All the paths in the build tree are named here and nowhere else.
function(unity_folders upstream_var debian_var scratch_var)
    set(top "${CMAKE_BINARY_DIR}/unity")
    set(${upstream_var} "${top}/upstream-${ARMTOL_UNITY_COMMIT}" PARENT_SCOPE)
    set(${debian_var} "${top}/debian-cjson" PARENT_SCOPE)
    set(${scratch_var} "${top}/fetching" PARENT_SCOPE)
endfunction()

# Moves a fetched Unity to its place, once it is whole: an interrupted configuration then leaves
# nothing behind that a later one would take for Unity. What else was fetched is thrown away, and the
# repository's .git too, since `git clean` passes over a folder that has one.
function(unity_keep from to fetch_why version_var why_var)
    set(why "${fetch_why}")
    if(NOT why)
        file(REMOVE_RECURSE "${to}" "${from}/.git")
        file(RENAME "${from}" "${to}")
        unity_build("${to}" version why)
        set(${version_var} "${version}" PARENT_SCOPE)
    endif()
    unity_folders(upstream debian scratch)
    file(REMOVE_RECURSE "${scratch}")
    set(${why_var} "${why}" PARENT_SCOPE)
endfunction()

# Builds unity::framework from a folder, unless something that Unity needs is not there.
function(unity_build folder version_var why_var)
    unity_find_sources("${folder}" source why)
    if(NOT why)
        unity_add_library("${source}")
        unity_version("${source}" version)
        set(${version_var} "${version}" PARENT_SCOPE)
    endif()
    set(${why_var} "${why}" PARENT_SCOPE)
endfunction()

# Unity's own tree keeps its sources in src; a folder that a user has put together may not.
function(unity_find_sources folder source_var why_var)
    set(${why_var} "" PARENT_SCOPE)
    foreach(candidate IN ITEMS "${folder}" "${folder}/src")
        if(EXISTS "${candidate}/unity.c" AND EXISTS "${candidate}/unity.h")
            unity_missing_header("${candidate}" missing)
            if(missing)
                set(${why_var} "${candidate} lacks ${missing}" PARENT_SCOPE)
            endif()
            set(${source_var} "${candidate}" PARENT_SCOPE)
            return()
        endif()
    endforeach()
    set(${why_var} "no unity.c with unity.h in ${folder} or its folder src" PARENT_SCOPE)
endfunction()

# Debian's copy includes ../examples/unity_config.h without being asked to, so it cannot be built
# outside its tree. This is found here and not by the compiler, where the reader would not expect it.
function(unity_missing_header source missing_var)
    set(${missing_var} "" PARENT_SCOPE)
    if(NOT EXISTS "${source}/unity_internals.h")
        set(${missing_var} "unity_internals.h" PARENT_SCOPE)
        return()
    endif()
    file(READ "${source}/unity_internals.h" text)
    if(text MATCHES "\n#include \"(\\.\\./[^\"\n]+)\"")
        if(NOT EXISTS "${source}/${CMAKE_MATCH_1}")
            set(${missing_var} "${CMAKE_MATCH_1}" PARENT_SCOPE)
        endif()
    endif()
endfunction()

# Unity is not ours to mend: it is compiled without warnings, its headers are system headers, and the
# analysers that a developer may have switched on pass it over.
function(unity_add_library source)
    add_library(armtol_unity STATIC "${source}/unity.c")
    add_library(unity::framework ALIAS armtol_unity)
    target_include_directories(armtol_unity SYSTEM PUBLIC "${source}")
    target_compile_options(armtol_unity PRIVATE $<$<NOT:$<C_COMPILER_ID:MSVC>>:-w>)
    set_target_properties(armtol_unity PROPERTIES C_CLANG_TIDY "" C_CPPCHECK "")
endfunction()

# Since 2.5 the header names the version. Before, only a file beside the sources does.
function(unity_version source version_var)
    set(version "")
    file(READ "${source}/unity.h" text)
    foreach(part IN ITEMS MAJOR MINOR BUILD)
        if(text MATCHES "#define UNITY_VERSION_${part} +([0-9]+)")
            list(APPEND version "${CMAKE_MATCH_1}")
        endif()
    endforeach()
    list(JOIN version "." version)
    if(NOT version AND EXISTS "${source}/../release/version.info")
        file(READ "${source}/../release/version.info" text)
        string(STRIP "${text}" version)
    endif()
    if(NOT version)
        set(version "older than 2.5")
    endif()
    set(${version_var} "${version}" PARENT_SCOPE)
endfunction()

# --- the upstream repository ----------------------------------------------------------------------

# Fetches one commit, without history, and makes sure that it is the pinned one. Only the PATH is
# searched for git, as for apt-get below: what the user has taken out of it stays unused.
function(unity_fetch_upstream scratch why_var)
    find_program(ARMTOL_GIT git NO_CMAKE_SYSTEM_PATH)
    mark_as_advanced(ARMTOL_GIT)
    if(NOT ARMTOL_GIT)
        set(${why_var} "not possible, there is no git" PARENT_SCOPE)
        return()
    endif()
    file(REMOVE_RECURSE "${scratch}")
    file(MAKE_DIRECTORY "${scratch}")

    unity_git("${scratch}" 10 output why init --quiet --template= .)
    if(NOT why)
        unity_git("${scratch}" 60 output why
            fetch --quiet --depth 1 "${ARMTOL_UNITY_REPOSITORY}" "${ARMTOL_UNITY_COMMIT}")
    endif()
    if(NOT why)
        unity_git("${scratch}" 30 output why checkout --quiet --detach FETCH_HEAD)
    endif()
    if(NOT why)
        unity_git("${scratch}" 10 output why rev-parse HEAD)
    endif()
    if(NOT why AND NOT output STREQUAL ARMTOL_UNITY_COMMIT)
        set(why "sent commit ${output} and not ${ARMTOL_UNITY_COMMIT}")
    endif()
    set(${why_var} "${why}" PARENT_SCOPE)
endfunction()

# Runs git in the scratch folder, and there only: inside a hook, say, git's variables point at the
# repository being worked on. Nobody is there to answer a prompt for a password.
function(unity_git folder seconds output_var why_var)
    unity_run("${folder}" ${seconds} output why
        "${CMAKE_COMMAND}" -E env
        --unset=GIT_DIR --unset=GIT_WORK_TREE --unset=GIT_INDEX_FILE --unset=GIT_OBJECT_DIRECTORY
        GIT_TERMINAL_PROMPT=0 GIT_ASKPASS= SSH_ASKPASS=
        "${ARMTOL_GIT}" ${ARGN})
    set(${output_var} "${output}" PARENT_SCOPE)
    set(${why_var} "${why}" PARENT_SCOPE)
endfunction()

# --- Debian's source package ----------------------------------------------------------------------

# Downloads and unpacks the source package, and finds Unity in it.
function(unity_fetch_debian scratch found_var why_var)
    find_program(ARMTOL_APT_GET apt-get NO_CMAKE_SYSTEM_PATH)
    mark_as_advanced(ARMTOL_APT_GET)
    if(NOT ARMTOL_APT_GET)
        set(${why_var} "not possible, there is no apt-get" PARENT_SCOPE)
        return()
    endif()
    file(REMOVE_RECURSE "${scratch}")
    unity_write_apt_folder("${scratch}" why)
    if(NOT why)
        unity_download_cjson("${scratch}" why)
    endif()
    if(NOT why)
        unity_unpack_cjson("${scratch}" found why)
    endif()
    set(${found_var} "${found}" PARENT_SCOPE)
    set(${why_var} "${why}" PARENT_SCOPE)
endfunction()

# An apt of our own, beside the system's: its lists, its cache and its sources are in the build tree,
# which is why it needs no root. Proxies and keys are still the system's. The system's hooks are
# cleared, because some of them clean up the system's cache.
function(unity_write_apt_folder scratch why_var)
    set(apt "${scratch}/apt")
    file(MAKE_DIRECTORY "${apt}/state/lists/partial" "${apt}/cache/archives/partial" "${apt}/sources")
    file(WRITE "${apt}/apt.conf"
        "Dir::State \"${apt}/state\";\n"
        "Dir::Cache \"${apt}/cache\";\n"
        "Dir::Etc::SourceList \"/dev/null\";\n"
        "Dir::Etc::SourceParts \"${apt}/sources\";\n"
        "APT::Update::Error-Mode \"any\";\n"
        "Acquire::Retries \"0\";\n"
        "Acquire::http::Timeout \"15\";\n"
        "Acquire::https::Timeout \"15\";\n"
        "#clear APT::Update::Pre-Invoke;\n"
        "#clear APT::Update::Post-Invoke;\n"
        "#clear APT::Update::Post-Invoke-Success;\n")
    unity_write_apt_sources("${apt}/sources" count)
    if(count EQUAL 0)
        set(${why_var} "apt has no source of this Debian or Ubuntu release" PARENT_SCOPE)
    else()
        set(${why_var} "" PARENT_SCOPE)
    endif()
endfunction()

# Copies the machine's sources, changed to the sources of source packages, in both formats.
function(unity_write_apt_sources folder count_var)
    unity_release_names(names)
    set(count 0)
    file(GLOB files /etc/apt/sources.list /etc/apt/sources.list.d/*.list
        /etc/apt/sources.list.d/*.sources)
    foreach(file IN LISTS files)
        file(READ "${file}" text)
        get_filename_component(name "${file}" NAME)
        if(name MATCHES "\\.list$")
            unity_source_lines("${text}" "${names}" text)
        else()
            unity_source_stanzas("${text}" "${names}" text)
        endif()
        if(text)
            file(WRITE "${folder}/${name}" "${text}")
            math(EXPR count "${count} + 1")
        endif()
    endforeach()
    set(${count_var} ${count} PARENT_SCOPE)
endfunction()

# The names by which sources may call the machine's release, as one pattern. A derived distribution
# has a name of its own beside the one it takes most of its packages from.
function(unity_release_names names_var)
    set(names "stable|testing|unstable|sid")
    if(EXISTS /etc/os-release)
        file(STRINGS /etc/os-release lines REGEX "^[A-Z]+_CODENAME=")
        foreach(line IN LISTS lines)
            string(REGEX REPLACE "^[^=]*=\"?([^\"]*)\"?$" "\\1" name "${line}")
            string(APPEND names "|${name}")
        endforeach()
    endif()
    set(${names_var} "${names}" PARENT_SCOPE)
endfunction()

# One-line format: `deb [options] uri suite component...`. Only the lines of the release itself are
# kept. Other vendors' sources and the updates have nothing that is needed here; they would only cost
# time, and errors that are not ours.
function(unity_source_lines text names result_var)
    set(result "")
    while(text MATCHES "^([^\n]*)\n?(.*)$" AND NOT text STREQUAL "")
        set(line "${CMAKE_MATCH_1}")
        set(text "${CMAKE_MATCH_2}")
        if(line MATCHES "^[ \t]*deb(-src)?[ \t]+((\\[[^]]*\\][ \t]+)?[^ \t]+[ \t]+(${names})[ \t].*)$")
            set(entry "deb-src ${CMAKE_MATCH_2}")
            if(entry MATCHES "[ \t](main|universe)([ \t]|$)")
                string(APPEND result "${entry}\n")
            endif()
        endif()
    endwhile()
    set(${result_var} "${result}" PARENT_SCOPE)
endfunction()

# deb822 format: stanzas of `Field: value` lines with an empty line between them. The same choice is
# made as with lines, and a stanza is otherwise kept as it is, with its options and its key.
function(unity_source_stanzas text names result_var)
    set(result "")
    string(REGEX REPLACE "\n([ \t]*\n)+" "\n\n" text "\n${text}\n\n")
    while(text MATCHES "\n\n")
        string(FIND "${text}" "\n\n" end)
        string(SUBSTRING "${text}" 0 ${end} stanza)
        math(EXPR end "${end} + 1")
        string(SUBSTRING "${text}" ${end} -1 text)
        if(stanza MATCHES "\nSuites:([^\n]*[ \t])(${names})([ \t\n]|$)"
                AND stanza MATCHES "\nComponents:([^\n]*[ \t])(main|universe)([ \t\n]|$)")
            string(REGEX REPLACE "\nTypes:[^\n]*" "\nTypes: deb-src" stanza "${stanza}")
            string(APPEND result "${stanza}\n")
        endif()
    endwhile()
    set(${result_var} "${result}" PARENT_SCOPE)
endfunction()

# An update that fails in part may still have brought what is needed, so the download decides. What
# the update said is the better reason all the same.
function(unity_download_cjson scratch why_var)
    unity_run("${scratch}" 90 output update_why
        "${ARMTOL_APT_GET}" -c "${scratch}/apt/apt.conf" --quiet update)
    unity_run("${scratch}" 60 output why
        "${ARMTOL_APT_GET}" -c "${scratch}/apt/apt.conf" --quiet
        source --download-only --only-source cjson)
    if(why AND update_why)
        set(why "${update_why}")
    endif()
    set(${why_var} "${why}" PARENT_SCOPE)
endfunction()

# CMake unpacks the archive itself, so neither tar nor Debian's packaging tools are needed.
function(unity_unpack_cjson scratch found_var why_var)
    file(GLOB archive "${scratch}/cjson_*.orig.tar.*")
    list(FILTER archive EXCLUDE REGEX "\\.asc$")
    unity_run("${scratch}" 60 output why "${CMAKE_COMMAND}" -E tar xf "${archive}")
    file(GLOB found LIST_DIRECTORIES true "${scratch}/*/tests/unity")
    if(NOT why AND NOT found)
        set(why "it has no folder tests/unity any more")
    endif()
    set(${found_var} "${found}" PARENT_SCOPE)
    set(${why_var} "${why}" PARENT_SCOPE)
endfunction()

# --- running commands and reporting ---------------------------------------------------------------

# Runs a command with a time limit, and tells in one line why it failed.
function(unity_run folder seconds output_var why_var)
    execute_process(COMMAND ${ARGN}
        WORKING_DIRECTORY "${folder}"
        TIMEOUT ${seconds}
        RESULT_VARIABLE result
        OUTPUT_VARIABLE output OUTPUT_STRIP_TRAILING_WHITESPACE
        ERROR_VARIABLE errors ERROR_STRIP_TRAILING_WHITESPACE)
    set(why "")
    if(result MATCHES "timeout")
        set(why "no answer within ${seconds} seconds")
    elseif(NOT result EQUAL 0)
        unity_first_error("${errors}" "${result}" why)
    endif()
    set(${output_var} "${output}" PARENT_SCOPE)
    set(${why_var} "${why}" PARENT_SCOPE)
endfunction()

# The line that says what is wrong is the first error. What comes before it is progress, and what
# comes after it follows from it.
function(unity_first_error errors result line_var)
    set(line "failed with ${result}")
    if("\n${errors}\n" MATCHES "\n((fatal|error|E|W): [^\n]*)\n" OR "\n${errors}\n" MATCHES "\n([^\n]+)\n")
        set(line "${CMAKE_MATCH_1}")
    endif()
    set(${line_var} "${line}" PARENT_SCOPE)
endfunction()

# Lines that begin with a blank are printed as they are and not filled into a paragraph.
function(unity_give_up notes)
    if(ARMTOL_UNITY_SOURCE)
        set(remedy "name a folder that holds Unity in -DARMTOL_UNITY_SOURCE, or leave that out")
    else()
        set(remedy "bring the folder src of https://github.com/ThrowTheSwitch/Unity to this"
            " machine and configure again with -DARMTOL_UNITY_SOURCE=FOLDER")
        string(CONCAT remedy ${remedy})
    endif()
    message(FATAL_ERROR
        " The tests need the test framework Unity, which was not to be had. Tried:\n"
        "${notes}"
        " What to do: ${remedy}.")
endfunction()

# Tries the steps in turn. It is a function, so that none of its variables reach the tests.
function(armtol_provide_unity)
    set(steps package earlier_fetch upstream debian)
    if(ARMTOL_UNITY_SOURCE)
        set(steps package given_folder)
    endif()
    set(notes "")
    foreach(step IN LISTS steps)
        set(used "")
        set(why "")
        cmake_language(CALL unity_from_${step} used why)
        if(used)
            message(STATUS "Unity ${used}")
            return()
        endif()
        string(APPEND notes " - ${why}\n")
    endforeach()
    unity_give_up("${notes}")
endfunction()

if(NOT TARGET unity::framework)
    armtol_provide_unity()
endif()
