# The code of docs/extending.md and docs/adding-a-test.md, put where the pages say, built and run:
# the program test_extending holds their tests, pliant_extended the laws and tests that they add, and
# runs the commands that stand there. Built without optimisation: what matters is that they build.
function(pliant_test_extending_pages)
  set(new
    src/pliant/material/strain/fibre_strain.h
    src/pliant/material/density/fung_density.h
    src/pliant/material/density/fung_density.cpp
    tests/mechanics/fibre_sheet_test.cpp)
  set(changed
    src/pliant/mechanics/element_potential.cpp
    src/pliant/material/addend/addend_registry.cpp
    docs/schema/material.schema.json
    docs/schema/study.schema.json
    tests/material/strain_measures_test.cpp
    tests/material/density_derivatives_test.cpp
    tests/mechanics/element_potential_test.cpp)
  set(page "${PROJECT_SOURCE_DIR}/docs/extending.md")
  set(script "${PROJECT_SOURCE_DIR}/cmake/ExtractPage.cmake")
  set(out "${PROJECT_BINARY_DIR}/extending")
  list(TRANSFORM changed PREPEND "${PROJECT_SOURCE_DIR}/" OUTPUT_VARIABLE originals)
  set(files ${new} ${changed})
  list(TRANSFORM files PREPEND "${out}/")
  add_custom_command(OUTPUT ${files}
    COMMAND "${CMAKE_COMMAND}" "-DPAGES=${page}" "-DSOURCE=${PROJECT_SOURCE_DIR}" "-DOUT=${out}"
            -P "${script}"
    DEPENDS "${page}" "${script}" ${originals}
    COMMENT "Following docs/extending.md" VERBATIM)
  add_custom_target(extending_pages DEPENDS ${files})

  set(sources ${files})
  list(FILTER sources INCLUDE REGEX "\\.cpp$")
  add_executable(test_extending ${sources} "${out}/src/pliant/material/strain/fibre_strain.h")
  target_include_directories(test_extending PRIVATE "${out}/src" "${CMAKE_CURRENT_SOURCE_DIR}")
  target_compile_definitions(test_extending PRIVATE PLIANT_SOURCE_DIR="${out}")
  target_compile_options(test_extending PRIVATE -O0)
  target_link_libraries(test_extending PRIVATE pliant_options pliant_mechanics GTest::gmock_main)
  gtest_discover_tests(test_extending
    TEST_FILTER "StrainMeasures*:*FungDensity*:*AreAllRegistered*:ElementPotential*:FibreSheet*"
    TEST_PREFIX "ExtendingPage."
    DISCOVERY_MODE PRE_TEST
    DISCOVERY_TIMEOUT 60
    PROPERTIES LABELS fast TIMEOUT 300)

  if(NOT TARGET pliant_app)
    return()
  endif()
  # A registry that the program brings itself takes the place of the library's.
  set(added
    "${out}/src/pliant/material/addend/addend_registry.cpp"
    "${out}/src/pliant/material/density/fung_density.cpp")
  add_executable(pliant_extended "${PROJECT_SOURCE_DIR}/apps/pliant/main.cpp" ${added})
  add_dependencies(pliant_extended extending_pages)
  target_include_directories(pliant_extended PRIVATE "${out}/src")
  target_compile_options(pliant_extended PRIVATE -O0)
  target_link_libraries(pliant_extended PRIVATE pliant_app)
  add_test(NAME ExtendingPage.RunsItsCommands
    COMMAND "${CMAKE_COMMAND}" "-DPAGE=${page}" "-DPROGRAM=$<TARGET_FILE:pliant_extended>"
            "-DOUT=${out}/run"
            "-DEXPECT=stretch.warp.fung.k:29:31,stretch.warp.fung.alpha:11.8:12.2"
            -P "${PROJECT_SOURCE_DIR}/cmake/RunPage.cmake")
  set_tests_properties(ExtendingPage.RunsItsCommands PROPERTIES LABELS fast TIMEOUT 300)
endfunction()
