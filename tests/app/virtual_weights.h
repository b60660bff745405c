#pragma once

#include <string>

#include "app/run_program.h"

namespace pliant::test {

/// A lab.yaml of weights hung from a published fabric.
inline std::string weights_lab(const std::string& fabric = "polyester") {
  return "pliant: lab/1\nmaterial: " PLIANT_SOURCE_DIR "/materials/" + fabric +
         ".json\n"
         "experiments:\n"
         "  - {name: weights, type: hanging-weights, direction: warp, clip_mass: 20 g,\n"
         "     peaks: [2 N, 4 N, 6 N], step: 1 N, repeats: 2, noise: {length: 0.2 mm}}\n";
}

/// A folder with measurements that the program made, in `study/`.
class MeasuredFolder : public TemporaryFolder {
 public:
  explicit MeasuredFolder(const std::string& lab = weights_lab()) {
    made = run_program({"lab", write("lab.yaml", lab).string(), "-o", (path() / "study").string()});
  }

  std::string study() const { return (path() / "study" / "study.yaml").string(); }
  std::string file(const std::string& name) const { return (path() / name).string(); }

  ProgramRun made;
};

}  // namespace pliant::test
