# cmake -DPAGES=page.md[,page.md...] -DSOURCE=checkout -DOUT=folder -P ExtractPage.cmake
#
# Does what pages of the documentation tell their reader to do, in a copy below OUT:
# - a block of C++ whose first line is `// PATH` becomes the file OUT/PATH;
# - a block of diff whose first line is `+++ PATH` changes SOURCE/PATH: its lines that start with `-`
#   or a blank must stand there once, those that start with `+` or a blank take their place; `@@`
#   separates places. The result is OUT/PATH.
# Lines are never made a CMake list: C++ is full of semicolons and brackets.
cmake_minimum_required(VERSION 3.25)

file(REMOVE_RECURSE "${OUT}")
set(page "")
string(REPLACE "," ";" PAGES "${PAGES}")
foreach(file IN LISTS PAGES)
  file(READ "${file}" text)
  string(APPEND page "${text}")
endforeach()
set(changed "") # files that OUT holds already

# add_lines(PATH HUNK): HUNK starts with a line end, its lines with a blank or `+`.
function(add_lines path hunk)
  if(path IN_LIST changed)
    file(READ "${OUT}/${path}" text)
  else()
    file(READ "${SOURCE}/${path}" text)
  endif()
  string(REGEX REPLACE "\n\\+[^\n]*" "" old "${hunk}")
  string(REGEX REPLACE "\n[- ]" "\n" old "${old}")
  string(REGEX REPLACE "\n-[^\n]*" "" new "${hunk}")
  string(REGEX REPLACE "\n[+ ]" "\n" new "${new}")
  string(FIND "${text}" "${old}\n" first)
  string(FIND "${text}" "${old}\n" last REVERSE)
  if(first EQUAL -1 OR NOT first EQUAL last)
    message(FATAL_ERROR "${PAGES}: these lines do not stand once in ${path}:${old}")
  endif()
  string(REPLACE "${old}\n" "${new}\n" text "${text}")
  file(WRITE "${OUT}/${path}" "${text}")
endfunction()

while(TRUE)
  string(FIND "${page}" "\n```cpp\n// " cpp)
  string(FIND "${page}" "\n```diff\n+++ " diff)
  if(cpp EQUAL -1 AND diff EQUAL -1)
    break()
  endif()
  if(diff EQUAL -1 OR (NOT cpp EQUAL -1 AND cpp LESS diff))
    set(kind cpp)
    math(EXPR begin "${cpp} + 11")
  else()
    set(kind diff)
    math(EXPR begin "${diff} + 13")
  endif()
  string(SUBSTRING "${page}" ${begin} -1 page)
  string(FIND "${page}" "\n" line_end)
  string(FIND "${page}" "\n```\n" block_end)
  string(SUBSTRING "${page}" 0 ${line_end} path)
  math(EXPR size "${block_end} - ${line_end}")
  string(SUBSTRING "${page}" ${line_end} ${size} block) # starts with a line end
  string(SUBSTRING "${page}" ${block_end} -1 page)

  if(kind STREQUAL "cpp")
    string(SUBSTRING "${block}" 1 -1 block)
    file(WRITE "${OUT}/${path}" "${block}\n")
    continue()
  endif()
  while(NOT block STREQUAL "")
    string(FIND "${block}" "\n@@\n" hunk_end)
    string(SUBSTRING "${block}" 0 ${hunk_end} hunk)
    add_lines("${path}" "${hunk}")
    list(APPEND changed "${path}")
    if(hunk_end EQUAL -1)
      break()
    endif()
    math(EXPR next "${hunk_end} + 3")
    string(SUBSTRING "${block}" ${next} -1 block)
  endwhile()
endwhile()

# The folders that a test lists are those of the checkout with the new files among them.
foreach(folder IN ITEMS src/pliant/material/strain src/pliant/material/density)
  file(GLOB headers RELATIVE "${SOURCE}/${folder}" "${SOURCE}/${folder}/*.h")
  foreach(header IN LISTS headers)
    file(CREATE_LINK "${SOURCE}/${folder}/${header}" "${OUT}/${folder}/${header}" SYMBOLIC)
  endforeach()
endforeach()
