// What the mechanics of cloth cost, against the thesis' own methods: finite-difference Hessians,
// dynamic relaxation, conjugate gradients for every parameter; and what a time step costs.

#include <cmath>

#include <Eigen/CholmodSupport>
#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCholesky>
#include <benchmark/benchmark.h>
#include <malloc.h>

#include "pliant/base/parallel.h"
#include "pliant/geometry/regular_grid.h"
#include "pliant/math/sparse_cholesky.h"
#include "pliant/mechanics/cloth_potentials.h"
#include "pliant/mechanics/point_forces.h"
#include "pliant/solver/dynamic_relaxation.h"
#include "pliant/solver/static_solver.h"
#include "pliant/solver/time_stepper.h"

namespace {

using namespace pliant;

MaterialComponent component(double k1, double k2, const DahlParameters& dahl) {
  MaterialComponent result;
  result.stiffness = ScalarCurve::affine(k1, k2);
  result.friction = ComponentFriction{dahl, {}};
  return result;
}

// [T] Table 5.1, warp; shear and bending of the size that such a fabric has.
Material cotton() {
  Material material;
  material.name = "cotton";
  material.density = 0.143;
  material.components["stretch.weft"] = component(135.6, 64.03, {2.22, 3.16, 0.006});
  material.components["stretch.warp"] = component(135.6, 64.03, {2.22, 3.16, 0.006});
  material.components["shear"] = component(20, 0, {0.5, 0, 0.01});
  for (const char* name : {"bend.weft", "bend.warp", "bend.diagonal"}) {
    material.components[name] = component(5e-6, 0, {2e-5, 0, 8});
  }
  return material;
}

// A sheet that hangs from two of its corners.
struct HangingSheet {
  TriangleMesh mesh;
  std::unique_ptr<System> system;

  HangingSheet(int nodes, double size, bool friction, bool upright = true)
      : mesh(regular_grid(size, size, nodes, nodes)) {
    const Material material = cotton();
    if (upright) mesh.positions.row(2).swap(mesh.positions.row(1));
    system = std::make_unique<System>(mesh.positions, material.density * vertex_areas(mesh));
    DensityOptions options;
    options.friction = friction;
    add_cloth(*system, mesh, material, options);
    const Eigen::Vector3d gravity(0, 0, -9.81);
    system->add(std::make_shared<PointForces>(gravity * system->masses().transpose()));
    system->coordinates().prescribe(nodes * (nodes - 1));
    system->coordinates().prescribe(nodes * nodes - 1);
    system->finish();
  }

  State equilibrium() const {
    State state = system->initial_state();
    StaticSolver(*system).find_equilibrium(state);
    return state;
  }

  // Every free point beside its place by up to `way`, smoothly over the sheet.
  void disturb(double way, Configuration& at) const {
    for (int i = 0; i < system->points(); ++i) {
      if (!system->coordinates().is_free(i)) continue;
      const Eigen::Vector2d u = mesh.rest_corners.rowwise().maxCoeff();
      const double x = mesh.positions(0, i) / u.x(), z = mesh.positions(2, i) / u.y();
      at.positions.col(i) += way * Eigen::Vector3d(std::sin(5 * x + 3 * z), std::sin(7 * x - 4 * z),
                                                   std::cos(4 * x + 6 * z));
    }
  }
};

constexpr int kThesisNodes = 25;  // [T] 3.4.1
constexpr double kThesisSize = 0.1;

void BM_HessianAnalytic(benchmark::State& run) {
  const HangingSheet sheet(kThesisNodes, kThesisSize, true);
  const State state = sheet.equilibrium();
  const Objective objective(*sheet.system, {state});
  Hessian hessian = sheet.system->make_hessian();
  Eigen::Matrix3Xd gradient;
  for (auto _ : run) {
    objective.linearize(state.configuration, Curvature::exact, gradient, hessian);
    benchmark::DoNotOptimize(hessian.matrix.block(0).data());
  }
}
BENCHMARK(BM_HessianAnalytic)->Unit(benchmark::kMillisecond);

// Points that no energy couples may be moved at once: forward differences of the forces, a group of
// such points and an axis at a time ([T] 4.3.1: "accounting for sparsity patterns").
std::vector<std::vector<int>> uncoupled_groups(const BlockPattern& pattern) {
  std::vector<std::vector<int>> neighbours(static_cast<size_t>(pattern.size()));
  for (int i = 0; i < pattern.size(); ++i) {
    for (int k = pattern.row_begin(i) + 1; k < pattern.row_end(i); ++k) {
      neighbours[static_cast<size_t>(i)].push_back(pattern.column(k));
      neighbours[static_cast<size_t>(pattern.column(k))].push_back(i);
    }
  }
  std::vector<int> group(neighbours.size(), -1);
  std::vector<std::vector<int>> groups;
  for (size_t i = 0; i < neighbours.size(); ++i) {
    std::vector<bool> taken(groups.size() + 1, false);
    for (const int j : neighbours[i]) {
      for (const int k : neighbours[static_cast<size_t>(j)]) {
        const int g = group[static_cast<size_t>(k)];
        if (g >= 0) taken[static_cast<size_t>(g)] = true;
      }
    }
    const auto free =
        static_cast<size_t>(std::find(taken.begin(), taken.end(), false) - taken.begin());
    if (free == groups.size()) groups.emplace_back();
    groups[free].push_back(static_cast<int>(i));
    group[i] = static_cast<int>(free);
  }
  return groups;
}

// Columns of the Hessian from the change of the forces with one axis of the points of some rows.
void put_columns(const std::vector<int>& rows, int axis, const Eigen::Matrix3Xd& changes,
                 const std::vector<int>& point_of_row, BlockMatrix& hessian) {
  const BlockPattern& pattern = hessian.pattern();
  for (const int row : rows) {
    for (int k = pattern.row_begin(row); k < pattern.row_end(row); ++k) {
      const int point = point_of_row[static_cast<size_t>(pattern.column(k))];
      hessian.block(k).row(axis) = changes.col(point).transpose();
    }
  }
}

void BM_HessianByForwardDifferences(benchmark::State& run) {
  const HangingSheet sheet(kThesisNodes, kThesisSize, true);
  const State state = sheet.equilibrium();
  const Objective objective(*sheet.system, {state});
  Hessian hessian = sheet.system->make_hessian();
  const auto groups = uncoupled_groups(hessian.matrix.pattern());
  const Coordinates& coordinates = sheet.system->coordinates();
  std::vector<int> point_of_row(static_cast<size_t>(coordinates.block_rows()));
  for (int i = 0; i < coordinates.points(); ++i) {
    if (coordinates.is_free(i)) point_of_row[static_cast<size_t>(coordinates.row(i))] = i;
  }
  constexpr double kStep = 1e-7;
  for (auto _ : run) {
    Configuration at = state.configuration;
    const Eigen::Matrix3Xd here = objective.gradient(at);
    for (const auto& rows : groups) {
      for (int axis = 0; axis < 3; ++axis) {
        for (const int row : rows)
          at.positions(axis, point_of_row[static_cast<size_t>(row)]) += kStep;
        const Eigen::Matrix3Xd changes = (objective.gradient(at) - here) / kStep;
        put_columns(rows, axis, changes, point_of_row, hessian.matrix);
        for (const int row : rows)
          at.positions(axis, point_of_row[static_cast<size_t>(row)]) -= kStep;
      }
    }
    benchmark::DoNotOptimize(hessian.matrix.block(0).data());
  }
  run.counters["force_evaluations"] = static_cast<double>(3 * groups.size() + 1);
}
BENCHMARK(BM_HessianByForwardDifferences)->Unit(benchmark::kMillisecond);

// The same sheet under one load, found from some distance to some tolerance.
struct EquilibriumProblem {
  HangingSheet sheet{kThesisNodes, kThesisSize, false};
  State start = sheet.equilibrium();
  Configuration exact;

  explicit EquilibriumProblem(double way) {
    State reference = start;
    StaticSolver(*sheet.system, {.tolerance = 1e-11}).find_equilibrium(reference);
    exact = reference.configuration;
    sheet.disturb(way, start.configuration);
  }

  double error_mm(const Configuration& at) const {
    return 1e3 * (at.positions - exact.positions).colwise().norm().maxCoeff();
  }
};

void find_by_newton(benchmark::State& run, double way) {
  const EquilibriumProblem problem(way);
  const double tolerance = std::pow(10.0, -static_cast<double>(run.range(0)));
  StaticSolver solver(*problem.sheet.system, {.tolerance = tolerance, .reuse_factor = true});
  NewtonSummary summary;
  State state;
  for (auto _ : run) {
    state = problem.start;
    summary = solver.find_equilibrium(state);
  }
  if (!summary.converged) run.SkipWithError("not converged");
  run.counters["iterations"] = summary.iterations;
  run.counters["factors"] = summary.factorizations;
  run.counters["error_mm"] = problem.error_mm(state.configuration);
}

// The argument is the tolerance: 10^-N newton.
void BM_EquilibriumFrom2mm(benchmark::State& run) { find_by_newton(run, 2e-3); }
BENCHMARK(BM_EquilibriumFrom2mm)->Arg(5)->Arg(8)->Unit(benchmark::kMillisecond);

void BM_EquilibriumFromNeighbour(benchmark::State& run) { find_by_newton(run, 0.1e-3); }
BENCHMARK(BM_EquilibriumFromNeighbour)->Arg(5)->Unit(benchmark::kMillisecond);

void BM_EquilibriumFrom2mmByDynamicRelaxation(benchmark::State& run) {
  const EquilibriumProblem problem(2e-3);
  const double tolerance = std::pow(10.0, -static_cast<double>(run.range(0)));
  Hessian hessian = problem.sheet.system->make_hessian();
  RelaxationSummary summary;
  Configuration at;
  for (auto _ : run) {
    at = problem.start.configuration;
    summary = relax(Objective(*problem.sheet.system, {problem.start}), {.tolerance = tolerance},
                    hessian, at);
  }
  if (!summary.converged) run.SkipWithError("not converged");
  run.counters["iterations"] = summary.iterations;
  run.counters["error_mm"] = problem.error_mm(at);
}
BENCHMARK(BM_EquilibriumFrom2mmByDynamicRelaxation)
    ->Arg(5)
    ->Arg(8)
    ->Unit(benchmark::kMillisecond)
    ->Iterations(1);

// The right-hand sides of [T] Eq. 3.7 at an equilibrium, and its matrix.
struct SensitivityProblem {
  HangingSheet sheet{kThesisNodes, kThesisSize, true};
  Hessian hessian = sheet.system->make_hessian();
  Eigen::MatrixXd forces;

  SensitivityProblem() {
    State state = sheet.equilibrium();
    state.history.setZero();  // friction loaded from the rest shape: every parameter matters
    Eigen::Matrix3Xd gradient;
    Objective(*sheet.system, {state})
        .linearize(state.configuration, Curvature::exact, gradient, hessian);
    const std::vector<int> by = sheet.system->all_parameters();
    const auto count = std::ssize(by);
    Eigen::MatrixXd by_parameter = Eigen::MatrixXd::Zero(3 * sheet.system->points(), count);
    sheet.system->add_force_sensitivity(state.configuration, {state}, by,
                                        Eigen::MatrixXd::Zero(state.history.size(), count),
                                        by_parameter);
    forces.resize(sheet.system->coordinates().unknowns(), count);
    for (Eigen::Index p = 0; p < count; ++p) {
      const Eigen::Matrix3Xd column = by_parameter.col(p).reshaped(3, sheet.system->points());
      forces.col(p) = sheet.system->coordinates().reduce(state.configuration, column);
    }
  }
};

void BM_SensitivitiesByBackSubstitution(benchmark::State& run) {
  const SensitivityProblem problem;
  SparseCholesky solver(problem.hessian.matrix);
  for (auto _ : run) {
    if (!solver.factorize(problem.hessian.matrix)) run.SkipWithError("not positive definite");
    for (Eigen::Index p = 0; p < problem.forces.cols(); ++p) {
      Eigen::VectorXd x;
      solver.solve(problem.forces.col(p), x);
      benchmark::DoNotOptimize(x.data());
    }
  }
  run.counters["parameters"] = static_cast<double>(problem.forces.cols());
}
BENCHMARK(BM_SensitivitiesByBackSubstitution)->Unit(benchmark::kMillisecond);

// The factorisation alone, in dense fronts and column by column.
void BM_FactorInFronts(benchmark::State& run) {
  const SensitivityProblem problem;
  SparseCholesky solver(problem.hessian.matrix);
  for (auto _ : run) benchmark::DoNotOptimize(solver.factorize(problem.hessian.matrix));
}
BENCHMARK(BM_FactorInFronts)->Unit(benchmark::kMillisecond);

void BM_FactorByColumns(benchmark::State& run) {
  const SensitivityProblem problem;
  Eigen::SparseMatrix<double> lower = problem.hessian.matrix.lower_triangle();
  Eigen::SimplicialLLT<Eigen::SparseMatrix<double>, Eigen::Lower> factor;
  factor.analyzePattern(lower);
  for (auto _ : run) {
    problem.hessian.matrix.copy_to(lower);
    factor.factorize(lower);
    benchmark::DoNotOptimize(factor.info());
  }
}
BENCHMARK(BM_FactorByColumns)->Unit(benchmark::kMillisecond);

// By the library that Ceres brings with it.
template <class Factor>
void BM_FactorByCholmod(benchmark::State& run) {
  const SensitivityProblem problem;
  Eigen::SparseMatrix<double> lower = problem.hessian.matrix.lower_triangle();
  Factor factor;
  factor.analyzePattern(lower);
  for (auto _ : run) {
    problem.hessian.matrix.copy_to(lower);
    factor.factorize(lower);
    benchmark::DoNotOptimize(factor.info());
  }
}
BENCHMARK_TEMPLATE(BM_FactorByCholmod,
                   Eigen::CholmodSupernodalLLT<Eigen::SparseMatrix<double>, Eigen::Lower>)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_TEMPLATE(BM_FactorByCholmod,
                   Eigen::CholmodSimplicialLLT<Eigen::SparseMatrix<double>, Eigen::Lower>)
    ->Unit(benchmark::kMillisecond);

// The argument is the relative residual, 10^-N; back-substitution leaves about 10^-12.
void BM_SensitivitiesByConjugateGradients(benchmark::State& run) {
  const SensitivityProblem problem;
  const Eigen::SparseMatrix<double> matrix = problem.hessian.matrix.lower_triangle();
  Eigen::ConjugateGradient<Eigen::SparseMatrix<double>, Eigen::Lower> solver;
  solver.setTolerance(std::pow(10.0, -static_cast<double>(run.range(0))));
  solver.setMaxIterations(100000);
  double iterations = 0;
  for (auto _ : run) {
    solver.compute(matrix);
    for (Eigen::Index p = 0; p < problem.forces.cols(); ++p) {
      Eigen::VectorXd x = solver.solve(problem.forces.col(p));
      benchmark::DoNotOptimize(x.data());
      iterations += static_cast<double>(solver.iterations());
    }
  }
  run.counters["iterations"] = iterations;
}
BENCHMARK(BM_SensitivitiesByConjugateGradients)
    ->Arg(8)
    ->Arg(12)
    ->Unit(benchmark::kMillisecond)
    ->Iterations(1);

// Steps of examples/step-29k.yaml: arguments are the step in ms, friction, how it is solved (0
// linearized, 1 iterated, 2 converged) and threads.
void BM_Step29k(benchmark::State& run) {
  const HangingSheet sheet(121, 1, run.range(1) != 0, false);
  TimeStepOptions options;
  options.step = static_cast<double>(run.range(0)) * 1e-3;
  options.solve = static_cast<StepSolve>(run.range(2));
  TimeStepper stepper(*sheet.system, options);
  State state = sheet.system->initial_state();
  double linear = 0, newton = 0;
  with_threads(static_cast<int>(run.range(3)), [&] {
    for (auto _ : run) {
      const StepSummary step = stepper.advance(state);
      if (!step.converged) run.SkipWithError("not converged");
      linear += step.linear_iterations;
      newton += step.newton_iterations;
    }
  });
  run.counters["linear_iterations"] = linear / static_cast<double>(run.iterations());
  run.counters["newton_iterations"] = newton / static_cast<double>(run.iterations());
}
BENCHMARK(BM_Step29k)
    ->ArgNames({"ms", "friction", "solve", "threads"})
    ->ArgsProduct({{1, 5}, {0, 1}, {0, 1, 2}, {1}})
    ->ArgsProduct({{1, 5}, {1}, {0, 1, 2}, {2}})
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond)
    ->Iterations(50);

double bytes_in_use() {
  const struct mallinfo2 heap = mallinfo2();
  return static_cast<double>(heap.uordblks) + static_cast<double>(heap.hblkhd);
}

// One linearised step of 1 ms at one edge length and more and more triangles.
void BM_StepOfTriangles(benchmark::State& run) {
  const int nodes = static_cast<int>(run.range(0));
  const double before = bytes_in_use();
  const HangingSheet sheet(nodes, (nodes - 1) / 120.0, true, false);
  TimeStepOptions options;
  options.solve = StepSolve::linearized;
  TimeStepper stepper(*sheet.system, options);
  State state = sheet.system->initial_state();
  for (auto _ : run) stepper.advance(state);
  run.SetItemsProcessed(run.iterations() * sheet.mesh.triangle_count());
  run.counters["triangles"] = sheet.mesh.triangle_count();
  run.counters["bytes_per_triangle"] = (bytes_in_use() - before) / sheet.mesh.triangle_count();
}
BENCHMARK(BM_StepOfTriangles)
    ->Arg(72)
    ->Arg(124)
    ->Arg(225)
    ->Arg(388)
    ->Unit(benchmark::kMillisecond)
    ->Iterations(30);

}  // namespace
