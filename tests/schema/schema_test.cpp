// The JSON schemas of docs/schema agree with the readers of the program: what one accepts, the
// other accepts. A package of Python judges by the schemas, which proves them independently of
// our own code.

#include <algorithm>
#include <filesystem>
#include <optional>
#include <regex>
#include <set>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "pliant/base/quantity.h"
#include "pliant/experiment/registry.h"
#include "pliant/io/schema_text.h"
#include "pliant/io/text_file.h"

#include "schema/added_keys.h"
#include "schema/documents.h"
#include "schema/schema_fixture.h"
#include "schema/schema_judge.h"

namespace pliant::test {
namespace {

using Json = nlohmann::json;

const std::filesystem::path kSource = PLIANT_SOURCE_DIR;

using SlowSchema = Schema;  // hundreds of documents

bool is_input(const NamedDocument& document) {
  const std::string& type = document.document.type;
  return type != "fit" && type != "evaluation" && type != "simulation" && type != "calibration";
}

/// Every property's name in a schema, at any depth.
void collect_properties(const Json& schema, std::set<std::string>& names) {
  if (schema.is_object()) {
    for (const auto& [key, value] : schema.items()) {
      if (key == "properties") {
        for (const auto& [name, property] : value.items()) names.insert(name);
      }
      collect_properties(value, names);
    }
  } else if (schema.is_array()) {
    for (const Json& item : schema) collect_properties(item, names);
  }
}

std::set<std::string> properties_of(const std::string& type) {
  std::set<std::string> names;
  collect_properties(Json::parse(schema_text(type)), names);
  return names;
}

/// The folders of src/pliant whose sources read documents of a type.
std::vector<std::string> folders_of_readers(const std::string& type) {
  if (type == "scene") return {"scene", "io"};
  if (type == "session") return {"measurement", "io"};
  if (type == "dic") return {"capture", "measurement", "io"};
  if (type == "pattern") return {"capture", "io"};
  if (type == "rig") return {"capture", "measurement", "io"};
  if (type == "material") return {"material", "io"};
  return {"study", "experiment", "measurement", "io"};
}

/// The texts in quotes of the readers' sources: every key they can ask for, and more.
std::set<std::string> words_of_readers(const std::string& type) {
  static const std::regex kWord("\"([a-z_.]+)\"");
  static std::map<std::string, std::set<std::string>> known;
  std::set<std::string>& words = known[type];
  if (!words.empty()) return words;
  for (const std::string& folder : folders_of_readers(type)) {
    const std::filesystem::path top = kSource / "src" / "pliant" / folder;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(top)) {
      if (entry.path().extension() != ".cpp") continue;
      const std::string text = read_text_file(entry.path());
      for (std::sregex_iterator word(text.begin(), text.end(), kWord), end; word != end; ++word) {
        words.insert((*word)[1]);
      }
    }
  }
  return words;
}

/// Pointers to every object within a document.
void collect_objects(const Json& value, const Json::json_pointer& at,
                     std::vector<Json::json_pointer>& objects) {
  if (value.is_object()) {
    objects.push_back(at);
    for (const auto& [key, inner] : value.items()) collect_objects(inner, at / key, objects);
  } else if (value.is_array()) {
    for (std::size_t i = 0; i < value.size(); ++i) collect_objects(value[i], at / i, objects);
  }
}

std::vector<Json::json_pointer> objects_of(const Json& document) {
  std::vector<Json::json_pointer> objects;
  collect_objects(document, Json::json_pointer(), objects);
  return objects;
}

/// An object of a document, which has of its experiments no others than that it stands in: it is
/// judged many times.
struct ObjectPlace {
  SchemaCase document;
  Json::json_pointer object;
};

ObjectPlace place_of(const SchemaCase& document, const Json::json_pointer& object) {
  static const std::regex kWithin("/experiments/(\\d+)(.*)");
  std::smatch match;
  const std::string pointer = object.to_string();
  if (!std::regex_match(pointer, match, kWithin)) return {document, object};
  SchemaCase alone = document;
  alone.document["experiments"] =
      Json::array({document.document["experiments"][std::stoul(match[1])]});
  alone.document.erase("fit");  // which names experiments
  return {alone, Json::json_pointer("/experiments/0" + match[2].str())};
}

NamedDocument mutated(const SchemaCase& document, const Json::json_pointer& object,
                      const std::string& key, const std::string& how, Json value) {
  SchemaCase copy = document;
  copy.document[object][key] = std::move(value);
  return {document.type + object.to_string() + "/" + key + " " + how, std::move(copy)};
}

TEST(SchemaText, IsTheTextInDocs) {
  const std::vector<std::string> types = schema_types();
  EXPECT_EQ(types, (std::vector<std::string>{"calibration", "dic", "evaluation", "fit",
                                             "fits-of-models", "lab", "material", "pattern", "rig",
                                             "scene", "session", "simulation", "study"}));
  for (const std::string& type : types) {
    EXPECT_EQ(schema_text(type),
              read_text_file(kSource / "docs" / "schema" / (type + ".schema.json")));
  }
}

/// The types of the experiments of a study or lab.
std::set<std::string> types_of(const Json& document) {
  std::set<std::string> types;
  for (const Json& experiment : document["experiments"]) types.insert(experiment["type"]);
  return types;
}

TEST(SchemaText, KnowsTheTestsOfTheRegistry) {
  std::set<std::string> registered;
  for (const TestType* type : test_types()) registered.emplace(type->name);
  const std::vector<NamedDocument> full = full_documents();
  for (const std::size_t i : {0, 1}) {
    const SchemaCase& document = full[i].document;
    const Json schema = Json::parse(schema_text(document.type));
    const Json& type = schema["definitions"]["experiment"]["properties"]["type"];
    EXPECT_EQ(type["enum"].get<std::set<std::string>>(), registered) << document.type;
    // Their fields are compared where one of each stands; those of solids stand apart.
    std::set<std::string> types = types_of(document.document);
    types.merge(types_of(full[9 + i].document.document));
    EXPECT_EQ(types, registered) << full[i].name;
  }
}

TEST(SchemaText, IsEmptyForAnUnknownType) { EXPECT_TRUE(schema_text("studies").empty()); }

TEST_F(Schema, AcceptsWhatComesWithTheProgram) {
  const std::vector<NamedDocument> documents = shipped_documents();
  EXPECT_GT(documents.size(), 40u) << "those of the pages are among them";
  std::vector<SchemaCase> cases;
  for (const NamedDocument& one : documents) cases.push_back(one.document);
  const auto verdicts = judge_by_schema(cases);
  for (std::size_t i = 0; i < documents.size(); ++i) {
    EXPECT_FALSE(verdicts[i].has_value()) << documents[i].name << ": " << *verdicts[i];
    if (!is_input(documents[i])) continue;
    const auto error = judge_by_reader(documents[i].document, folder_.path());
    EXPECT_FALSE(error.has_value()) << documents[i].name << ": " << *error;
  }
}

// Free texts have keys of their own, which no schema names.
std::set<std::string> keys_written(Json document) {
  for (const char* texts : {"info", "conditions", "fields"}) document.erase(texts);
  std::set<std::string> keys;
  for (const Json::json_pointer& object : objects_of(document)) {
    for (const auto& [key, value] : document[object].items()) keys.insert(key);
  }
  return keys;
}

// One test of both, since a fit of everything is what is written.
TEST(SlowSchemaOfResults, AcceptsWhatTheProgramWritesAndKnowsItsKeysAlone) {
  const std::vector<NamedDocument> documents = written_documents();
  for (const NamedDocument& written : documents) {
    if (is_input(written)) continue;
    std::set<std::string> keys = keys_written(written.document.document);
    const std::string& type = written.document.type;
    if (type == "simulation" || type == "fit" || type == "evaluation") {
      keys.insert("info");
      keys.insert(type == "simulation" ? "fields" : "conditions");
    }
    EXPECT_EQ(keys, properties_of(written.document.type)) << written.name;
  }

  if (!can_judge_schemas())
    GTEST_SKIP() << "needs python3 with fastjsonschema (python3-fastjsonschema)";
  std::vector<SchemaCase> cases;
  for (const NamedDocument& one : documents) cases.push_back(one.document);
  const auto verdicts = judge_by_schema(cases);
  for (std::size_t i = 0; i < documents.size(); ++i) {
    EXPECT_FALSE(verdicts[i].has_value()) << documents[i].name << ": " << *verdicts[i];
  }
}

TEST_F(Schema, RefusesBrokenDocumentsAsTheReadersDo) {
  EXPECT_EQ(expect_agreement(broken_documents()), 0) << "documents that neither refuses";
}

// As an editor judges a study whose files have preambles, which tell the specimen's size.
TEST_F(Schema, LeavesSizesToTheFiles) {
  SchemaCase study = full_documents()[0].document;
  for (const char* size : {"length", "width"}) study.document["experiments"][0].erase(size);
  EXPECT_FALSE(judge_by_schema({study})[0].has_value());
}

TEST_F(SlowSchema, KnowsExactlyTheKeysThatTheReadersAskFor) {
  const std::vector<NamedDocument> all_full = full_documents();
  std::vector<NamedDocument> documents;
  std::vector<std::size_t> first;       // of each full document
  std::vector<AddedKeys> unknown_keys;  // each of which its reader refuses
  for (const NamedDocument& full : all_full) {
    const std::set<std::string> properties = properties_of(full.document.type);
    std::set<std::string> candidates = words_of_readers(full.document.type);
    candidates.insert(properties.begin(), properties.end());
    first.push_back(documents.size());
    documents.push_back(full);
    for (const Json::json_pointer& pointer : objects_of(full.document.document)) {
      const ObjectPlace place = place_of(full.document, pointer);
      const SchemaCase& document = place.document;
      const Json& object = document.document[place.object];
      // A key without value counts as not given: it is refused only where it is not known, and the
      // refusal lists those that are.
      NamedDocument unknown = mutated(document, place.object, "made_up", "added", nullptr);
      const auto refusal = judge_by_reader(unknown.document, folder_.path());
      documents.push_back(std::move(unknown));
      AddedKeys others{document, place.object, {}};
      if (!refusal) {  // any key does
        others.keys.assign(candidates.begin(), candidates.end());
        std::erase_if(others.keys, [&](const std::string& key) { return object.contains(key); });
        documents.push_back(others.together());
        continue;
      }
      const KnownKeys listed(*refusal);
      for (const std::string& key : candidates) {
        if (object.contains(key)) continue;
        const std::optional<bool> is_listed = listed.contain(key);
        if (is_listed == false && !properties.contains(key)) continue;
        NamedDocument added = mutated(document, place.object, key, "added", nullptr);
        const bool known = is_listed && listed.are_keys()
                               ? *is_listed
                               : !judge_by_reader(added.document, folder_.path()).has_value();
        if (known) {
          documents.push_back(std::move(added));
        } else if (properties.contains(key)) {
          others.keys.push_back(key);
        }
      }
      if (!others.keys.empty()) unknown_keys.push_back(std::move(others));
    }
  }
  const std::vector<bool> accepted = accepted_by_both(documents);
  for (std::size_t i = 0; i < all_full.size(); ++i) {
    const auto begin = accepted.begin() + static_cast<std::ptrdiff_t>(first[i]);
    const auto end = i + 1 < first.size()
                         ? accepted.begin() + static_cast<std::ptrdiff_t>(first[i + 1])
                         : accepted.end();
    // The document itself, and keys that can be added to it; few where nearly all stand.
    EXPECT_GT(std::count(begin, end, true), 1) << all_full[i].name;
  }

  std::vector<NamedDocument> together, apart;
  for (const AddedKeys& keys : unknown_keys) together.push_back(keys.together());
  const auto verdicts = schema_verdicts(together);
  for (std::size_t i = 0; i < together.size(); ++i) {
    const AddedKeys& others = unknown_keys[i];
    if (verdicts[i] && others.are_in(*verdicts[i])) continue;
    for (const std::string& key : others.keys) {
      apart.push_back(mutated(others.document, others.object, key, "added", nullptr));
    }
  }
  if (!apart.empty()) expect_agreement(apart);
}

/// Within the components of a sample, which has those of the first.
bool is_of_sample(const Json::json_pointer& object) {
  const std::string place = object.to_string();
  return place.starts_with("/samples/at/") && place.find("/components") != std::string::npos;
}

TEST_F(SlowSchema, AgreesWithTheReadersOnMissingAndMisshapenValues) {
  std::vector<NamedDocument> documents;
  for (const NamedDocument& full : full_documents()) {
    const Json& whole = full.document.document;
    for (const Json::json_pointer& object : objects_of(whole)) {
      const ObjectPlace place = place_of(full.document, object);
      for (const auto& [key, value] : whole[object].items()) {
        // Whether a file tells the size of its specimen, no schema can tell.
        const bool size = key == "length" || key == "width" || key == "defaults";
        const bool may_be_told = full.document.type == "study" && size;
        // Whether a document has what another place in it names, no schema can tell.
        const bool may_be_named =
            (full.document.type == "scene" && object.empty() &&
             (key == "cloth" || key == "solids")) ||
            (full.document.type == "rig" && object.to_string() == "/cameras") ||
            (full.document.type == "material" && whole.contains("limits") && key == "J") ||
            is_of_sample(object);
        const auto with = [&, &key = key](const char* how, Json other) {
          return mutated(place.document, place.object, key, how, std::move(other));
        };
        if (!may_be_told && !may_be_named) {
          NamedDocument dropped = with("dropped", nullptr);
          dropped.document.document[place.object].erase(key);
          documents.push_back(std::move(dropped));
          documents.push_back(with("null", nullptr));
        }
        // Pictures are by the names of cameras.
        if (full.document.type == "rig" && key == "pictures") continue;
        documents.push_back(with("a mapping", {{"made_up", "1 N"}}));
        documents.push_back(with("a list of lists", Json::array({Json::array()})));
        const bool names_part = key == "cloth" || key == "solid" || key == "name";
        if (full.document.type == "scene" && names_part) continue;
        // Nor whether a mesh is one, and has what is held.
        if (full.document.type != "scene" && (key == "mesh" || key == "fixed" || key == "moved")) {
          continue;
        }
        // The name of a file that is there: whether it is one of its kind, no schema can tell.
        const char* file = value == "rubber.json" ? "rubber.json" : "spandex.json";
        documents.push_back(with("a text", file));
      }
    }
  }
  const int accepted = expect_agreement(documents);
  EXPECT_GT(accepted, 50);
  EXPECT_LT(accepted, static_cast<int>(documents.size()) / 2);
}

/// A place in a full document that takes a quantity of one dimension.
struct QuantityPlace {
  std::size_t document;  // of full_documents()
  const char* pointer;
  const char* unit;
};

constexpr QuantityPlace kQuantityPlaces[] = {
    {0, "/conditions/temperature", "degC"},
    {0, "/conditions/humidity", "%"},
    {0, "/density", "gsm"},
    {0, "/experiments/0/length", "mm"},  // above 0
    {0, "/experiments/0/clip_mass", "g"},
    {0, "/experiments/1/pretension", "N"},
    {0, "/experiments/1/compliance", "mm/N"},
    {0, "/experiments/2/transverse_tension", "N/m"},
    {1, "/experiments/1/slack", "mm"},  // from 0
    {1, "/experiments/1/peaks/0", "%"},
    {1, "/experiments/2/peaks/0", "deg"},
    {0, "/experiments/4/noise/moment", "gf cm/cm"},
    {1, "/experiments/3/peaks/0", "1/cm"},
    {1, "/experiments/3/noise/moment", "uN"},
    {3, "/clips/0/mass", "g"},
    {7, "/sample/width", "mm"},
    {7, "/sample/mass", "mg"},
    {7, "/sample/density", "oz/yd^2"},
    {7, "/clips/0/mass", "oz"},
    {7, "/table/edge_x", "in"},
    {3, "/clips/0/cords/2/length", "mm"},
    {3, "/clips/0/cords/2/stiffness", "N/m"},
    {3, "/clips/1/motion/keyframes/0/time", "ms"},
    {3, "/pins/0/motion/keyframes/1/rotate/angle", "deg"},
    {3, "/air/density", "kg/m^3"},
    {3, "/time/tolerance", "uN"},
    {5, "/time/motion_tolerance", "um"},
};

NamedDocument with_quantity(const std::vector<NamedDocument>& full, const QuantityPlace& place,
                            const std::string& text) {
  auto [document, pointer] =
      place_of(full[place.document].document, Json::json_pointer(place.pointer));
  document.document[pointer] = text;
  return {fmt::format("{} = {}", place.pointer, text), std::move(document)};
}

TEST_F(SlowSchema, TakesTheUnitsThatTheReadersTake) {
  std::set<std::string> units{"N m/m", "gf cm/cm",  "gf.cm/cm", "cm⁻¹",      "1_per_cm", "°C",
                              "C",     "℃",         "N_per_m",  "gf_per_cm", "N / m",    "kg/m2",
                              "kg/m²", "kg_per_m2", "µm",       "kg/m3",     "μN",       "°",
                              "ounce", "metre",     "sec",      "MM",        ""};
  for (int d = 0; d <= static_cast<int>(Dimension::fraction); ++d) {
    for (const std::string& unit : units_of(static_cast<Dimension>(d))) units.insert(unit);
  }
  const std::vector<NamedDocument> full = full_documents();
  std::vector<NamedDocument> documents;
  for (const QuantityPlace& place : kQuantityPlaces) {
    for (const std::string& unit : units) {
      documents.push_back(with_quantity(full, place, fmt::format("1 {}", unit)));
    }
  }
  EXPECT_GT(expect_agreement(documents), 40) << "every unit at its place";
}

TEST_F(SlowSchema, TakesTheNumbersThatTheReadersTake) {
  const std::vector<NamedDocument> full = full_documents();
  std::vector<NamedDocument> documents;
  for (const QuantityPlace& place : kQuantityPlaces) {
    for (const char* number : {"1", "+1", "-1", "0", "-1.5", "0.0", ".5", "5.", "1e-3", "1E+3",
                               "1e", "1,5", "", "1 000", "nan", "inf", ".", "--1"}) {
      for (const char* form : {"{} {}", " {}{} ", "{} {} 2"}) {
        const std::string text = fmt::format(fmt::runtime(form), number, place.unit);
        documents.push_back(with_quantity(full, place, text));
      }
    }
    documents.push_back(with_quantity(full, place, "1"));
    documents.push_back(with_quantity(full, place, fmt::format("{} 1", place.unit)));
  }
  EXPECT_GT(expect_agreement(documents), 80) << "the numbers of each place";
}

}  // namespace
}  // namespace pliant::test
