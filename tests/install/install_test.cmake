# cmake -DBUILD=build-folder -DPREFIX=scratch-folder -DVERSION=x.y.z -DMAN_PAGE=TRUE|FALSE -P this
#
# Installs into an empty folder and runs the program from there.
file(REMOVE_RECURSE "${PREFIX}")
execute_process(COMMAND "${CMAKE_COMMAND}" --install "${BUILD}" --prefix "${PREFIX}"
  OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)

execute_process(COMMAND "${PREFIX}/bin/pliant" --version
  OUTPUT_VARIABLE output COMMAND_ERROR_IS_FATAL ANY)
if(NOT output MATCHES "${VERSION}")
  message(FATAL_ERROR "pliant --version says \"${output}\", not ${VERSION}")
endif()

set(expected share/doc/pliant/LICENSE share/doc/pliant/copyright)
if(MAN_PAGE)
  list(APPEND expected share/man/man1/pliant.1)
endif()
foreach(file IN LISTS expected)
  if(NOT EXISTS "${PREFIX}/${file}")
    message(FATAL_ERROR "not installed: ${file}")
  endif()
endforeach()

file(GLOB materials "${PREFIX}/share/pliant/materials/*.json")
if(NOT materials)
  message(FATAL_ERROR "no materials are installed")
endif()
