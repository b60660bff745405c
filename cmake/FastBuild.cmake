# Several sources are compiled as one (CMake's unity builds): the headers of Eigen, fmt, nlohmann_json
# and GoogleTest are then read, and what they generate is compiled, once for all of them.
#
# Off in the presets `dev` and `fuzz`, and so for `./dev lint`: there each source is compiled by
# itself, which shows the includes it lacks.

# So many at most: more save little, and one edit should not take long to compile.
set(PLIANT_SOURCES_AT_ONCE 16)

# pliant_fast_build(TARGET): compiles the sources that TARGET has so far in groups.
#
# Files may name the helpers in their anonymous namespaces alike. A source goes to the first group
# that has room and shares no such name with it, so nobody needs to think of it. This is decided when
# CMake runs, as it does in every command of `./dev`.
function(pliant_fast_build target)
  if(NOT PLIANT_FAST_BUILD)
    return()
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
