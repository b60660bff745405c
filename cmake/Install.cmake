# What `cmake --install` puts where, and the Debian package of it. The program needs none of the
# other files to run: the drawing script of its reports is embedded.

set(documentation "${CMAKE_INSTALL_DATADIR}/doc/pliant")

if(TARGET pliant)
  install(TARGETS pliant RUNTIME DESTINATION "${CMAKE_INSTALL_BINDIR}")
endif()
if(TARGET man_page)
  install(FILES "${PROJECT_BINARY_DIR}/pliant.1" DESTINATION "${CMAKE_INSTALL_MANDIR}/man1")
endif()
install(DIRECTORY materials DESTINATION "${CMAKE_INSTALL_DATADIR}/pliant" OPTIONAL)
install(DIRECTORY docs/ DESTINATION "${documentation}" OPTIONAL)
install(FILES README.md CHANGELOG.md LICENSE DESTINATION "${documentation}" OPTIONAL)
# Also the licence of the drawing library inside the program, which asks to go with it.
install(FILES cmake/debian-copyright DESTINATION "${documentation}" RENAME copyright)

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME pliant)
set(CPACK_PACKAGE_VENDOR "The Pliant authors")
# A reserved domain: whoever publishes packages sets their own address.
set(CPACK_PACKAGE_CONTACT "The Pliant authors <maintainers@pliant.example>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "measures, fits and simulates deformable materials")
set(CPACK_DEBIAN_PACKAGE_DESCRIPTION
  "Turns force-deformation measurements of fabric, rubber and soft tissue into
material models with the uncertainty of every parameter, including the internal
friction that gives cloth its hysteresis, and writes a report to sign.")
set(CPACK_RESOURCE_FILE_LICENSE "${PROJECT_SOURCE_DIR}/LICENSE")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_PRIORITY optional)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
include(CPack)
