// Converted files under CalculiX: a column that is pulled by 30 %, against our equilibrium of the
// same mesh. Skipped where the program ccx is not installed.

#include <cmath>
#include <cstdlib>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "pliant/exchange/keyword_file.h"
#include "pliant/geometry/volume_file.h"
#include "pliant/material/material_file.h"

#include "app/run_program.h"
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

/// Nodes that are held along an axis.
struct Support {
  std::vector<int> nodes;
  int axis = 0;
};

/// Both ends as they are, or free to become narrower.
enum class Ends { clamped, sliding };

std::vector<Support> supports(const VolumeMesh& mesh, Ends ends) {
  const std::vector<int> bottom = nodes_at(mesh, 2, 0), top = nodes_at(mesh, 2, kHeight);
  if (ends == Ends::clamped) return {{bottom, 0}, {bottom, 1}, {bottom, 2}, {top, 0}, {top, 1}};
  return {{bottom, 2}, {{0}, 0}, {{0}, 1}, {{1}, 1}};  // node 1 lies along x of node 0
}

Equilibrium ours(const VolumeMesh& mesh, const SolidLaw& law, Ends ends) {
  Eigen::Matrix3Xd start = mesh.positions;
  start.row(2) *= 1 + kPull / kHeight;
  SolidSystem solid = solid_system(mesh, law, 0, start);
  for (const Support& support : supports(mesh, ends)) solid.hold(support.nodes, support.axis);
  solid.hold(nodes_at(mesh, 2, kHeight), 2);
  solid.system->finish();
  State state = solid.system->initial_state();
  EXPECT_TRUE(settle(*solid.system, state, 1e-6).converged);
  return {state.configuration.positions - mesh.positions,
          gradient_of(*solid.system, state.configuration, state)};
}

std::string boundary(const Support& support, double value = 0) {
  std::string text = "*BOUNDARY\n";
  for (const int node : support.nodes) {
    text += fmt::format("{}, {}, {}, {}\n", node + 1, support.axis + 1, support.axis + 1, value);
  }
  return text;
}

/// What a user adds to the file of a model.
std::string support_and_step(const VolumeMesh& mesh, Ends ends) {
  std::string text;
  for (const Support& support : supports(mesh, ends)) text += boundary(support);
  return text +
         "*STEP, NLGEOM\n*STATIC\n0.2, 1\n"
         "*CONTROLS, PARAMETERS=FIELD\n1e-7, 1e-7\n" +  // residuals, corrections
         boundary({nodes_at(mesh, 2, kHeight), 2}, kPull) +
         "*NODE PRINT, NSET=NALL\nU, RF\n*END STEP\n";
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

/// What CalculiX finds.
/// @param model  the file of a model, without support and step
Equilibrium of_calculix(const std::string& model, const VolumeMesh& mesh, Ends ends) {
  const TemporaryFolder folder;
  folder.write("column.inp", model + support_and_step(mesh, ends));
  const std::string command =
      fmt::format("cd '{}' && OMP_NUM_THREADS=1 ccx -i column > said 2>&1", folder.path().string());
  EXPECT_EQ(std::system(command.c_str()), 0) << content_of(folder.path() / "said");
  const std::string printed = content_of(folder.path() / "column.dat");
  return {last_table(printed, "displacements", mesh.node_count()),
          last_table(printed, "forces", mesh.node_count())};
}

std::string model_of(const VolumeMesh& mesh, const Material& material) {
  const StandardLaw law = standard_law(material, "rubber.json");
  return keyword_file({material, "rubber.json", law, &mesh}, KeywordTool::calculix).text;
}

/// The same by the program, from files.
std::string converted_model(const VolumeMesh& mesh, const Material& material) {
  const TemporaryFolder folder;
  folder.write("rubber.json", pliant::material_text(material));
  folder.write("column.msh", volume_file_text(mesh, "column.msh"));
  const ProgramRun run = run_program({"convert", "rubber.json", "column.inp", "--to", "calculix",
                                      "--mesh", "column.msh", "--unit", "m"},
                                     {.working_directory = folder.path()});
  EXPECT_EQ(run.status, 0) << run.err;
  return content_of(folder.path() / "column.inp");
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

Material orthotropic() {
  Eigen::Matrix3d normal;
  normal << 4, 2, 1.5, 2, 6, 1, 1.5, 1, 5;
  return orthotropic_stvk_solid(kShear * normal, kShear * Eigen::Vector3d(1.1, 1.4, 0.9));
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
      {"ArrudaBoyce", chains()},
      {"OrthotropicStVK", orthotropic()}};
  return all;
}

bool has_calculix() { return std::system("command -v ccx > /dev/null 2>&1") == 0; }

/// The largest difference over the largest value.
double difference(const Eigen::Matrix3Xd& a, const Eigen::Matrix3Xd& b) {
  return (a - b).cwiseAbs().maxCoeff() / b.cwiseAbs().maxCoeff();
}

// CalculiX prints seven digits.
void expect_alike(const Equilibrium& a, const Equilibrium& b) {
  EXPECT_LT(difference(a.displacements, b.displacements), 1e-6);
  EXPECT_LT(difference(a.forces, b.forces), 1e-6);
  fmt::print("apart by {:.1e} of displacements, {:.1e} of forces\n",
             difference(a.displacements, b.displacements), difference(a.forces, b.forces));
}

class Calculix : public ::testing::TestWithParam<Column> {};

TEST_P(Calculix, PullsAColumnBetweenClampedEndsAsWeDo) {
  if (!has_calculix()) GTEST_SKIP() << "needs CalculiX (calculix-ccx)";
  for (const Cells cells : {Cells::hexahedra, Cells::tetrahedra}) {
    const VolumeMesh mesh = column(cells);
    const Material& material = GetParam().material;
    expect_alike(of_calculix(model_of(mesh, material), mesh, Ends::clamped),
                 ours(mesh, pointwise(material), Ends::clamped));
  }
}

INSTANTIATE_TEST_SUITE_P(Columns, Calculix, ::testing::ValuesIn(columns()),
                         [](const auto& one) { return one.param.name; });

TEST(Calculix, PullsAColumnOfAFileOfTheProgramAsWeDo) {
  if (!has_calculix()) GTEST_SKIP() << "needs CalculiX (calculix-ccx)";
  const Material material = neo_hookean_solid(kShear / 2, kBulk);
  for (const Cells cells : {Cells::hexahedra, Cells::tetrahedra}) {
    const VolumeMesh mesh = column(cells);
    expect_alike(of_calculix(converted_model(mesh, material), mesh, Ends::sliding),
                 ours(mesh, solid_law(material), Ends::sliding));
  }
}

// What is said to be lost: C3D8 is stiffer than hexahedra of one volume.
TEST(Calculix, HasElementsThatAreStifferWhereTheVolumeHardlyChanges) {
  if (!has_calculix()) GTEST_SKIP() << "needs CalculiX (calculix-ccx)";
  const VolumeMesh mesh = column(Cells::hexahedra);
  for (const double bulk : {3 * kShear, 100 * kShear}) {
    const Material material = neo_hookean_solid(kShear / 2, bulk);
    const auto pull = [&](const Equilibrium& at) {
      return at.forces(2, nodes_at(mesh, 2, kHeight)).sum();
    };
    const double ratio = pull(of_calculix(model_of(mesh, material), mesh, Ends::clamped)) /
                         pull(ours(mesh, solid_law(material), Ends::clamped));
    fmt::print("bulk {:.0f} shear moduli: pulls {:.3f} times as hard\n", bulk / kShear, ratio);
    EXPECT_GT(ratio, 1);
  }
}

}  // namespace
}  // namespace pliant::test
