# Several sources are compiled as one (CMake's unity builds), and the headers that most of them read
# are compiled beforehand: those of Eigen, fmt, nlohmann_json and GoogleTest are then read once, and
# what they generate is compiled once for all sources of a group.
#
# Off in the presets `dev` and `fuzz`, and so for `./dev lint`: there each source is compiled by
# itself, which shows the includes it lacks.

# So many at most: more save little, and one edit should not take long to compile.
set(PLIANT_SOURCES_AT_ONCE 16)

# pliant_headers(NAME [PROGRAMS] PACKAGES package... HEADERS header...): a target whose precompiled headers
# libraries, or programs, take over, where the packages are there. Those have the same compiler
# options.
function(pliant_headers name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "PROGRAMS" "" "PACKAGES;HEADERS")
  foreach(package IN LISTS arg_PACKAGES)
    if(NOT PLIANT_FAST_BUILD OR NOT TARGET ${package})
      return()
    endif()
  endforeach()
  set(source "${PROJECT_BINARY_DIR}/generated/${name}.cpp") # a target needs one
  file(CONFIGURE OUTPUT "${source}" CONTENT "int main() { return 0; }\n")
  if(arg_PROGRAMS) # whose code is positioned otherwise than that of libraries
    add_executable(${name} EXCLUDE_FROM_ALL "${source}")
  else()
    add_library(${name} OBJECT "${source}")
  endif()
  target_link_libraries(${name} PRIVATE pliant_options ${arg_PACKAGES})
  list(TRANSFORM arg_HEADERS REPLACE "(.+)" "<\\1>")
  target_precompile_headers(${name} PRIVATE ${arg_HEADERS})
endfunction()

set(PLIANT_COMMON_HEADERS algorithm array cmath filesystem functional map memory optional set
  string vector Eigen/Core Eigen/Geometry fmt/format.h fmt/ranges.h nlohmann/json.hpp)
set(PLIANT_COMMON_PACKAGES fmt::fmt Eigen3::Eigen nlohmann_json::nlohmann_json)
pliant_headers(pliant_library_headers
  PACKAGES ${PLIANT_COMMON_PACKAGES} HEADERS ${PLIANT_COMMON_HEADERS})

# What reads, writes and tells is optimised less than what computes, and so are tests.
set(PLIANT_LITTLE_OPTIMISED $<$<CONFIG:Release>:-O1>)
pliant_headers(pliant_text_headers
  PACKAGES ${PLIANT_COMMON_PACKAGES} HEADERS ${PLIANT_COMMON_HEADERS})
if(TARGET pliant_text_headers)
  target_compile_options(pliant_text_headers PRIVATE ${PLIANT_LITTLE_OPTIMISED})
endif()

# pliant_fast_build(TARGET HEADERS): compiles the sources that TARGET has so far in groups, with
# the precompiled headers of the target HEADERS.
#
# Files may name the helpers in their anonymous namespaces alike. A source goes to the first group
# that has room and shares no such name with it, so nobody needs to think of it. This is decided when
# CMake runs, as it does in every command of `./dev`.
function(pliant_fast_build target headers)
  if(NOT PLIANT_FAST_BUILD)
    return()
  endif()
  if(TARGET ${headers})
    target_precompile_headers(${target} REUSE_FROM ${headers})
  endif()
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
  get_target_property(sources ${target} SOURCES)
  list(FILTER sources INCLUDE REGEX "\\.cpp$")
  foreach(source IN LISTS sources)
    _pliant_helper_names(names "${source}")
    set(group 0)
    _pliant_has_place(place "${names}" "${taken_${group}}" "${sources_${group}}")
    while(NOT place)
      math(EXPR group "${group} + 1")
      _pliant_has_place(place "${names}" "${taken_${group}}" "${sources_${group}}")
    endwhile()
    list(APPEND taken_${group} ${names})
    list(APPEND sources_${group} "${source}")
    set_source_files_properties("${source}" PROPERTIES UNITY_GROUP ${group})
  endforeach()
endfunction()

# Whether a group of sources takes one more with these helpers.
function(_pliant_has_place result names taken sources)
  list(LENGTH sources count)
  set(place TRUE)
  if(count GREATER_EQUAL PLIANT_SOURCES_AT_ONCE)
    set(place FALSE)
  endif()
  foreach(name IN LISTS names)
    if(name IN_LIST taken)
      set(place FALSE)
    endif()
  endforeach()
  set(${result} ${place} PARENT_SCOPE)
endfunction()

# The types, functions and constants that a source defines in its anonymous namespace, told by the
# beginning of the lines that are not indented.
function(_pliant_helper_names result source)
  file(READ "${source}" text)
  set(names "")
  string(FIND "${text}" "\nnamespace {\n" begin)
  string(FIND "${text}" "\n}  // namespace\n" end REVERSE)
  if(begin GREATER -1 AND begin LESS end)
    math(EXPR begin "${begin} + 12")
    math(EXPR size "${end} - ${begin}")
    string(SUBSTRING "${text}" ${begin} ${size} text)
    string(REGEX MATCHALL "\n[A-Za-z][A-Za-z0-9_:<>,&* ]*" lines "${text}")
    foreach(line IN LISTS lines)
      if(line MATCHES "^\n(struct|class|enum class|enum|using) ([A-Za-z0-9_]+)( |$)")
        list(APPEND names "${CMAKE_MATCH_2}")
      elseif(NOT line MATCHES "^\n(using|template) " AND line MATCHES "[^:]([a-z][A-Za-z0-9_]*) *$")
        list(APPEND names "${CMAKE_MATCH_1}")
      endif()
    endforeach()
    string(REGEX MATCHALL ", k[A-Z][A-Za-z0-9]* =" others "${text}")
    list(TRANSFORM others REPLACE "^, | =$" "")
    list(APPEND names ${others})
  endif()
  list(REMOVE_ITEM names namespace)
  list(REMOVE_DUPLICATES names)
  set(${result} "${names}" PARENT_SCOPE)
endfunction()
