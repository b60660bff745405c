// What the mechanics of solids cost, against the thesis' own method: energies of elements alone,
// forces and stiffness by their finite differences ([T] 4.2.6: 13 energies a tetrahedron for
// forces, 25 a hexahedron); and what an equilibrium costs beside its factorisations.

#include <array>
#include <optional>
#include <vector>

#include <Eigen/CholmodSupport>
#include <benchmark/benchmark.h>

#include "pliant/geometry/block_mesh.h"
#include "pliant/material/solid/solid_density.h"
#include "pliant/material/solid/standard_solids.h"
#include "pliant/material/strain/linear_tetrahedron.h"
#include "pliant/material/strain/trilinear_hexahedron.h"
#include "pliant/mechanics/point_forces.h"
#include "pliant/mechanics/solid_lanes.h"
#include "pliant/mechanics/solid_potentials.h"
#include "pliant/solver/static_solver.h"

namespace {

using namespace pliant;

const Material& rubber() {
  static const Material material = neo_hookean_solid(1.7e4, 1.7e5);
  return material;
}

SolidLaw law_of_points() {
  SolidLaw law;
  law.of_points = solid_density(rubber()).law;
  return law;
}

VolumeMesh block(bool tetrahedra) {
  const Eigen::Vector3d size(0.4, 0.1, 0.1);
  return tetrahedra ? block_of_tetrahedra(size, {26, 6, 6}) : block_of_hexahedra(size, {26, 6, 6});
}

// Smoothly bent and stretched.
Eigen::Matrix3Xd deformed(Eigen::Matrix3Xd positions) {
  for (auto p : positions.colwise()) {
    const double x = p.x(), y = p.y();
    p += Eigen::Vector3d(0.1 * x - 0.5 * x * y, 0.8 * x * x - 0.05 * y, 0.3 * x * y);
  }
  return positions;
}

void BM_HessianAnalytic(benchmark::State& run) {
  const VolumeMesh mesh = block(run.range(0) == 1);
  System system(mesh.positions, Eigen::VectorXd::Ones(mesh.node_count()));
  add_solid(system, mesh, law_of_points());
  system.finish();
  const State state = system.initial_state();
  const Configuration at{deformed(mesh.positions), {}};
  Hessian hessian = system.make_hessian();
  Eigen::Matrix3Xd gradient = Eigen::Matrix3Xd::Zero(3, system.points());
  for (auto _ : run) {
    hessian.matrix.set_zero();
    Derivatives derivatives;
    derivatives.gradient = &gradient;
    derivatives.hessian = &hessian;
    system.evaluate(at, {.from = state}, Curvature::exact, derivatives);
    benchmark::DoNotOptimize(hessian.matrix.block(0).data());
  }
  run.counters["us_an_element"] = benchmark::Counter(
      1e-6 * mesh.element_count(),
      benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}
BENCHMARK(BM_HessianAnalytic)->ArgName("tetrahedra")->Arg(1)->Arg(0)->Unit(benchmark::kMillisecond);

// Eight tetrahedra, or the eight points of a hexahedron.
template <class Measure>
struct Batch {
  std::array<typename Measure::Rest, kLanes> rests;
  Lane sizes;
  LanePositions<Measure> positions;

  Lane energies(const Density& law, const LanePositions<Measure>& at) const {
    const LaneStrains strain = LaneKernel<Measure>(rests.data(), at, false).strain();
    const LaneView view(strain.data(), kLanes, 6);
    Lane stored = Lane::Zero();
    law.add_stored({view, view, view, LaneView(strain.data(), kLanes, 0)}, stored);
    return sizes * stored;
  }

  // Of an element: of each of the tetrahedra, or of the hexahedron.
  Lane energy(const Density& law, const LanePositions<Measure>& at) const {
    const Lane own = energies(law, at);
    if constexpr (Measure::kNodes == 8) return Lane::Constant(own.sum());
    return own;
  }
};

constexpr double kStep = 1e-6;  // m

template <class Measure>
LanePositions<Measure> forces(const Batch<Measure>& batch, const Density& law,
                              LanePositions<Measure> at) {
  LanePositions<Measure> result;
  const Lane here = batch.energy(law, at);
  for (int k = 0; k < Measure::kUnknowns; ++k) {
    at.col(k) += kStep;
    result.col(k) = (batch.energy(law, at) - here) / kStep;
    at.col(k) -= kStep;
  }
  return result;
}

template <class Measure>
std::vector<LanePositions<Measure>> stiffness(const Batch<Measure>& batch, const Density& law) {
  std::vector<LanePositions<Measure>> columns;
  LanePositions<Measure> at = batch.positions;
  const LanePositions<Measure> here = forces(batch, law, at);
  for (int k = 0; k < Measure::kUnknowns; ++k) {
    at.col(k) += kStep;
    columns.push_back((forces(batch, law, at) - here) / kStep);
    at.col(k) -= kStep;
  }
  return columns;
}

template <class Measure, class Nodes>
void set_positions(const Eigen::Matrix3Xd& all, const Nodes& nodes, int lane,
                   Batch<Measure>& batch) {
  for (int k = 0; k < Measure::kUnknowns; ++k) {
    batch.positions(lane, k) = all(k % 3, nodes(k / 3));
  }
}

Batch<LinearTetrahedron> batch_of(const VolumeMesh& mesh, const Eigen::Matrix3Xd& at, int first,
                                  LinearTetrahedron) {
  Batch<LinearTetrahedron> batch;
  for (int l = 0; l < kLanes; ++l) {
    const auto nodes = mesh.tetrahedra.col(first + l);
    const LinearTetrahedron::Positions x = mesh.positions(Eigen::all, nodes);
    batch.rests[static_cast<size_t>(l)] = tetrahedron_rest(x);
    batch.sizes(l) = tetrahedron_volume(x);
    set_positions(at, nodes, l, batch);
  }
  return batch;
}

Batch<TrilinearHexahedron> batch_of(const VolumeMesh& mesh, const Eigen::Matrix3Xd& at, int first,
                                    TrilinearHexahedron) {
  Batch<TrilinearHexahedron> batch;
  const auto nodes = mesh.hexahedra.col(first);
  const auto points = hexahedron_points(mesh.positions(Eigen::all, nodes));
  for (int l = 0; l < kLanes; ++l) {
    batch.rests[static_cast<size_t>(l)] = points[static_cast<size_t>(l)].rest;
    batch.sizes(l) = points[static_cast<size_t>(l)].size;
    set_positions(at, nodes, l, batch);
  }
  return batch;
}

template <class Measure>
void BM_HessianByFiniteDifferences(benchmark::State& run) {
  constexpr bool kTetrahedra = Measure::kNodes == 4;
  const VolumeMesh mesh = block(kTetrahedra);
  const Eigen::Matrix3Xd at = deformed(mesh.positions);
  const auto law = solid_density(rubber()).law;
  std::vector<Batch<Measure>> batches;
  constexpr int kElements = kTetrahedra ? kLanes : 1;  // of a batch
  for (int first = 0; first + kElements <= mesh.element_count(); first += kElements) {
    batches.push_back(batch_of(mesh, at, first, Measure()));
  }
  for (auto _ : run) {
    for (const Batch<Measure>& batch : batches) {
      benchmark::DoNotOptimize(stiffness(batch, *law).data());
    }
  }
  run.counters["us_an_element"] = benchmark::Counter(
      1e-6 * static_cast<double>(kElements * batches.size()),
      benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}
BENCHMARK(BM_HessianByFiniteDifferences<LinearTetrahedron>)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_HessianByFiniteDifferences<TrilinearHexahedron>)->Unit(benchmark::kMillisecond);

// 5616 tetrahedra that hang by an end and bend far, with volumes at nodes.
void BM_Equilibrium(benchmark::State& run) {
  const VolumeMesh mesh = block(true);
  System system(mesh.positions, 1000 * node_volumes(mesh));
  add_solid(system, mesh, solid_law(rubber()));
  for (const int node : nodes_at(mesh, 0, 0)) system.coordinates().prescribe(node);
  system.add(
      std::make_shared<PointForces>(Eigen::Vector3d(0, 0, -9.81) * system.masses().transpose()));
  system.finish();
  StaticSolver solver(system);
  NewtonSummary summary;
  for (auto _ : run) {
    State state = system.initial_state();
    summary = solver.find_equilibrium(state);
  }
  if (!summary.converged) run.SkipWithError("not converged");
  run.counters["iterations"] = summary.iterations;
  run.counters["factorizations"] = summary.factorizations;
}
BENCHMARK(BM_Equilibrium)->Unit(benchmark::kMillisecond);

/// The Hessian of the same system at rest.
struct RestHessian {
  VolumeMesh mesh = block(true);
  System system{mesh.positions, 1000 * node_volumes(mesh)};
  std::optional<Workspace> workspace;

  RestHessian() {
    add_solid(system, mesh, solid_law(rubber()));
    for (const int node : nodes_at(mesh, 0, 0)) system.coordinates().prescribe(node);
    system.finish();
    workspace.emplace(system);
    const State state = system.initial_state();
    Eigen::Matrix3Xd gradient;
    Objective(system, {state})
        .linearize(state.configuration, Curvature::convex, gradient, workspace->hessian);
  }
};

void BM_Factorization(benchmark::State& run) {
  RestHessian at;
  for (auto _ : run) {
    if (!at.workspace->solver->factorize(at.workspace->hessian.matrix)) {
      run.SkipWithError("indefinite");
    }
  }
}
BENCHMARK(BM_Factorization)->Unit(benchmark::kMillisecond);

// With its pattern analysed before.
void BM_FactorizationByCholmod(benchmark::State& run) {
  const RestHessian at;
  const Eigen::SparseMatrix<double> lower = at.workspace->hessian.matrix.lower_triangle();
  Eigen::CholmodSupernodalLLT<Eigen::SparseMatrix<double>, Eigen::Lower> factor;
  factor.analyzePattern(lower);
  for (auto _ : run) {
    factor.factorize(lower);
    if (factor.info() != Eigen::Success) run.SkipWithError("indefinite");
  }
}
BENCHMARK(BM_FactorizationByCholmod)->Unit(benchmark::kMillisecond);

}  // namespace
