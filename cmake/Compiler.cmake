# Language, warnings and sanitizers: the same for every target of the project.

if(NOT CMAKE_BUILD_TYPE)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "Build type" FORCE)
endif()

set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)

if(NOT DEFINED CMAKE_COMPILE_WARNING_AS_ERROR)
  set(CMAKE_COMPILE_WARNING_AS_ERROR ON)
endif()

find_program(CCACHE_PROGRAM ccache)
mark_as_advanced(CCACHE_PROGRAM)
if(CCACHE_PROGRAM AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  set(CMAKE_CXX_COMPILER_LAUNCHER "${CCACHE_PROGRAM}")
endif()

# Linked by every library, program and test: warnings and the include root.
add_library(pliant_options INTERFACE)
target_include_directories(pliant_options INTERFACE "${PROJECT_SOURCE_DIR}/src")
target_compile_options(pliant_options INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion)
if(PLIANT_FAST_BUILD)
  # Where sources are compiled as one, a variable that is called like something in another source
  # hides nothing, and an anonymous namespace is not in a header.
  target_compile_options(pliant_options INTERFACE -Wno-shadow)
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    target_compile_options(pliant_options INTERFACE -Wshadow=local -Wno-subobject-linkage)
    if(CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
      # Given for the standard library's own strings, by chance of inlining (GCC bug 105651).
      target_compile_options(pliant_options INTERFACE -Wno-restrict)
    endif()
  endif()
endif()

if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  # GCC's own garbage collection: a tenth of the build's time, to save a fifth of its memory.
  add_compile_options("SHELL:--param ggc-min-expand=1000" "SHELL:--param ggc-min-heapsize=2000000")
endif()

if(PLIANT_SANITIZE)
  # The checks left out take half of the build's time and find what the address sanitizer finds.
  add_compile_options(-fsanitize=${PLIANT_SANITIZE} -fno-sanitize=null,alignment,object-size,vptr
    -fno-sanitize-recover=all -fno-omit-frame-pointer)
  add_link_options(-fsanitize=${PLIANT_SANITIZE})
  # Eigen would pad what it allocates under the address sanitizer. Packaged libraries that carry
  # instances of its templates (Ceres) do not, and the linker mixes theirs with ours.
  add_compile_definitions(EIGEN_MALLOC_ALREADY_ALIGNED=1)
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    # Under the sanitizers g++ 12 gives this warning for the standard library's own <regex>.
    add_compile_options(-Wno-maybe-uninitialized)
  endif()
endif()

if(PLIANT_FUZZ)
  if(NOT CMAKE_CXX_COMPILER_ID MATCHES "Clang")
    message(FATAL_ERROR "PLIANT_FUZZ needs clang: configure with the preset `fuzz`.")
  endif()
  add_compile_options(-fsanitize=fuzzer-no-link)
endif()
