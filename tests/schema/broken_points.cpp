#include "schema/documents.h"

namespace pliant::test {

std::vector<NamedDocument> broken_points() {
  const std::vector<NamedDocument> full = full_documents();
  const SchemaCase &dic = full.back().document, &pictures = full[full.size() - 2].document,
                   &labelled = full[full.size() - 3].document;
  return {
      changed("a test without name", dic, "/test", ""),
      changed("a sample without unit", dic, "/sample/width", 100),
      changed("a scale of nothing", dic, "/scale", "0 mm"),
      changed("an origin of three numbers", dic, "/origin", {1, 2, 3}),
      changed("an origin of masses", dic, "/origin/0", "1 g"),
      without("an origin of numbers that have no scale", dic, "/scale"),
      changed("warp along z", dic, "/warp", "z"),
      changed("warp along weft", dic, "/warp", "x"),
      changed("a mesh without unit", dic, "/mesh", 4),
      changed("gravity of two numbers", dic, "/gravity", {0, -9.81}),
      changed("a clip's name with blanks", dic, "/clips/0/name", "left bar"),
      changed("a clip at a corner", dic, "/clips/0/side", "lower left"),
      changed("a clip that moves at will", dic, "/clips/0/motion", "free"),
      changed("a clip of negative mass", dic, "/clips/0/mass", "-1 g"),
      changed("a rate in seconds", dic, "/forces/rate", "2 s"),
      changed("a rate of nothing", dic, "/forces/rate", "0 Hz"),
      without("no points", dic, "/points"),
      without("no clips", dic, "/clips"),
      without("a clip without side", dic, "/clips/0/side"),
      without("forces on nothing", dic, "/forces/on"),
      without("an extension that nobody tells", dic, "/forces"),
      changed("points and pictures", dic, "/pictures", "pictures/*.png"),
      changed("an even patch", pictures, "/pictures/patch", 20),
      changed("a small patch", pictures, "/pictures/patch", 7),
      changed("no step", pictures, "/pictures/step", 0),
      without("neither points nor pictures", pictures, "/pictures"),
      without("pictures without scale", pictures, "/scale"),
      without("pictures of a sample anywhere", pictures, "/origin"),
      without("labels of unknown size", labelled, "/labels"),
      without("labels whose clip's edge nobody knows", labelled, "/labels/edge"),
      changed("labels beside a scale", labelled, "/scale", "0.1 mm"),
      changed("labels beside an axis", labelled, "/weft", "x"),
      changed("lengths of a pixel", labelled, "/origin/0", "1 mm"),
      changed("no labels on a clip", labelled, "/clips/0/labels", nlohmann::json::array()),
      changed("a code that no label has", labelled, "/clips/0/labels/0", 587),
      changed("labels that move as the log says", labelled, "/clips/0/motion", "extension"),
      changed("labels in tables", dic, "/labels", "labels.yaml"),
  };
}

}  // namespace pliant::test
