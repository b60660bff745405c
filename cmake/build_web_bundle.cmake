# cmake -DSTEP=packages|bundle -DNPM=program -DWEB=source-folder -DWORK=build-folder -P this
#
# Works on a copy of web/ so that the source tree stays clean. When npm fails (a machine without
# network), the scripts are empty and the build goes on: reports then show tables and text, and say
# that this build draws no figures.

function(run_npm result)
  execute_process(COMMAND "${NPM}" ${ARGN} WORKING_DIRECTORY "${WORK}"
    RESULT_VARIABLE status OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT status EQUAL 0)
    list(JOIN ARGN " " command)
    message("${output}")
    message("WARNING: `npm ${command}` failed (above); reports will have no interactive figures.\n"
      "To try again: delete ${WORK} and build.")
  endif()
  set(${result} ${status} PARENT_SCOPE)
endfunction()

function(install_packages)
  file(REMOVE_RECURSE "${WORK}/node_modules")
  file(COPY "${WEB}/package.json" "${WEB}/package-lock.json" DESTINATION "${WORK}")
  # No package needs its installation script; not running any keeps the build predictable.
  run_npm(status ci --ignore-scripts --no-audit --no-fund --no-update-notifier --loglevel=error
    --fetch-retries=1)
  if(NOT status EQUAL 0)
    file(REMOVE_RECURSE "${WORK}/node_modules")
  endif()
  file(TOUCH "${WORK}/packages.stamp")
endfunction()

function(build_bundle)
  file(REMOVE_RECURSE "${WORK}/src" "${WORK}/dist")
  file(COPY "${WEB}/vite.config.js" "${WEB}/src" DESTINATION "${WORK}")
  set(status 1)
  if(EXISTS "${WORK}/node_modules")
    run_npm(status run build)
    foreach(file IN ITEMS report.js sheets.js report.css)
      if(NOT status EQUAL 0 OR NOT EXISTS "${WORK}/dist/${file}")
        message(FATAL_ERROR "`npm run build` in ${WORK} made no dist/${file}")
      endif()
    endforeach()
  endif()
  if(NOT status EQUAL 0)
    file(WRITE "${WORK}/dist/report.js" "")
    file(WRITE "${WORK}/dist/sheets.js" "")
    file(COPY_FILE "${WEB}/src/report.css" "${WORK}/dist/report.css")
  endif()
endfunction()

if(STEP STREQUAL "packages")
  install_packages()
elseif(STEP STREQUAL "bundle")
  build_bundle()
else()
  message(FATAL_ERROR "STEP is packages or bundle")
endif()
