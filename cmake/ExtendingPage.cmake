# The program test_extending: the code of docs/extending.md, put where the page says, built and run.
# It is built without optimisation: what matters is that it builds.
function(pliant_test_extending_page)
  set(new
    src/pliant/material/strain/fibre_strain.h
    src/pliant/material/density/fung_density.h
    src/pliant/material/density/fung_density.cpp
    tests/mechanics/fibre_sheet_test.cpp)
  set(changed
    src/pliant/mechanics/element_potential.cpp
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
    COMMAND "${CMAKE_COMMAND}" "-DPAGE=${page}" "-DSOURCE=${PROJECT_SOURCE_DIR}" "-DOUT=${out}"
            -P "${script}"
    DEPENDS "${page}" "${script}" ${originals}
    COMMENT "Following docs/extending.md" VERBATIM)

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
endfunction()
