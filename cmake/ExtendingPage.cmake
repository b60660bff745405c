# The code of docs/extending.md and docs/adding-a-test.md, put where the pages say, built and run:
# the program test_extending holds their tests, pliant_extended the laws and tests that they add, and
# runs the commands that stand there.
function(pliant_test_extending_pages)
  set(new
    src/pliant/material/strain/fibre_strain.h
    src/pliant/material/density/fung_density.h
    src/pliant/material/density/fung_density.cpp
    src/pliant/experiment/picture_frame/picture_frame.h
    src/pliant/experiment/picture_frame/picture_frame.cpp
    src/pliant/experiment/picture_frame/picture_frame_type.h
    src/pliant/experiment/picture_frame/picture_frame_type.cpp
    tests/mechanics/fibre_sheet_test.cpp)
  set(changed
    src/pliant/mechanics/element_potential.cpp
    src/pliant/material/addend/addend_registry.cpp
    src/pliant/experiment/registry.cpp
    docs/schema/material.schema.json
    src/pliant/study/study.schema.json
    tests/material/strain_measures_test.cpp
    tests/material/density_derivatives_test.cpp
    tests/mechanics/element_potential_test.cpp)
  set(law_page "${PROJECT_SOURCE_DIR}/docs/extending.md")
  set(test_page "${PROJECT_SOURCE_DIR}/docs/adding-a-test.md")
  set(script "${PROJECT_SOURCE_DIR}/cmake/ExtractPage.cmake")
  set(out "${PROJECT_BINARY_DIR}/extending")
  list(TRANSFORM changed PREPEND "${PROJECT_SOURCE_DIR}/" OUTPUT_VARIABLE originals)
  set(files ${new} ${changed})
  list(TRANSFORM files PREPEND "${out}/")
  add_custom_command(OUTPUT ${files}
    COMMAND "${CMAKE_COMMAND}" "-DPAGES=${law_page},${test_page}" "-DSOURCE=${PROJECT_SOURCE_DIR}" "-DOUT=${out}"
            -P "${script}"
    DEPENDS "${law_page}" "${test_page}" "${script}" ${originals}
    COMMENT "Following docs/extending.md and docs/adding-a-test.md" VERBATIM)
  add_custom_target(extending_pages DEPENDS ${files})

  set(sources ${files})
  list(FILTER sources INCLUDE REGEX "\\.cpp$")
  list(FILTER sources EXCLUDE REGEX "/experiment/")
  add_executable(test_extending ${sources} "${out}/src/pliant/material/strain/fibre_strain.h")
  target_include_directories(test_extending PRIVATE "${out}/src" "${CMAKE_CURRENT_SOURCE_DIR}")
  target_compile_definitions(test_extending PRIVATE PLIANT_SOURCE_DIR="${out}")
  target_compile_options(test_extending PRIVATE ${PLIANT_LITTLE_OPTIMISED})
  target_link_libraries(test_extending PRIVATE pliant_options pliant_mechanics GTest::gmock_main)
  if(TARGET pliant_test_headers)
    target_precompile_headers(test_extending REUSE_FROM pliant_test_headers)
  endif()
  gtest_discover_tests(test_extending
    TEST_FILTER "StrainMeasures*:*FungDensity*:*AreAllRegistered*:ElementPotential*:FibreSheet*"
    TEST_PREFIX "ExtendingPage."
    DISCOVERY_MODE PRE_TEST
    DISCOVERY_TIMEOUT 60
    PROPERTIES LABELS fast TIMEOUT 300)

  if(NOT TARGET pliant_app)
    return()
  endif()
  # Registries that the program brings itself take the place of the library's.
  set(added
    "${out}/src/pliant/material/addend/addend_registry.cpp"
    "${out}/src/pliant/material/density/fung_density.cpp"
    "${out}/src/pliant/experiment/registry.cpp"
    "${out}/src/pliant/experiment/picture_frame/picture_frame.cpp"
    "${out}/src/pliant/experiment/picture_frame/picture_frame_type.cpp")
  add_executable(pliant_extended "${PROJECT_SOURCE_DIR}/apps/pliant/main.cpp" ${added})
  add_dependencies(pliant_extended extending_pages)
  target_include_directories(pliant_extended PRIVATE "${out}/src")
  target_compile_options(pliant_extended PRIVATE ${PLIANT_LITTLE_OPTIMISED})
  target_link_libraries(pliant_extended PRIVATE pliant_app)
  pliant_run_page(docs/extending.md pliant_extended
    stretch.warp.fung.k:29:31,stretch.warp.fung.alpha:11.8:12.2)
  pliant_run_page(docs/adding-a-test.md pliant_extended
    shear.friction.a:2.85:3.15,shear.friction.tau:0.028:0.032)
endfunction()
