# pliant_embed_schemas(TARGET): adds the definitions of src/pliant/io/schema_text.h, with the JSON
# schemas of docs/schema as string literals, so that the installed program stands alone.
function(pliant_embed_schemas target)
  set(folder "${PROJECT_SOURCE_DIR}/docs/schema")
  file(GLOB files CONFIGURE_DEPENDS "${folder}/*.schema.json")
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${files})
  set(names "")
  set(cases "")
  foreach(file IN LISTS files)
    cmake_path(GET file STEM name)
    file(READ "${file}" text)
    string(APPEND names "\"${name}\", ")
    string(APPEND cases "  if (type == \"${name}\") return R\"json(${text})json\";\n")
  endforeach()

  set(source "${PROJECT_BINARY_DIR}/generated/schema_text.cpp")
  file(CONFIGURE OUTPUT "${source}" @ONLY CONTENT [[
// Made by CMake from docs/schema.
#include "pliant/io/schema_text.h"

namespace pliant {

std::vector<std::string> schema_types() { return {@names@}; }

std::string_view schema_text(std::string_view type) {
@cases@  return {};
}

}  // namespace pliant
]])
  target_sources(${target} PRIVATE "${source}")
endfunction()

# pliant_embed_templates(TARGET): adds the definition of src/pliant/experiment/template_files.h, with
# the files of src/pliant/experiment/TEST/template as string literals.
function(pliant_embed_templates target)
  set(folder "${PROJECT_SOURCE_DIR}/src/pliant/experiment")
  file(GLOB files CONFIGURE_DEPENDS "${folder}/*/template/*")
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${files})
  set(cases "")
  foreach(file IN LISTS files)
    cmake_path(GET file FILENAME name)
    cmake_path(RELATIVE_PATH file BASE_DIRECTORY "${folder}" OUTPUT_VARIABLE test)
    string(REGEX REPLACE "/.*" "" test "${test}")
    file(READ "${file}" text)
    string(APPEND cases
           "  if (test == \"${test}\") files.emplace_back(\"${name}\", R\"text(${text})text\");\n")
  endforeach()

  set(source "${PROJECT_BINARY_DIR}/generated/template_files.cpp")
  file(CONFIGURE OUTPUT "${source}" @ONLY CONTENT [[
// Made by CMake from src/pliant/experiment/*/template.
#include "pliant/experiment/template_files.h"

namespace pliant {

TestFiles template_files(std::string_view test) {
  TestFiles files;
@cases@  return files;
}

}  // namespace pliant
]])
  target_sources(${target} PRIVATE "${source}")
endfunction()
