#include "pliant/capture/calibration_file.h"

#include "capture/virtual_rig.h"
#include "schema/documents.h"

namespace pliant::test {

NamedDocument written_calibration() {
  VirtualRig rig(2);
  rig.rig.warp = true;
  rig.rig.second_length = {100, 101, 0.1, false, {"rig.yaml", 8, "second_length"}};
  PlumbLine line{{}, {"rig.yaml", 9, "gravity"}};
  for (int c = 0; c < 2; ++c) {
    line.seen.push_back({c, *rig.cameras[c].project({0.02, -0.03, 0.5}),
                         *rig.cameras[c].project({0.02, 0.03, 0.5})});
  }
  rig.rig.gravity = line;
  RigCalibration found =
      calibrate_rig(rig.rig, rig.pictures_with_ruler(8, 0.1, RandomStream(6)), {});
  found.pictures.front().left_out = "shows no board";
  const Document document = parse_json(calibration_text(found, rig.rig), "calibration.json");
  return named("calibration.json", document);
}

}  // namespace pliant::test
