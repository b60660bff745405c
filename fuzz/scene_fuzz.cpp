// The reader of scenes on arbitrary YAML: it gives a scene whose motions can be evaluated and whose
// steps can be counted, or an InputError, nothing else.

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <unistd.h>

#include "pliant/base/errors.h"
#include "pliant/io/document.h"
#include "pliant/io/text_file.h"
#include "pliant/scene/scene.h"

namespace {

namespace fs = std::filesystem;

/// A folder with the files that the seeds name.
const fs::path& folder() {
  static const fs::path path = [] {
    fs::path made = fs::temp_directory_path() / ("scene-fuzz-" + std::to_string(::getpid()));
    fs::create_directories(made);
    std::ofstream(made / "m.json") << R"({"pliant": "material/1", "name": "m", "kind": "cloth",)"
                                   << R"("density": 0.1, "components": {}})";
    std::ofstream(made / "m.obj") << "";
    return made;
  }();
  return path;
}

void require(bool fact) {
  if (!fact) std::abort();
}

void evaluate(const pliant::Motion& motion) {
  for (const double time : {-1.0, 0.0, 0.5, 1e9}) {
    require(std::abs(pliant::pose_at(motion, time).rotation.norm() - 1) < 1e-9);
  }
}

void use(const pliant::Scene& scene) {
  require(!scene.cloth.empty());
  require(scene.time.step_count() >= 1);
  require(pliant::steps_per_frame(scene.output, scene.time) >= 1);
  for (const pliant::ScenePin& pin : scene.pins) {
    if (pin.motion) evaluate(*pin.motion);
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string bytes(reinterpret_cast<const char*>(data), size);
  const std::string file = (folder() / "scene.yaml").string();
  try {
    use(pliant::scene_of(pliant::parse_yaml(pliant::decode_text(bytes, {}, file), file)));
  } catch (const pliant::InputError&) {
  }
  return 0;
}
