# pliant_library(NAME [TEXT] [DEPENDS folder...] [PACKAGES imported-target...]
#                [OWN_PACKAGES imported-target...])
#
# Makes the static library pliant_NAME of the sources below src/pliant/NAME, linked to the libraries of
# the folders in DEPENDS and to third-party targets; those of OWN_PACKAGES appear in its .cpp files
# alone. If a package, or a folder it depends on, is
# missing, the folder is left out with a message that names what is missing. Targets of later
# folders test `if(TARGET pliant_NAME)`. TEXT: it reads, writes and tells more than it computes.
function(pliant_library name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "TEXT" "" "DEPENDS;PACKAGES;OWN_PACKAGES")
  set(folder "${PROJECT_SOURCE_DIR}/src/pliant/${name}")
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS "${folder}/*.cpp")
  file(GLOB_RECURSE headers CONFIGURE_DEPENDS "${folder}/*.h")
  if(NOT sources AND NOT headers)
    return()
  endif()

  list(TRANSFORM arg_DEPENDS PREPEND pliant_ OUTPUT_VARIABLE libraries)
  set(missing "")
  foreach(target IN LISTS libraries arg_PACKAGES arg_OWN_PACKAGES)
    if(NOT TARGET ${target})
      list(APPEND missing ${target})
    endif()
  endforeach()
  if(missing)
    list(JOIN missing ", " missing)
    message(STATUS "Left out: src/pliant/${name} (missing: ${missing}; see packages.txt)")
    return()
  endif()

  if(sources)
    add_library(pliant_${name} STATIC ${sources} ${headers})
    target_link_libraries(pliant_${name} PUBLIC pliant_options ${libraries} ${arg_PACKAGES})
    target_link_libraries(pliant_${name} PRIVATE ${arg_OWN_PACKAGES})
    if(arg_TEXT)
      target_compile_options(pliant_${name} PRIVATE ${PLIANT_LITTLE_OPTIMISED})
      pliant_fast_build(pliant_${name} pliant_text_headers)
    else()
      pliant_fast_build(pliant_${name} pliant_library_headers)
    endif()
  else()
    add_library(pliant_${name} INTERFACE)
    target_link_libraries(pliant_${name} INTERFACE pliant_options ${libraries} ${arg_PACKAGES})
  endif()
  set_property(GLOBAL APPEND PROPERTY PLIANT_LIBRARIES pliant_${name})
endfunction()

# Every library that was not left out, for programs that may use all of them.
function(pliant_all_libraries result)
  get_property(libraries GLOBAL PROPERTY PLIANT_LIBRARIES)
  set(${result} ${libraries} PARENT_SCOPE)
endfunction()
