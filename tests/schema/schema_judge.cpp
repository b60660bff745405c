#include "schema/schema_judge.h"

#include <cstdlib>

#include <gtest/gtest.h>

#include "pliant/base/errors.h"
#include "pliant/base/number_text.h"
#include "pliant/capture/dic_file.h"
#include "pliant/capture/pattern.h"
#include "pliant/capture/rig_file.h"
#include "pliant/io/schema_text.h"
#include "pliant/material/material_file.h"
#include "pliant/measurement/session/session_document.h"
#include "pliant/scene/scene.h"
#include "pliant/study/study.h"
#include "pliant/study/virtual_lab.h"

#include "io/temporary_folder.h"

namespace pliant::test {
namespace {

using Json = nlohmann::json;

/// The system's own, which knows the packages of Debian, where there are others.
const std::string kPython =
    std::filesystem::exists("/usr/bin/python3") ? "/usr/bin/python3" : "python3";

int run(const std::string& command) { return std::system(command.c_str()); }

Json scalar_of(const Node& node) {
  if (node.quoted) return node.text;
  if (node.text == "true" || node.text == "false") return node.text == "true";
  if (const auto integer = parse_integer(node.text)) return *integer;
  if (const auto number = parse_number(node.text)) return *number;
  return node.text;
}

void read_as(const std::string& type, const Document& document) {
  if (type == "study") {
    study_of(document);
  } else if (type == "lab") {
    lab_of(document);
  } else if (type == "scene") {
    scene_of(document);
  } else if (type == "dic") {
    dic_of(document);
  } else if (type == "pattern") {
    pattern_of(document);
  } else if (type == "rig") {
    rig_of(document);
  } else if (type == "session") {
    session_document_of(document);
  } else {
    material_of(document);
  }
}

}  // namespace

bool can_judge_schemas() {
  return run(kPython + " -c 'import fastjsonschema' >/dev/null 2>&1") == 0;
}

std::vector<std::optional<std::string>> judge_by_schema(const std::vector<SchemaCase>& cases) {
  Json request;
  for (const SchemaCase& one : cases) {
    Json& schema = request["schemas"][one.type];
    if (schema.is_null()) schema = Json::parse(schema_text(one.type));
  }
  request["cases"] = Json::array();
  for (const SchemaCase& one : cases) {
    request["cases"].push_back({{"type", one.type}, {"document", one.document}});
  }
  const TemporaryFolder folder;
  const std::filesystem::path file = folder.write("request.json", request.dump());
  const std::filesystem::path answer = folder.path() / "answer.json";
  const int status = run(kPython + " '" PLIANT_SOURCE_DIR "/tests/schema/validate.py' '" +
                         file.string() + "' > '" + answer.string() + "'");
  std::vector<std::optional<std::string>> verdicts(cases.size());
  EXPECT_EQ(status, 0) << "validate.py failed: see above";
  if (status != 0) return verdicts;
  const Json answers = Json::parse(content_of(answer));
  for (std::size_t i = 0; i < cases.size(); ++i) {
    if (!answers.at(i).is_null()) verdicts[i] = answers.at(i).get<std::string>();
  }
  return verdicts;
}

std::optional<std::string> judge_by_reader(const SchemaCase& document,
                                           const std::filesystem::path& folder) {
  const std::string file = (folder / "judged.json").string();  // which names others beside it
  try {
    read_as(document.type, parse_json(document.document.dump(), file));
  } catch (const InputError& error) {
    return error.what();
  }
  return std::nullopt;
}

Json json_of(const Node& node) {
  switch (node.kind) {
    case Node::Kind::null:
      return nullptr;
    case Node::Kind::scalar:
      return scalar_of(node);
    case Node::Kind::sequence: {
      Json list = Json::array();
      for (const Node& item : node.items) list.push_back(json_of(item));
      return list;
    }
    case Node::Kind::mapping:
      break;
  }
  Json object = Json::object();
  for (const auto& [key, value] : node.fields) object[key] = json_of(value);
  return object;
}

}  // namespace pliant::test
