# pliant_embed_schemas(TARGET): adds the definitions of src/pliant/io/schema_text.h, with the JSON
# schemas of docs/schema as string literals, so that the installed program stands alone. Those of
# studies and labs are put together from src/pliant/study and from the folders of the tests;
# `./dev schemas` brings what docs/schema holds of them up to date.
function(pliant_embed_schemas target)
  file(GLOB files CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/docs/schema/*.schema.json")
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${files})
  set(names "")
  set(cases "")
  foreach(file IN LISTS files)
    cmake_path(GET file STEM name)
    if(name MATCHES "^(study|lab)$")
      _pliant_schema_of_tests(text ${name})
    else()
      file(READ "${file}" text)
    endif()
    string(APPEND names "\"${name}\", ")
    string(APPEND cases "  if (type == \"${name}\") return R\"json(${text})json\";\n")
  endforeach()

  set(source "${PROJECT_BINARY_DIR}/generated/schema_text.cpp")
  file(CONFIGURE OUTPUT "${source}" @ONLY CONTENT [[
// Made by CMake from docs/schema, src/pliant/study and src/pliant/experiment.
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

# The schema of a kind of document (study, lab) whose experiments each test describes in its folder,
# as src/pliant/experiment/FOLDER/TEST.KIND.json.
function(_pliant_schema_of_tests result kind)
  set(base "${PROJECT_SOURCE_DIR}/src/pliant/study/${kind}.schema.json")
  file(GLOB files CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/src/pliant/experiment/*/*.${kind}.json")
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${base} ${files})
  set(names "")
  set(cases "")
  set(fields "")
  set(solids "") # tests of solids, which say so
  foreach(file IN LISTS files)
    cmake_path(GET file STEM test)
    list(APPEND names "\"${test}\"")
    list(APPEND cases "        {\"if\": {\"properties\": {\"type\": {\"const\": \"${test}\"}}, \"required\": [\"type\"]}, \"then\": {\"$ref\": \"#/definitions/${test}\"}}")
    file(READ "${file}" text)
    if(text MATCHES "\"of solids\"")
      list(APPEND solids "\"${test}\"")
    endif()
    string(STRIP "${text}" text)
    string(REPLACE "\n" "\n    " text "${text}")
    string(APPEND fields "    \"${test}\": ${text},\n")
  endforeach()
  list(JOIN names ", " names)
  list(JOIN solids ", " solids)
  list(JOIN cases ",\n" cases)
  file(READ "${base}" text)
  string(REPLACE "@test_names@" "${names}" text "${text}")
  string(REPLACE "@solid_test_names@" "${solids}" text "${text}")
  string(REPLACE "@test_cases@" "${cases}" text "${text}")
  string(REPLACE "@test_fields@,\n" "${fields}" text "${text}")
  set(${result} "${text}" PARENT_SCOPE)
endfunction()

# pliant_embed_templates(TARGET): adds the definition of src/pliant/experiment/template_files.h, with
# the files of src/pliant/experiment/TEST/template and of src/pliant/capture/template as string
# literals.
function(pliant_embed_templates target)
  set(folder "${PROJECT_SOURCE_DIR}/src/pliant")
  file(GLOB files CONFIGURE_DEPENDS "${folder}/experiment/*/template/*" "${folder}/capture/template/*")
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${files})
  set(cases "")
  foreach(file IN LISTS files)
    cmake_path(GET file FILENAME name)
    string(REGEX REPLACE ".*/([^/]+)/template/.*" "\\1" test "${file}")
    file(READ "${file}" text)
    string(APPEND cases
           "  if (test == \"${test}\") files.emplace_back(\"${name}\", R\"text(${text})text\");\n")
  endforeach()

  set(source "${PROJECT_BINARY_DIR}/generated/template_files.cpp")
  file(CONFIGURE OUTPUT "${source}" @ONLY CONTENT [[
// Made by CMake from src/pliant/experiment/*/template and src/pliant/capture/template.
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
