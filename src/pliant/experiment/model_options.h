#pragma once

#include <algorithm>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "pliant/experiment/experiment_spec.h"
#include "pliant/material/material.h"

namespace pliant {

enum class FrictionChoice { automatic, dahl, none };

/// The friction that a study asks a fit for.
struct FrictionModel {
  /// A choice alone is one branch.
  FrictionModel(FrictionChoice chosen = FrictionChoice::automatic, int most = 1)
      : choice(chosen), branches(most) {}

  bool operator==(const FrictionModel&) const = default;

  FrictionChoice choice;
  int branches;  ///< at most; those beyond the first are addends `dahl`. 0: as many as data tell
};

struct ComponentModel {
  std::optional<CurveKind> stiffness;
  std::optional<FrictionModel> friction;
  std::vector<const AddendKind*> addends = {};
  /// Of two strains of a solid: Gaussian terms at so many places by so many; 0: one bilinear term.
  int gaussians = 0;
};

/// Where a heterogeneous material has samples, and of what: one of `places`, `grid`, `spread` and
/// `grown`. Those of cloth lie in its rest plane, at z = 0, by hand or on a grid.
struct SampleOptions {
  std::vector<Eigen::Vector3d> places = {};  ///< by hand (m)
  Eigen::Vector3i grid{0, 0, 0};             ///< at the middles of so many cells of the body's box
  int spread = 0;                    ///< so many nodes of the body, each far from the others
  int grown = 0;                     ///< so many at most, each where it explains most
  std::optional<double> width = {};  ///< m; absent: the mean distance of neighbours
  std::vector<std::string> of = {};  ///< components that differ; empty: all that do not bend
  Location where = {};

  bool differ_in(const std::string& component) const {
    return of.empty() ? !is_bending(component) : std::ranges::find(of, component) != of.end();
  }
};

struct ModelOptions {
  MaterialKind kind = MaterialKind::cloth;
  std::string solid_law = "additive";  ///< of solids: a name of `solid_laws`, unless `components`
  MembraneMeasure membrane = MembraneMeasure::stvk;
  std::string bending = "discrete-shells";
  bool isotropic = false;           ///< weft and warp share their curves; fits of sheets
  std::optional<double> mesh_edge;  ///< m, of the grid that sheets are simulated on; absent: 24
                                    ///< cells on the longer side
  double mesh_factor = 1;  ///< by which grids are coarser than the study says, to see their error
  bool measured_mesh = false;     ///< sheets are simulated on the meshes of their sessions
  bool strips_as_sheets = false;  ///< tensile-cycles are fitted as sheets, else in one dimension
  std::optional<CurveKind> stiffness;  ///< absent: affine for hanging weights, else hermite
  FrictionModel friction;
  std::map<std::string, ComponentModel> components;
  /// Of solids: components whose energies together have a limit.
  std::vector<std::vector<std::string>> limits;
  std::optional<SampleOptions> samples;  ///< absent: the same everywhere
};

/// The addends of a component whose branches of friction are all to be there: those that it names,
/// and a `dahl` for each branch beyond the first.
std::vector<const AddendKind*> addends_with_branches(const ComponentModel& component,
                                                     const FrictionModel& friction);

/// The friction of a component: its own, or else that of the model.
FrictionModel friction_of(const ModelOptions& model, const std::string& component);

/// Whether a model has springs, which lie along weft and warp.
inline bool needs_grid(const ModelOptions& model) {
  return model.membrane == MembraneMeasure::spring || model.bending == "spring";
}

/// Whether an experiment is fitted and predicted as a sheet: a session, or a strip where the model
/// asks for it.
bool is_sheet(const ExperimentSpec& spec, const ModelOptions& model);

}  // namespace pliant
