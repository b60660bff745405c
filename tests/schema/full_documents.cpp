#include <array>
#include <filesystem>

#include "schema/documents.h"

namespace pliant::test {

std::vector<NamedDocument> full_documents() {
  struct Full {
    const char *name, *file;
  };
  constexpr std::array kFull{
      Full{"study", "full_study.yaml"},
      Full{"lab", "full_lab.yaml"},
      Full{"material", "full_material.json"},
      Full{"scene", "full_scene.yaml"},
      Full{"scene of linearized steps", "linearized_scene.yaml"},
      Full{"scene of iterated steps", "iterated_scene.yaml"},
      Full{"quasi-static scene", "quasi_static_scene.yaml"},
      Full{"session", "full_session.yaml"},
      Full{"session of a bend test", "bend_session.yaml"},
      Full{"study of a solid", "solid_study.yaml"},
      Full{"lab of a solid", "solid_lab.yaml"},
      Full{"study of a sampled solid", "sampled_study.yaml"},
      Full{"material of a solid", "rubber.json"},
      Full{"material of a sampled solid", "phantom.json"},
      Full{"material of a sampled cloth", "sampled_cloth.json"},
      Full{"study of a sampled sheet", "sampled_sheet_study.yaml"},
      Full{"board of tags", "board_pattern.yaml"},
      Full{"chessboard", "chessboard_pattern.yaml"},
      Full{"labels of clips", "clips_pattern.yaml"},
      Full{"texture of cloth", "cloth_pattern.yaml"},
      Full{"rig of two cameras", "full_rig.yaml"},
      Full{"rig with a plumb line", "plumb_rig.yaml"},
      Full{"pictures of cords that cells pull", "cells_dic.yaml"},
      Full{"pictures of several cameras", "views_dic.yaml"},
      Full{"pictures of clips with labels", "labelled_dic.yaml"},
      Full{"pictures of a flat sample", "pictures_dic.yaml"},
      Full{"points of image correlation", "full_dic.yaml"},
  };
  const std::filesystem::path folder =
      std::filesystem::path(PLIANT_SOURCE_DIR) / "tests/schema/documents";
  std::vector<NamedDocument> documents;
  for (const auto& [name, file] : kFull) {
    const std::filesystem::path path = folder / file;
    documents.push_back(
        named(name, path.extension() == ".json" ? read_json(path) : read_yaml(path)));
  }
  return documents;
}

}  // namespace pliant::test
