#include "pliant/scene/checkpoint.h"

#include <cstring>
#include <variant>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "pliant/base/errors.h"
#include "pliant/base/number_text.h"
#include "pliant/io/digest.h"
#include "pliant/io/document.h"
#include "pliant/io/sealed_file.h"

namespace pliant {
namespace {

using Json = nlohmann::json;

constexpr std::string_view kType = "checkpoint/1";

template <class Array>
Json bytes_of(const Array& array) {
  const auto* first = reinterpret_cast<const std::uint8_t*>(array.data());
  return Json::binary({first, first + sizeof(*array.data()) * static_cast<size_t>(array.size())});
}

// Fills an array of known size; the size is part of what makes the scene.
template <class Array>
void fill(const Json& json, Array& array) {
  const auto& bytes = json.get_binary();
  const size_t size = sizeof(*array.data()) * static_cast<size_t>(array.size());
  if (bytes.size() != size) throw std::length_error("an array of another size");
  if (size > 0) std::memcpy(array.data(), bytes.data(), size);
}

template <class T>
std::vector<T> list_of(const Json& json) {
  const auto& bytes = json.get_binary();
  std::vector<T> list(bytes.size() / sizeof(T));
  fill(json, list);
  return list;
}

Json pose_json(const Pose& pose) {
  return {bytes_of(pose.translation), bytes_of(pose.rotation.coeffs())};
}

Json state_json(const State& state) {
  Json clips = Json::array();
  for (const Pose& pose : state.configuration.clips) clips.push_back(pose_json(pose));
  return {{"time", state.time},
          {"positions", bytes_of(state.configuration.positions)},
          {"clips", clips},
          {"velocities", bytes_of(state.velocities)},
          {"history", bytes_of(state.history)},
          {"last_step", state.last_step},
          {"last_positions", bytes_of(state.last_positions)},
          {"last_velocities", bytes_of(state.last_velocities)}};
}

void fill_state(const Json& json, State& state) {
  state.time = json.at("time");
  fill(json.at("positions"), state.configuration.positions);
  const Json& clips = json.at("clips");
  if (clips.size() != state.configuration.clips.size()) throw std::length_error("other clips");
  for (size_t k = 0; k < clips.size(); ++k) {
    Pose& pose = state.configuration.clips[k];
    fill(clips[k].at(0), pose.translation);
    fill(clips[k].at(1), pose.rotation.coeffs());
  }
  fill(json.at("velocities"), state.velocities);
  fill(json.at("history"), state.history);
  state.last_step = json.at("last_step");
  if (state.last_step == 0) return;
  state.last_positions.resizeLike(state.configuration.positions);
  state.last_velocities.resizeLike(state.configuration.positions);
  fill(json.at("last_positions"), state.last_positions);
  fill(json.at("last_velocities"), state.last_velocities);
}

// @param start  of the same system, whose sizes are right
SimulationState read_state(const Json& json, const State& start) {
  SimulationState state;
  state.state = start;
  state.steps = json.at("steps");
  state.work = json.at("work");
  state.drag = json.at("drag");
  state.rubbing = json.at("rubbing");
  state.outside = json.at("outside");
  fill_state(json.at("state"), state.state);
  state.records.seconds = list_of<double>(json.at("seconds"));
  state.records.costs = list_of<SearchCosts>(json.at("costs"));
  state.records.substeps = list_of<int>(json.at("substeps"));
  state.records.newton_iterations = list_of<int>(json.at("newton_iterations"));
  state.records.linear_iterations = list_of<int>(json.at("linear_iterations"));
  state.records.distances = list_of<double>(json.at("distances"));
  state.records.contacts = list_of<int>(json.at("contacts"));
  state.energies = list_of<EnergyRow>(json.at("energies"));
  state.clips = list_of<ClipRow>(json.at("clips"));
  return state;
}

/// What a document says, whatever its layout and comments.
std::string text_of(const Node& node) {
  std::string text =
      fmt::format("{}{}:{}", static_cast<int>(node.kind), node.text.size(), node.text);
  for (const Node& item : node.items) text += "[" + text_of(item) + "]";
  for (const Node::Field& field : node.fields) {
    text += fmt::format("{{{}:{}{}}}", field.key.size(), field.key, text_of(field.value));
  }
  return text;
}

void remove_duration(Node& scene) {
  for (Node::Field& section : scene.fields) {
    if (section.key != "time") continue;
    std::erase_if(section.value.fields, [](const auto& field) { return field.key == "duration"; });
  }
}

// The file of a list that a scene may also hold itself.
void add_file_of(const IndexList& list, std::vector<std::filesystem::path>& files) {
  if (!list.file.empty()) files.push_back(list.file);
}

void add_file_of(const VertexSelection& selection, std::vector<std::filesystem::path>& files) {
  if (selection.vertices) add_file_of(*selection.vertices, files);
}

// Every file that a scene names, in its order.
std::vector<std::filesystem::path> files_of(const Scene& scene) {
  std::vector<std::filesystem::path> files;
  for (const SceneCloth& cloth : scene.cloth) {
    if (const auto* mesh = std::get_if<FileMesh>(&cloth.mesh.kind)) files.push_back(mesh->file);
    files.push_back(cloth.material.file);
    for (const SceneRegion& region : cloth.regions) {
      files.push_back(region.material.file);
      add_file_of(region.faces, files);
    }
  }
  for (const SceneSolid& solid : scene.solids) {
    if (!solid.mesh.file().empty()) files.push_back(solid.mesh.file());
    files.push_back(solid.material.file);
    for (const SceneSample& sample : solid.samples) files.push_back(sample.material.file);
    for (const SolidRegion& region : solid.regions) files.push_back(region.material.file);
  }
  for (const SceneObstacle& obstacle : scene.obstacles) {
    if (const BodySource* body = obstacle.surface()) {
      files.insert(files.end(), body->files.begin(), body->files.end());
    }
  }
  for (const ScenePin& pin : scene.pins) add_file_of(pin.vertices, files);
  for (const SceneClip& clip : scene.clips) add_file_of(clip.vertices, files);
  return files;
}

constexpr const char* kWritten = "one that `pliant simulate` wrote";

/// What stands behind the first line, undamaged.
Json read_content(const std::filesystem::path& file) {
  return Json::from_cbor(read_sealed(file, kType, "checkpoint", "simulate"));
}

}  // namespace

std::string scene_identity(const Scene& scene, const std::filesystem::path& filler) {
  Node document = read_yaml(scene.file).root;
  remove_duration(document);
  // Of a path of equilibria the duration says the step; friction may be left out of any scene.
  std::string digests =
      sha256_of(text_of(document) + format_number(scene.time.step) + name_of(scene.time.friction));
  for (const std::filesystem::path& file : files_of(scene)) digests += sha256_of_file(file);
  if (!filler.empty()) digests += sha256_of_file(filler);
  return sha256_of(digests);
}

std::string checkpoint_bytes(const SimulationState& state, const std::string& identity) {
  const Json json{{"identity", identity},
                  {"steps", state.steps},
                  {"work", state.work},
                  {"drag", state.drag},
                  {"rubbing", state.rubbing},
                  {"outside", state.outside},
                  {"state", state_json(state.state)},
                  {"seconds", bytes_of(state.records.seconds)},
                  {"costs", bytes_of(state.records.costs)},
                  {"substeps", bytes_of(state.records.substeps)},
                  {"newton_iterations", bytes_of(state.records.newton_iterations)},
                  {"linear_iterations", bytes_of(state.records.linear_iterations)},
                  {"distances", bytes_of(state.records.distances)},
                  {"contacts", bytes_of(state.records.contacts)},
                  {"energies", bytes_of(state.energies)},
                  {"clips", bytes_of(state.clips)}};
  std::string content;
  Json::to_cbor(json, content);
  return sealed_bytes(kType, content);
}

SimulationState read_checkpoint(const std::filesystem::path& file, const Simulation& simulation,
                                const std::string& identity) {
  const Json json = read_content(file);
  if (json.at("identity") != identity) {
    throw InputError({file.string(), 0, ""}, "is a checkpoint of another scene",
                     "one of this scene, with the same files, --fill and --no-friction");
  }
  try {
    return read_state(json, simulation.now().state);
  } catch (const std::exception&) {
    throw InputError({file.string(), 0, ""}, "is a checkpoint of another version of Pliant",
                     kWritten + std::string(" of the same version"));
  }
}

bool is_checkpoint(const std::filesystem::path& file) { return is_sealed(file, kType); }

CheckpointFacts read_checkpoint_facts(const std::filesystem::path& file) {
  const Json json = read_content(file);
  try {
    return {json.at("identity"), json.at("steps"), json.at("state").at("time")};
  } catch (const Json::exception&) {
    throw InputError({file.string(), 0, ""}, "is a checkpoint of another version of Pliant",
                     kWritten + std::string(" of the same version"));
  }
}

}  // namespace pliant
