# The drawing scripts and the style sheet of the reports: built once from web/ with npm, in a copy in the
# build folder, and embedded in the library `report`, so that the installed program stands alone.

# pliant_embed_report_bundle(TARGET): adds the definition of src/pliant/report/embedded_bundle.h.
function(pliant_embed_report_bundle target)
  set(work "${PROJECT_BINARY_DIR}/web")
  _pliant_web_bundle_files("${work}")
  set(PLIANT_REPORT_SCRIPT "${work}/dist/report.js")
  set(PLIANT_SHEET_SCRIPT "${work}/dist/sheets.js")
  set(PLIANT_REPORT_STYLE "${work}/dist/report.css")
  set(source "${PROJECT_BINARY_DIR}/generated/embedded_bundle.cpp")
  configure_file("${PROJECT_SOURCE_DIR}/cmake/embedded_bundle.cpp.in" "${source}" @ONLY)
  set_source_files_properties("${source}" PROPERTIES
    OBJECT_DEPENDS "${PLIANT_REPORT_SCRIPT};${PLIANT_SHEET_SCRIPT};${PLIANT_REPORT_STYLE}")
  target_sources(${target} PRIVATE "${source}")
endfunction()

# Makes WORK/dist/report.js, sheets.js and report.css: by a build rule, or without npm empty scripts
# and the plain style sheet, with which text and tables read as they should.
function(_pliant_web_bundle_files work)
  find_program(NPM_PROGRAM npm)
  mark_as_advanced(NPM_PROGRAM)
  set(web "${PROJECT_SOURCE_DIR}/web")
  if(NOT PLIANT_WEB OR NOT NPM_PROGRAM OR NOT EXISTS "${web}/package.json")
    if(NOT PLIANT_WEB)
      message(STATUS "Reports without interactive figures: PLIANT_WEB is OFF")
    else()
      message(STATUS "Reports without interactive figures (missing: npm; see packages.txt)")
    endif()
    _pliant_empty_file("${work}/dist/report.js")
    _pliant_empty_file("${work}/dist/sheets.js")
    file(COPY_FILE "${web}/src/report.css" "${work}/dist/report.css" ONLY_IF_DIFFERENT)
    return()
  endif()

  set(script "${PROJECT_SOURCE_DIR}/cmake/build_web_bundle.cmake")
  set(arguments "-DNPM=${NPM_PROGRAM}" "-DWEB=${web}" "-DWORK=${work}")
  add_custom_command(
    OUTPUT "${work}/packages.stamp"
    COMMAND "${CMAKE_COMMAND}" -DSTEP=packages ${arguments} -P "${script}"
    DEPENDS "${web}/package.json" "${web}/package-lock.json" "${script}"
    COMMENT "Installing the npm packages of the report's drawing scripts"
    USES_TERMINAL VERBATIM)

  file(GLOB_RECURSE sources CONFIGURE_DEPENDS "${web}/src/*")
  add_custom_command(
    OUTPUT "${work}/dist/report.js" "${work}/dist/sheets.js" "${work}/dist/report.css"
    COMMAND "${CMAKE_COMMAND}" -DSTEP=bundle ${arguments} -P "${script}"
    DEPENDS "${work}/packages.stamp" "${web}/vite.config.js" ${sources}
    COMMENT "Building the report's drawing scripts"
    VERBATIM)
endfunction()

# Leaves an empty file untouched, so that nothing is rebuilt for it.
function(_pliant_empty_file path)
  if(EXISTS "${path}")
    file(SIZE "${path}" size)
    if(size EQUAL 0)
      return()
    endif()
  endif()
  file(WRITE "${path}" "")
endfunction()
