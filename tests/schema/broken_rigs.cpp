#include <algorithm>

#include "schema/documents.h"

namespace pliant::test {
namespace {

SchemaCase whole_rig(const std::string& name) {
  const std::vector<NamedDocument> full = full_documents();
  return std::ranges::find(full, name, &NamedDocument::name)->document;
}

}  // namespace

std::vector<NamedDocument> broken_rigs() {
  const SchemaCase rig = whole_rig("rig of two cameras"),
                   plumb = whole_rig("rig with a plumb line");
  return {
      without("a rig without cameras", rig, "/cameras"),
      changed("no cameras", rig, "/cameras", nlohmann::json::object()),
      changed("a lens of its own", rig, "/cameras/left/distortion", "fisheye"),
      without("cameras without pictures", rig, "/calibration/pictures"),
      changed("no boards", rig, "/calibration/boards", nlohmann::json::array()),
      changed("a bend of boards", rig, "/calibration/warp", "2 mm"),
      changed("a code that there is not", rig, "/calibration/second_length/codes/1", 587),
      changed("a code twice", rig, "/calibration/second_length/codes/1", 100),
      changed("a length without unit", rig, "/calibration/second_length/distance", 250),
      without("two tags and no distance", rig, "/calibration/second_length/distance"),
      changed("two tags and a side", rig, "/calibration/second_length/side", "30 mm"),
      changed("a side of nothing", plumb, "/calibration/second_length/side", "0 mm"),
      changed("a board and a plumb line", plumb, "/calibration/gravity/level", "left.png"),
      changed("gravity by nothing", plumb, "/calibration/gravity", nlohmann::json::object()),
      changed("a line by one pixel", plumb, "/calibration/gravity/plumb/left",
              nlohmann::json::array({nlohmann::json::array({1, 2})})),
      without("a line in one camera", plumb, "/calibration/gravity/plumb/left"),
  };
}

}  // namespace pliant::test
