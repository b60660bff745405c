# pliant.1, made from `pliant --help` so that it cannot differ from the program.
find_program(HELP2MAN_PROGRAM help2man)
mark_as_advanced(HELP2MAN_PROGRAM)
if(NOT HELP2MAN_PROGRAM)
  message(STATUS "Left out: the man page (missing: help2man)")
  return()
endif()

add_custom_command(
  OUTPUT "${PROJECT_BINARY_DIR}/pliant.1"
  COMMAND "${HELP2MAN_PROGRAM}" --no-info --section=1
          "--name=measure, fit and simulate deformable materials"
          "--version-string=${PROJECT_VERSION}" "--output=${PROJECT_BINARY_DIR}/pliant.1"
          "$<TARGET_FILE:pliant>"
  DEPENDS pliant
  COMMENT "Making the man page from pliant --help"
  VERBATIM)
add_custom_target(man_page ALL DEPENDS "${PROJECT_BINARY_DIR}/pliant.1")
