# Every erratum that --list-errata shows has a row in the table of PAGE and a section in BOOK, and these have no other.
cmake_minimum_required(VERSION 3.20)
include(${CMAKE_CURRENT_LIST_DIR}/run.cmake)

run(${PROGRAM} --list-errata)
string(REGEX MATCHALL "\n[a-z0-9-]+ " listed "\n${run_output}")
list(TRANSFORM listed REPLACE "\n(.*) " "\\1")
list(LENGTH listed count)
if(count LESS 10)
  message(FATAL_ERROR "${PROGRAM} --list-errata lists ${count}:\n${run_output}")
endif()

# FILE has them in this order, each behind BEGIN and before END.
function(check_page file begin end)
  file(READ ${file} page)
  string(REGEX MATCHALL "\n${begin}[a-z0-9]+(-[a-z0-9]+)*${end}" found "${page}")
  list(TRANSFORM found REPLACE "\n${begin}(.*)${end}" "\\1")
  if(NOT found STREQUAL listed)
    message(SEND_ERROR "${file} has\n  ${found}\nand ${PROGRAM} --list-errata\n  ${listed}")
  endif()
endfunction()

check_page(${PAGE} "[|] `" "` [|]")
check_page(${BOOK} "## " "\n")
