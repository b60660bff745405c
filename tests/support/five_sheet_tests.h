#pragma once

#include <string>
#include <vector>

#include <fmt/format.h>

#include "pliant/study/study.h"

#include "io/temporary_folder.h"
#include "support/virtual_sheets.h"

namespace pliant::test {

/// A study of the five tests of a material, on the mesh that they were measured on.
class FiveSheetTests {
 public:
  /// @param model  further keys of the study's model, e.g. ", variant: linear-orthotropic"
  /// @param positions  whether those between clips tell the shapes of the sheets, too
  /// @param bends      whether those over an edge are among them; else bending is known
  explicit FiveSheetTests(const Material& material, const std::string& model = "", int nodes = 13,
                          int frames = 6, bool positions = false, bool bends = true) {
    add(virtual_stretch(material, 0, nodes, frames));
    add(virtual_stretch(material, 1, nodes, frames));
    add(virtual_shear(material, nodes, frames));
    if (bends) {
      add(virtual_bend(material, 0, nodes, frames));
      add(virtual_bend(material, 1, nodes, frames));
    }
    std::string text = "pliant: study/1\nname: five\nexperiments:\n";
    for (const std::string& name : names_) {
      text += fmt::format("  - {{name: {0}, type: session, data: {0}}}\n", name);
      if (!positions || name.starts_with("bend")) continue;
      text += fmt::format(
          "  - {{name: {0}-shape, type: session, data: {0}, objective: positions}}\n", name);
    }
    text += "model: {mesh: measured" + model + "}\n";
    if (!bends) {
      const auto stiffness = [&](const char* component) {
        return material.components.at(component).stiffness->value(0);
      };
      text +=
          fmt::format("fit: {{fix: {{bend.weft.k: {}, bend.warp.k: {}, bend.diagonal.k: {}}}}}\n",
                      stiffness("bend.weft"), stiffness("bend.warp"), stiffness("bend.diagonal"));
    }
    folder_.write("study.yaml", text);
  }

  std::filesystem::path file() const { return folder_.path() / "study.yaml"; }
  Study study() const { return read_study(file()); }

 private:
  void add(const Session& session) {
    write_session(folder_.path() / session.test, session);
    names_.push_back(session.test);
  }

  TemporaryFolder folder_;
  std::vector<std::string> names_;
};

}  // namespace pliant::test
