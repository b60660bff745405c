#include "schema/documents.h"

#include <algorithm>
#include <filesystem>

#include "pliant/exchange/u3m_import.h"
#include "pliant/geometry/block_mesh.h"
#include "pliant/geometry/volume_file.h"
#include "pliant/io/digest.h"
#include "pliant/io/text_file.h"
#include "pliant/material/material_file.h"
#include "pliant/measurement/session/session_document.h"
#include "pliant/scene/simulation_result.h"
#include "pliant/study/result_files.h"
#include "pliant/study/study.h"
#include "pliant/study/study_evaluation.h"
#include "pliant/study/study_fit.h"
#include "pliant/study/virtual_lab.h"

#include "support/compared_models.h"
#include "support/pages.h"
#include "support/session_sheets.h"

namespace pliant::test {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;
const fs::path kSource = PLIANT_SOURCE_DIR, kDocuments = kSource / "tests/schema/documents";

NamedDocument from_yaml(const std::string& name, const std::string& text) {
  return named(name, parse_yaml(text, name));
}

NamedDocument from_json(const std::string& name, const std::string& text) {
  return named(name, parse_json(text, name));
}

std::vector<fs::path> files_in(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(folder)) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

/// A block of a page as a document: whole, or its keys in place of those of a small one.
NamedDocument block_document(const std::string& name, const FencedBlock& block) {
  if (block.part_of.empty()) {
    return block.language == "json" ? from_json(name, block.text) : from_yaml(name, block.text);
  }
  NamedDocument document =
      named(name, read_yaml(kDocuments / ("small_" + block.part_of + ".yaml")));
  document.document.document.update(json_of(parse_yaml(block.text, name).root));
  return document;
}

/// The documents of Pliant, and parts of them, in the pages of the documentation. Blocks with the
/// name of a file are left out: what a page does with them is run (cmake/RunPage.cmake).
std::vector<NamedDocument> documents_of_pages() {
  std::vector<NamedDocument> documents;
  for (const Page& page : documentation()) {
    for (const FencedBlock& block : parts_of(page).blocks) {
      if ((block.language != "yaml" && block.language != "json") || !block.name.empty()) continue;
      documents.push_back(
          block_document(page.path.string() + ":" + std::to_string(block.line), block));
    }
  }
  return documents;
}

/// Scenes, and materials made up for them.
std::vector<NamedDocument> examples() {
  std::vector<NamedDocument> documents;
  for (const fs::path& file : files_in(kSource / "examples")) {
    const std::string name = file.filename().string();
    if (file.extension() == ".json") documents.push_back(named(name, read_json(file)));
    if (file.extension() != ".yaml") continue;
    documents.push_back(named(name, read_yaml(file)));
    for (Json& cloth : documents.back().document.document["cloth"]) {
      cloth["material"] = "spandex.json";  // where it stands while it is read here
    }
  }
  return documents;
}

/// simulation.json of a scene with everything that it can tell of: clips, fields, steps.
NamedDocument written_simulation() {
  const DocumentFolder folder;
  const Scene scene = read_scene(folder.write(
      "scene.yaml",
      "pliant: scene/1\n"
      "info: {shot: '12'}\n"
      "cloth: [{name: sheet, mesh: {grid: 1 m x 1 m, nodes: 3x3}, material: spandex.json}]\n"
      "clips: [{name: left, cloth: sheet, edges: [left], mass: 1 g}]\n"
      "time: {step: 1 ms, duration: 2 ms}\n"
      "output: {fields: [strain, friction]}\n"));
  Simulation simulation(scene, read_material(kSource / "examples" / "assumed-cloth.json"));
  simulation.record_frame();
  simulation.advance();
  const SimulationFacts facts{"pliant simulate", "2024-01-01T00:00:00Z", "0", sha256_of(""), 1, 20};
  return from_json("simulation.json", simulation_text(simulation_result(simulation, facts)));
}

}  // namespace

NamedDocument changed(const std::string& what, SchemaCase document, const char* pointer,
                      Json value) {
  document.document[Json::json_pointer(pointer)] = std::move(value);
  return {document.type + ": " + what, std::move(document)};
}

NamedDocument without(const std::string& what, SchemaCase document, const char* pointer) {
  const Json::json_pointer at(pointer);
  document.document.at(at.parent_pointer()).erase(at.back());
  return {document.type + ": " + what, std::move(document)};
}

NamedDocument named(const std::string& name, const Document& document) {
  const Json json = json_of(document.root);
  const std::string type = json.at("pliant");
  return {name, {type.substr(0, type.find('/')), json}};
}

DocumentFolder::DocumentFolder() {
  for (const char* name : {"warp-1.csv", "warp-2.csv"}) write(name, "weight_N,length_mm\n1,100\n");
  // Readers of scenes and sessions ask whether such files are there, and no more.
  for (const char* name : {"shirt.obj", "faces.txt", "vertices.txt", "rest.ply", "tooth.msh"})
    write(name, "");
  for (const char* folder : {"pictures", "left", "right", "boards/left", "boards/right",
                             "pictures/left", "pictures/right"}) {
    write(folder + std::string("/1.png"), "");
  }
  write("assumed-cloth.json", read_text_file(kSource / "examples" / "assumed-cloth.json"));
  write("labels.yaml", "pliant: pattern/1\nclips: {tag: 15 mm, edge: 15 mm, codes: [0, 1]}\n");
  write("export/1.csv", "x,y,u,v\n0,0,0,0\n");
  write("gel.msh", volume_file_text(block_of_hexahedra({1, 1, 1}, {2, 2, 2}), "gel.msh"));
  Json spandex = Json::parse(read_text_file(kSource / "materials" / "spandex.json"));
  spandex["components"]["stretch.weft"] = spandex["components"]["stretch.warp"];
  spandex["components"]["shear"] = {{"stiffness", {{"curve", "constant"}, {"value", 3.0}}}};
  spandex["components"]["contraction.warp"] = {
      {"stiffness", {{"curve", "constant"}, {"value", 0.3}}}};
  spandex["components"]["bend.weft"] = {
      {"stiffness", {{"curve", "constant"}, {"value", 1e-5}}},
      {"friction", {{"law", "dahl"}, {"a", 5e-4}, {"b", 0}, {"tau", 20}}}};
  for (const char* name : {"bend.warp", "bend.diagonal"}) {
    spandex["components"][name] = {{"stiffness", {{"curve", "constant"}, {"value", 1e-5}}}};
  }
  write("spandex.json", spandex.dump());
  write("rubber.json", read_text_file(kDocuments / "rubber.json"));
}

std::vector<NamedDocument> shipped_documents() {
  std::vector<NamedDocument> documents{
      named("published study", read_yaml(kDocuments / "published_study.yaml")),
      named("published material", read_json(kDocuments / "published_material.json"))};
  for (const fs::path& file : files_in(kSource / "materials")) {
    documents.push_back(named(file.filename().string(), read_json(file)));
  }
  std::vector<fs::path> labs{kSource / "examples" / "demo" / "lab.yaml",
                             kSource / "examples" / "sheet-sessions" / "lab.yaml",
                             kSource / "examples" / "joint" / "lab.yaml",
                             kSource / "examples" / "drape" / "lab.yaml",
                             kSource / "examples" / "drape" / "without-friction.yaml"};
  for (const fs::path& file : files_in(kSource / "examples" / "sheet-figures")) {
    if (file.extension() == ".yaml") labs.push_back(file);
  }
  for (const fs::path& file : labs) {
    NamedDocument lab = named("lab " + file.string(), read_yaml(file));
    lab.document.document["material"] = "spandex.json";  // where it stands while it is read here
    documents.push_back(std::move(lab));
  }
  for (NamedDocument& example : examples()) documents.push_back(std::move(example));
  for (NamedDocument& example : documents_of_pages()) documents.push_back(std::move(example));
  return documents;
}

std::vector<NamedDocument> written_documents() {
  const DocumentFolder folder;
  const VirtualLab lab =
      read_lab(folder.write("lab.yaml", read_text_file(kDocuments / "full_lab.yaml")));
  for (const auto& [name, content] : make_measurements(lab, {})) folder.write(name, content);
  Study study = read_study(folder.path() / "study.yaml");
  const RunFacts facts{"pliant fit", "2024-01-01T00:00:00Z", "0",
                       "study.yaml", sha256_of(""),          "material.json"};

  std::vector<NamedDocument> documents{
      named("study of lab", read_yaml(folder.path() / "study.yaml")),
      from_yaml("resolved study", resolved_study_text(study, folder.path()))};
  // Sheets are predicted alone: a fit of them would take no other experiment along.
  for (ExperimentSpec& spec : study.experiments) {
    if (facts_of_test(spec.type).measures_sheets) spec.role = ExperimentRole::validate;
  }
  StudyFitOptions options;
  options.compare_friction = true;
  options.profiles = {"shear.k*"};
  StudyResult fit = fit_study(study, options, {});
  fit.work.emplace();  // that a fit of sheets has beside
  StudyResult evaluation = evaluate_study(study, lab.material, {});
  evaluation.skipped = {{"of another material", {"shear"}}};
  for (const auto& files : {fit_files(fit, facts), evaluation_files(evaluation, facts)}) {
    for (const auto& [name, content] : files) {
      if (name.ends_with(".json")) documents.push_back(from_json(name, content));
    }
  }
  const fs::path record = kSource / "tests" / "corpus" / "u3m" / "two_directions.json";
  documents.push_back(from_yaml("study of a U3M file", import_u3m(record).study_yaml));
  ModelFits fits = sample_model_fits();
  fits.facts = facts;
  documents.push_back(from_json("summary.json", summary_json(fits)));
  documents.push_back(written_simulation());
  documents.push_back(written_calibration());
  documents.push_back(from_yaml("session", session_document_text(stretch_session())));
  return documents;
}

namespace {

std::vector<NamedDocument> broken_inputs_of_fits() {
  const std::vector<NamedDocument> full = full_documents();
  const SchemaCase &study = full[0].document, &lab = full[1].document, &material = full[2].document;
  return {
      changed("unknown version", study, "/pliant", "study/2"),
      changed("another type", study, "/pliant", "lab/1"),
      changed("density without unit", study, "/density", 0.157),
      changed("density of no size", study, "/density", "0 gsm"),
      changed("negative length", study, "/experiments/0/length", "-100 mm"),
      changed("length in kilograms", study, "/experiments/0/length", "100 kg"),
      changed("decimal comma", study, "/experiments/0/length", "10,5 cm"),
      changed("a type that is not there yet", study, "/experiments/0/type", "press"),
      changed("unknown experiment type", study, "/experiments/0/type", "hanging-weight"),
      changed("unknown direction", study, "/experiments/0/direction", "wrap"),
      changed("no experiments", study, "/experiments", Json::array()),
      changed("a name that is no file name", study, "/experiments/0/name", "../up"),
      changed("a hidden name", study, "/experiments/0/name", ".hidden"),
      changed("rows that are no range", study, "/experiments/0/exclude/0/rows", "from 12"),
      changed("row 0", study, "/experiments/0/exclude/0/rows", "0-3"),
      changed("an exclusion without reason", study, "/experiments/0/exclude/0", {{"rows", "3-4"}}),
      changed("pretension of hanging weights", study, "/experiments/0/pretension", "1 N"),
      changed("shear's tension of a strip", study, "/experiments/1/transverse_tension", "1 N/m"),
      changed("a direction of shear", study, "/experiments/2/direction", "warp"),
      changed("the length of a bent specimen's noise", study, "/experiments/4/noise/length",
              "1 mm"),
      changed("a bending test without direction", study, "/experiments/4/direction", nullptr),
      changed("a moment's noise of a strip", study, "/experiments/1/noise/moment", "1 N"),
      changed("the length of a cantilever", study, "/experiments/5/length", "100 mm"),
      changed("the force's noise of a profile", study, "/experiments/5/noise/force", "1 N"),
      changed("a profile's noise of a strip", study, "/experiments/1/noise/position", "1 mm"),
      changed("a rolled strip's friction", study, "/experiments/6/initial_friction", "rest"),
      without("a rolled strip without direction", study, "/experiments/6/direction"),
      changed("the length of a bending length", study, "/experiments/7/length", "100 mm"),
      changed("an angle without unit", study, "/experiments/7/angle", 41.5),
      changed("an angle of zero", study, "/experiments/7/angle", "0 deg"),
      changed("an angle of a cantilever", study, "/experiments/5/angle", "41.5 deg"),
      changed("an overhang's position noise", study, "/experiments/7/noise/position", "1 mm"),
      changed("a profile's overhang noise", study, "/experiments/5/noise/overhang", "1 mm"),
      changed("shear noise in newtons", study, "/experiments/2/noise/force", "1 N"),
      changed("tensile noise per width", study, "/experiments/1/noise/force", "1 N/m"),
      changed("negative pretension", study, "/experiments/1/pretension", "-1 N"),
      changed("2.5 cycles", study, "/experiments/1/precondition_cycles", 2.5),
      changed("unknown stiffness", study, "/model/stiffness", "quadratic"),
      changed("unknown friction", study, "/model/friction", "coulomb"),
      changed("unknown component", study, "/model/components/stretch.wrap", Json::object()),
      changed("unknown estimator", study, "/fit/estimator", "anchors"),
      changed("no control points", study, "/fit/control_points", 0),
      changed("one bound", study, "/fit/bounds/shear.k", {1}),
      changed("prior without spread", study, "/fit/priors/shear.k", {{"mean", 1}, {"sd", 0}}),
      without("no data", study, "/experiments/0/data"),
      without("no direction", study, "/experiments/0/direction"),
      changed("no specimens", lab, "/specimens", 0),
      changed("variation without unit", lab, "/specimen_variation", 0.05),
      changed("peaks in the wrong unit", lab, "/experiments/0/peaks/0", "10 %"),
      changed("strain peaks without unit", lab, "/experiments/1/peaks/0", 0.2),
      changed("no peaks", lab, "/experiments/2/peaks", Json::array()),
      changed("a direction of shear", lab, "/experiments/2/direction", "warp"),
      changed("peaks of a cantilever", lab, "/experiments/4/peaks", {"1 N"}),
      changed("the length of a cantilever", lab, "/experiments/4/length", "1 m"),
      changed("radii of a cantilever", lab, "/experiments/4/radii", {"1 mm"}),
      changed("a negative overhang", lab, "/experiments/4/overhangs/0", "-60 mm"),
      without("no overhangs", lab, "/experiments/4/overhangs"),
      changed("overhangs of a rolled strip", lab, "/experiments/5/overhangs", {"60 mm"}),
      changed("no radii", lab, "/experiments/5/radii", Json::array()),
      changed("4 points", lab, "/experiments/5/points", 4),
      changed("a profile's force noise", lab, "/experiments/5/noise/force", "1 N"),
      changed("radii of weights", lab, "/experiments/0/radii", {"1 mm"}),
      changed("overhangs of a bending length", lab, "/experiments/6/overhangs", {"60 mm"}),
      changed("peaks of a bending length", lab, "/experiments/6/peaks", {"1 N"}),
      changed("an angle of a cantilever", lab, "/experiments/4/angle", "41.5 deg"),
      changed("an overhang's force noise", lab, "/experiments/6/noise/force", "1 N"),
      changed("samples of weights", lab, "/experiments/0/samples", 10),
      changed("a type that the lab lacks", lab, "/experiments/0/type", "press"),
      without("no direction", lab, "/experiments/0/direction"),
      changed("another kind", material, "/kind", "solid"),
      changed("no density", material, "/density", 0),
      changed("negative a", material, "/components/stretch.warp/friction/a", -1),
      changed("tau of zero", material, "/components/stretch.warp/friction/tau", 0),
      changed("unknown law", material, "/components/stretch.warp/friction/law", "coulomb"),
      changed("unknown curve", material, "/components/stretch.warp/stiffness/curve", "linear"),
      changed("a curve's keys mixed", material, "/components/stretch.warp/stiffness/value", 1),
      changed("measured without stiffness", material, "/components/bend.warp/status", "measured"),
      changed("a range of one number", material, "/components/stretch.weft/range", {0.2}),
      without("one side of friction", material, "/components/stretch.weft/friction/negative"),
      without("no control points", material, "/components/stretch.weft/stiffness/strain"),
  };
}

std::vector<NamedDocument> broken_scenes() {
  const std::vector<NamedDocument> full = full_documents();
  const SchemaCase &scene = full[3].document, &linearized = full[4].document;
  const SchemaCase &iterated = full[5].document, &path = full[6].document;
  return {
      changed("no cloth", scene, "/cloth", Json::array()),
      changed("a name that is no file name", scene, "/cloth/0/name", "a/b"),
      changed("a mesh file without unit", scene, "/cloth/1/mesh/unit", nullptr),
      changed("a unit of mass", scene, "/cloth/1/mesh/unit", "kg"),
      changed("a unit with a number", scene, "/cloth/1/mesh/unit", "1 cm"),
      changed("unknown up axis", scene, "/cloth/1/mesh/up", "+x"),
      changed("uv scale of a shape", scene, "/cloth/1/mesh/rest", "shape"),
      changed("uv scale of no size", scene, "/cloth/1/mesh/uv_scale", "0 m"),
      changed("two meshes", scene, "/cloth/0/mesh/rectangle", "1 m x 1 m"),
      changed("a grid of one length", scene, "/cloth/0/mesh/grid", "100 mm"),
      changed("a grid of three lengths", scene, "/cloth/0/mesh/grid", "1 m x 1 m x 1 m"),
      changed("a grid without units", scene, "/cloth/0/mesh/grid", "1 x 1"),
      changed("a grid of no height", scene, "/cloth/0/mesh/grid", "1 m x 0.0 m"),
      changed("a grid in kilograms", scene, "/cloth/0/mesh/grid", "1 kg x 1 m"),
      changed("one node", scene, "/cloth/0/mesh/nodes", "1x25"),
      changed("too many nodes", scene, "/cloth/0/mesh/nodes", "2x100001"),
      changed("one number of nodes", scene, "/cloth/0/mesh/nodes", 25),
      changed("unknown diagonals", scene, "/cloth/0/mesh/diagonals", "alternating"),
      changed("a tube of two vertices around", scene, "/cloth/3/mesh/nodes", "2x9"),
      changed("an odd tube of alternating diagonals", scene, "/cloth/3/mesh/nodes", "13x9"),
      changed("noise of no size", scene, "/cloth/0/noise/amplitude", "0 um"),
      changed("noise without amplitude", scene, "/cloth/0/noise/amplitude", nullptr),
      changed("half a seed", scene, "/cloth/0/noise/seed", 0.5),
      changed("a spiral of no pitch", scene, "/cloth/0/shape/cylinder/pitch", "0 mm"),
      changed("no faces of a region", scene, "/cloth/0/regions/0/faces", Json::array()),
      changed("a negative face", scene, "/cloth/0/regions/0/faces/0", -1),
      changed("a cylinder of no radius", scene, "/cloth/0/shape/cylinder/radius", "0 mm"),
      changed("unknown axis", scene, "/cloth/0/shape/cylinder/axis", "z"),
      changed("a position in the plane", scene, "/cloth/0/place/translate", {0, 1}),
      changed("a quaternion of three", scene, "/cloth/1/place/rotate/quaternion", {1, 0, 0}),
      changed("an axis beside a quaternion", scene, "/cloth/1/place/rotate/axis", {1, 0, 0}),
      changed("half a vertex", scene, "/pins/0/vertices/0", 0.5),
      changed("unknown edge", scene, "/pins/0/edges/0", "upper"),
      changed("unknown corner", scene, "/pins/0/corners/0", "left-top"),
      changed("no direction", scene, "/pins/0/directions", Json::array()),
      changed("a direction twice", scene, "/pins/0/directions", {"z", "z"}),
      changed("no keyframes", scene, "/pins/0/motion/keyframes", Json::array()),
      changed("a time without unit", scene, "/pins/0/motion/keyframes/0/time", 0),
      changed("unknown interpolation", scene, "/pins/0/motion/interpolation", "cubic"),
      changed("a clip of no mass", scene, "/clips/0/mass", "0 g"),
      changed("a free clip that is moved", scene, "/clips/1/free", true),
      changed("a held clip that is pulled", scene, "/clips/0/free", false),
      changed("a cord at two points", scene, "/clips/0/cords/0/vertex", 1),
      changed("a force beside a cord", scene, "/clips/0/cords/2/force", {0, 0, 1}),
      changed("a cord of no length", scene, "/clips/0/cords/2/length", "0 m"),
      changed("an obstacle of nothing", scene, "/obstacles", {Json::object()}),
      changed("an obstacle of two shapes", scene, "/obstacles/0/sphere",
              {{"centre", {0, 0, 0}}, {"radius", "1 m"}}),
      changed("an obstacle that moves", scene, "/obstacles/0/motion", Json::object()),
      changed("a ball of no size", scene, "/obstacles/1/sphere/radius", "0 m"),
      changed("negative friction", scene, "/obstacles/0/friction", -0.1),
      changed("no kinetic friction", scene, "/obstacles/2/friction", {{"static", 0.5}}),
      changed("negative friction of cloth on itself", scene, "/contact/friction", -0.5),
      changed("negative drag", scene, "/air/drag", -1),
      changed("negative damping", scene, "/damping/fraction", -1),
      changed("a step of zero", scene, "/time/step", "0 ms"),
      changed("unknown integrator", scene, "/time/integrator", "euler"),
      changed("unknown friction", scene, "/time/friction", "coulomb"),
      changed("steps of dynamics", scene, "/time/steps", 20),
      changed("no formats", scene, "/output/formats", Json::array()),
      changed("a format twice", scene, "/output/formats", {"ply", "ply"}),
      changed("unknown field", scene, "/output/fields/0", "stress"),
      changed("a linear tolerance of 1", linearized, "/time/linear_tolerance", 1),
      changed("a motion tolerance in newtons", iterated, "/time/motion_tolerance", "1 uN"),
      changed("a force tolerance of iterated steps", iterated, "/time/tolerance", "1 uN"),
      changed("a motion tolerance of steps solved once", linearized, "/time/motion_tolerance",
              "1 um"),
      changed("a tolerance of steps solved once", linearized, "/time/tolerance", "1 uN"),
      changed("no steps", path, "/time/steps", 0),
      changed("a step of a path", path, "/time/step", "1 ms"),
      changed("damping of a path", path, "/damping", {{"fraction", 0.1}}),
      changed("velocity along a path", path, "/cloth/0/velocity", {0, 0, 1}),
      without("no time", scene, "/time"),
      without("a keyframe without time", scene, "/pins/0/motion/keyframes/1/time"),
      without("a pin of nothing", scene, "/pins/1/vertices"),
      without("a cord without end", scene, "/clips/0/cords/2/end"),
  };
}

std::vector<NamedDocument> broken_sessions() {
  const std::vector<NamedDocument> full = full_documents();
  const SchemaCase &session = full[7].document, &bend = full[8].document;
  return {
      changed("solids", session, "/kind", "solid"),
      changed("a test without name", session, "/test", ""),
      changed("a width of nothing", session, "/sample/width", "0 mm"),
      changed("a width without unit", session, "/sample/width", 100),
      changed("a mass in newtons", session, "/sample/mass", "1 N"),
      changed("a density per volume", session, "/sample/density", "1 kg/m^3"),
      changed("gravity of two numbers", session, "/gravity", {0, -9.81}),
      changed("a rest mesh in another format", session, "/rest", "shirt.obj"),
      changed("frames without number", session, "/frames", "frames/frame.ply"),
      changed("frames with two numbers", session, "/frames", "frames/%d-%d.ply"),
      changed("frames in folders of their own", session, "/frames", "%04d/frame.ply"),
      changed("frames padded with blanks", session, "/frames", "%4d.ply"),
      changed("a noise without unit", session, "/noise/force", 3),
      changed("a noise of nothing", session, "/noise/position", "0 mm"),
      changed("frames in another format", session, "/frames", "%04d.obj"),
      changed("a clip's name with blanks", session, "/clips/0/name", "left bar"),
      changed("a clip of negative mass", session, "/clips/0/mass", "-1 g"),
      changed("a clip that clamps nothing", session, "/clips/0/clamped", Json::array()),
      changed("a negative vertex", session, "/clips/0/clamped/0", -1),
      changed("two edges", session, "/table/edge_y", "1 mm"),
      changed("an edge without unit", session, "/table/edge_x", 78),
      changed("a table of a stretch test", session, "/test", "stretch-weft"),
      changed("a bend test along its edge", session, "/test", "bend-warp"),
      changed("a bend test along its edge", bend, "/test", "bend-weft"),
      without("no sample", session, "/sample"),
      without("a table without edge", session, "/table/edge_x"),
      without("a bend test without table", bend, "/table"),
      without("a sample without weight", bend, "/sample/density"),
  };
}

}  // namespace

std::vector<NamedDocument> broken_documents() {
  std::vector<NamedDocument> documents = broken_inputs_of_fits();
  for (NamedDocument& scene : broken_scenes()) documents.push_back(std::move(scene));
  for (NamedDocument& session : broken_sessions()) documents.push_back(std::move(session));
  for (NamedDocument& points : broken_points()) documents.push_back(std::move(points));
  for (NamedDocument& pattern : broken_patterns()) documents.push_back(std::move(pattern));
  for (NamedDocument& rig : broken_rigs()) documents.push_back(std::move(rig));
  return documents;
}

}  // namespace pliant::test
