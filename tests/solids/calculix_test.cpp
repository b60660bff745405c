// Converted files under CalculiX: a column that is pulled by 30 % between clamped ends, against our
// equilibrium of the same mesh. Skipped where the program ccx is not installed.

#include <cstdlib>
#include <fstream>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "pliant/exchange/keyword_file.h"

#include "io/temporary_folder.h"
#include "support/evaluate_system.h"
#include "support/solid_bodies.h"
#include "support/solid_materials.h"

namespace pliant::test {
namespace {

constexpr double kHeight = 2, kPull = 0.3 * kHeight;  // m
constexpr double kShear = 1e5, kBulk = 3e5;           // Pa

/// Where a body's nodes go, and the forces that hold it (N); one column a node.
struct Equilibrium {
  Eigen::Matrix3Xd displacements, forces;
};

VolumeMesh column(Cells cells) {
  return shaken_inside(block_of(cells, {1, 1, kHeight}, {2, 2, 4}), 0.2, 5);
}

/// A law as elements with a volume at each point take it, which CalculiX' do.
SolidLaw pointwise(const Material& material) {
  SolidLaw law;
  law.of_points = solid_density(material).law;
  return law;
}

Equilibrium ours(const VolumeMesh& mesh, const Material& material) {
  Eigen::Matrix3Xd start = mesh.positions;
  start.row(2) *= 1 + kPull / kHeight;
  SolidSystem solid = solid_system(mesh, pointwise(material), 0, start);
  solid.hold(nodes_at(mesh, 2, 0));
  solid.hold(nodes_at(mesh, 2, kHeight));
  solid.system->finish();
  State state = solid.system->initial_state();
  EXPECT_TRUE(settle(*solid.system, state, 1e-6).converged);
  return {state.configuration.positions - mesh.positions,
          gradient_of(*solid.system, state.configuration, state)};
}

std::string list_of(const std::vector<int>& nodes) {
  std::string text;
  for (const int node : nodes) text += fmt::format("{},\n", node + 1);
  return text;
}

/// What a user adds to the file of a model.
std::string support_and_step(const VolumeMesh& mesh) {
  return "*NSET, NSET=BOTTOM\n" + list_of(nodes_at(mesh, 2, 0)) + "*NSET, NSET=TOP\n" +
         list_of(nodes_at(mesh, 2, kHeight)) +
         fmt::format(
             "*BOUNDARY\nBOTTOM, 1, 3\nTOP, 1, 2\n*STEP, NLGEOM\n*STATIC\n0.2, 1\n"
             "*CONTROLS, PARAMETERS=FIELD\n1e-7, 1e-7\n"  // residuals, corrections
             "*BOUNDARY\nTOP, 3, 3, {}\n*NODE PRINT, NSET=NALL\nU, RF\n*END STEP\n",
             kPull);
}

/// The last table of a kind in what CalculiX prints: "displacements", "forces".
Eigen::Matrix3Xd last_table(const std::string& printed, const std::string& kind, int nodes) {
  Eigen::Matrix3Xd table = Eigen::Matrix3Xd::Constant(3, nodes, NAN);
  const std::size_t head = printed.rfind(kind + " (");
  if (head == std::string::npos) {
    ADD_FAILURE() << "no " << kind << " in " << printed;
    return table;
  }
  std::istringstream rows(printed.substr(printed.find('\n', head)));
  for (int i = 0; i < nodes; ++i) {
    int node = 0;
    double x = 0, y = 0, z = 0;
    rows >> node >> x >> y >> z;
    if (node >= 1 && node <= nodes) table.col(node - 1) << x, y, z;
  }
  return table;
}

Equilibrium of_calculix(const VolumeMesh& mesh, const Material& material) {
  const TemporaryFolder folder;
  const ConvertedSolid file =
      keyword_file({material, "rubber.json", standard_law(material, "rubber.json"), &mesh},
                   KeywordTool::calculix);
  folder.write("column.inp", file.text + support_and_step(mesh));
  const std::string command =
      fmt::format("cd '{}' && OMP_NUM_THREADS=1 ccx -i column > said 2>&1", folder.path().string());
  EXPECT_EQ(std::system(command.c_str()), 0) << content_of(folder.path() / "said");
  const std::string printed = content_of(folder.path() / "column.dat");
  return {last_table(printed, "displacements", mesh.node_count()),
          last_table(printed, "forces", mesh.node_count())};
}

struct Column {
  std::string name;
  Material material;

  friend void PrintTo(const Column& column, std::ostream* out) { *out << column.name; }
};

/// A law of shape with bulk / 2 (J - 1)^2.
Material with_volume(std::map<std::string, MaterialComponent> components) {
  components["J"] = component_of(ScalarCurve::constant(kBulk));
  return solid_of(std::move(components));
}

/// The eight chains with the volume's energy that they have in CalculiX.
Material chains() {
  return solid_of({{"I1-bar", component_of({arruda_boyce(0.9 * kShear, 1.5)})},
                   {"J", component_of({polynomial(kBulk / 2, kBulk / 4, 0)})},
                   {"log-J", component_of({linear(-kBulk / 2)})}});
}

const std::vector<Column>& columns() {
  static const std::vector<Column> all{
      {"StVK", stvk_solid(kBulk - 2 * kShear / 3, kShear)},
      {"NeoHookean", with_volume({{"I1-bar", component_of({linear(kShear / 2)})}})},
      {"MooneyRivlin", with_volume({{"I1-bar", component_of({linear(0.4 * kShear)})},
                                    {"I2-bar", component_of({linear(0.1 * kShear)})}})},
      {"Yeoh",
       with_volume(
           {{"I1-bar", component_of({polynomial(kShear / 2, -0.02 * kShear, 0.01 * kShear)})}})},
      {"YeohWithI2",
       with_volume(
           {{"I1-bar", component_of({polynomial(0.4 * kShear, -0.02 * kShear, 0.01 * kShear)})},
            {"I2-bar", component_of({linear(0.1 * kShear)})}})},
      {"Ogden", with_volume({{"stretch-bar",
                              component_of({ogden(0.8 * kShear, 1.5), ogden(0.2 * kShear, -3)})}})},
      {"ArrudaBoyce", chains()}};
  return all;
}

class Calculix : public ::testing::TestWithParam<Column> {
 protected:
  void SetUp() override {
    if (std::system("command -v ccx > /dev/null 2>&1") != 0) {
      GTEST_SKIP() << "needs CalculiX (calculix-ccx)";
    }
  }
};

/// The largest difference over the largest value.
double difference(const Eigen::Matrix3Xd& a, const Eigen::Matrix3Xd& b) {
  return (a - b).cwiseAbs().maxCoeff() / b.cwiseAbs().maxCoeff();
}

TEST_P(Calculix, PullsAColumnAsWeDo) {
  for (const Cells cells : {Cells::hexahedra, Cells::tetrahedra}) {
    const VolumeMesh mesh = column(cells);
    const Equilibrium a = ours(mesh, GetParam().material);
    const Equilibrium b = of_calculix(mesh, GetParam().material);
    // It prints seven digits.
    EXPECT_LT(difference(b.displacements, a.displacements), 1e-6);
    EXPECT_LT(difference(b.forces, a.forces), 1e-6);
    RecordProperty(
        cells == Cells::hexahedra ? "hexahedra" : "tetrahedra",
        fmt::format("displacements {:.1e}, forces {:.1e}",
                    difference(b.displacements, a.displacements), difference(b.forces, a.forces)));
  }
}

INSTANTIATE_TEST_SUITE_P(Columns, Calculix, ::testing::ValuesIn(columns()),
                         [](const auto& one) { return one.param.name; });

}  // namespace
}  // namespace pliant::test
