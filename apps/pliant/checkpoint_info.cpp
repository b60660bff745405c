#include <fmt/format.h>

#include "pliant/base/quantity.h"
#include "pliant/scene/checkpoint.h"

#include "apps/pliant/file_info.h"

namespace pliant {

FileInfo checkpoint_info(const std::filesystem::path& path) {
  const CheckpointFacts facts = read_checkpoint_facts(path);
  FileInfo info = begin_info(path, "checkpoint/1");
  info.json["scene_identity"] = facts.identity;
  info.json["steps"] = facts.steps;
  info.json["time"] = facts.time;
  info.json["warnings"] = info.warnings;
  info.lines.push_back(labelled("what it is", "the state of a simulation, for --resume"));
  info.lines.push_back(labelled(
      "reached",
      fmt::format("step {}, at {}", facts.steps, format_quantity(facts.time, Dimension::time))));
  info.lines.push_back(labelled("scene and its files", "SHA-256 " + facts.identity));
  return info;
}

}  // namespace pliant
