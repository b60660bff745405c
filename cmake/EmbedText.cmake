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
