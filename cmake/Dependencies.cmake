# Third-party packages. None is required here: the folder that uses a missing one is left out, by
# name, in pliant_library(). docs/dependencies.md says what each is for.

find_package(Threads QUIET)
find_package(TBB QUIET)
find_package(PkgConfig QUIET)
find_package(fmt QUIET)
find_package(yaml-cpp QUIET)
find_package(nlohmann_json QUIET)
find_package(OpenSSL QUIET)
find_package(Eigen3 QUIET)
find_package(Boost QUIET) # its headers: Boost.Math
find_package(CLI11 QUIET)
find_package(PNG QUIET)
find_package(TIFF QUIET)
find_package(ZLIB QUIET)
find_package(embree 3 QUIET)
find_package(apriltag QUIET)

# Ceres' own module for SuiteSparse lists every library it finds, QUIET or not.
block(SCOPE_FOR VARIABLES)
  set(CMAKE_MESSAGE_LOG_LEVEL NOTICE)
  find_package(Ceres QUIET)
endblock()

# Optional within src/pliant/geometry. Its configuration talks, QUIET or not.
block(SCOPE_FOR VARIABLES)
  set(CMAKE_MESSAGE_LOG_LEVEL NOTICE)
  find_package(CGAL QUIET)
endblock()

# By name: Debian's OpenCVConfig.cmake comes with all of OpenCV (libopencv-dev), of which three
# modules are wanted here; calib3d is optional within src/pliant/capture.
find_path(OPENCV_INCLUDE_DIR opencv2/imgproc.hpp PATH_SUFFIXES opencv4)
mark_as_advanced(OPENCV_INCLUDE_DIR)
foreach(module IN ITEMS core imgproc calib3d)
  find_library(OPENCV_${module}_LIBRARY opencv_${module})
  mark_as_advanced(OPENCV_${module}_LIBRARY)
  if(OPENCV_INCLUDE_DIR AND OPENCV_${module}_LIBRARY)
    add_library(opencv_${module} UNKNOWN IMPORTED)
    set_target_properties(opencv_${module} PROPERTIES
      IMPORTED_LOCATION "${OPENCV_${module}_LIBRARY}")
    target_include_directories(opencv_${module} SYSTEM INTERFACE "${OPENCV_INCLUDE_DIR}")
  endif()
endforeach()
if(TARGET opencv_calib3d AND TARGET opencv_imgproc)
  target_link_libraries(opencv_calib3d INTERFACE opencv_imgproc opencv_core)
endif()

# By pkg-config: Debian's libzip-config.cmake refuses to load without the zipcmp, zipmerge and
# ziptool programs, which are separate packages that a library user has no need for.
if(PkgConfig_FOUND)
  pkg_check_modules(libzip QUIET IMPORTED_TARGET libzip)
  pkg_check_modules(cairo QUIET IMPORTED_TARGET cairo)
  pkg_check_modules(gdk_pixbuf QUIET IMPORTED_TARGET gdk-pixbuf-2.0)
  pkg_check_modules(orcus QUIET IMPORTED_TARGET liborcus-0.17) # optional within src/pliant/io
  if(TARGET PkgConfig::gdk_pixbuf) # its -pthread would keep precompiled headers out
    set_target_properties(PkgConfig::gdk_pixbuf PROPERTIES INTERFACE_COMPILE_OPTIONS "")
  endif()
endif()
