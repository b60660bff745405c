#include "pliant/estimation/solid/convexity.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include <Eigen/Eigenvalues>

#include "pliant/base/assert.h"
#include "pliant/estimation/sampled_numbers.h"
#include "pliant/estimation/solid/solid_problem.h"
#include "pliant/material/solid/pair_metric.h"
#include "pliant/material/solid/solid_density.h"
#include "pliant/material/strain/green_strain.h"
#include "pliant/math/hermite_energy.h"

namespace pliant {
namespace {

constexpr int kSamplesAlong = 9;     // of either strain
constexpr double kTolerance = 1e-6;  // of the largest second derivative

using SolidStrain = Eigen::Matrix<double, kSolidStrains, 1>;
using Hessians = std::vector<Eigen::Matrix2d>;

/// Where a component's numbers begin, and its law.
struct Block {
  Eigen::Index first;
  ScalarCurve stiffness;
};

/// The blocks of numbers in the order of `set_numbers`.
std::vector<Block> blocks_of(const Material& material, Eigen::Index& count) {
  std::vector<Block> blocks;
  count = 0;
  for (const std::string& name : ordered_components(material.components, material.kind)) {
    const auto law = law_of(material, name);
    if (!law) continue;
    for (int k = 0; k < copies_of(material, name); ++k) {
      blocks.push_back({count, law->stiffness});
      count += law->parameter_count();
    }
  }
  return blocks;
}

Eigen::MatrixXd rows_of_energies(const std::vector<Block>& blocks, Eigen::Index count) {
  Eigen::MatrixXd rows(0, count);
  for (const auto& [first, curve] : blocks) {
    if (curve.kind() != CurveKind::energy) continue;
    const Eigen::MatrixXd own = hermite_energy_curvatures(curve.knots());
    const Eigen::Index before = rows.rows();
    rows.conservativeResize(before + own.rows(), count);
    rows.bottomRows(own.rows()).setZero();
    rows.block(before, first, own.rows(), own.cols()) = own;
  }
  return rows;
}

bool is_possible(const SolidStrain& strain) {
  Eigen::Matrix3d deformation;  // C = 2 E + 1
  for (int a = 0; a < 3; ++a) {
    for (int b = 0; b < 3; ++b) {
      const double value = strain(kSolidStrainOf[a][b]);
      deformation(a, b) = a == b ? 2 * value + 1 : value;
    }
  }
  constexpr double kLeastSquare = 1e-3;  // of a stretch
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(deformation, Eigen::EigenvaluesOnly);
  return solver.eigenvalues()(0) > kLeastSquare;
}

std::vector<SolidStrain> samples_of(const PairDomain& domain) {
  const auto at = [&](std::size_t side, int i) {
    const auto [low, high] = domain.range[side];
    return low + (high - low) * i / (kSamplesAlong - 1);
  };
  std::vector<SolidStrain> samples;
  for (int i = 0; i < kSamplesAlong; ++i) {
    for (int j = 0; j < kSamplesAlong; ++j) {
      SolidStrain strain = SolidStrain::Zero();
      strain(domain.strains[0]) = at(0, i);
      strain(domain.strains[1]) = at(1, j);
      if (is_possible(strain)) samples.push_back(strain);
    }
  }
  return samples;
}

/// Second derivatives of a material's energy in two strains.
Hessians hessians_of(const Material& material, const PairDomain& domain,
                     const std::vector<SolidStrain>& samples) {
  const NamedLaw density = solid_density(by_green_strains(material), {.friction = false});
  const Eigen::Array<double, kLanes, Eigen::Dynamic> history =
      Eigen::Array<double, kLanes, Eigen::Dynamic>::Zero(kLanes, density.law->history_size());
  Hessians hessians;
  for (std::size_t first = 0; first < samples.size(); first += kLanes) {
    Eigen::Array<double, kLanes, kSolidStrains> strains;
    for (int lane = 0; lane < kLanes; ++lane) {
      const std::size_t own = std::min(first + static_cast<std::size_t>(lane), samples.size() - 1);
      strains.row(lane) = samples[own].transpose().array();
    }
    const LaneView strain(strains.data(), kLanes, kSolidStrains);
    Response response(kSolidStrains);
    density.law->add({strain, strain, strain, LaneView(history.data(), kLanes, history.cols())}, {},
                     response);
    for (int lane = 0; lane < kLanes && hessians.size() < samples.size(); ++lane) {
      Eigen::Matrix2d& hessian = hessians.emplace_back();
      for (int i = 0; i < 2; ++i) {
        for (int j = 0; j < 2; ++j) {
          const auto [x, y] = std::pair(domain.strains[static_cast<std::size_t>(i)],
                                        domain.strains[static_cast<std::size_t>(j)]);
          hessian(i, j) = response.tangent(lane, kSolidStrains * x + y);
        }
      }
    }
  }
  return hessians;
}

/// Second derivatives at the samples of a domain by each number.
struct LinearHessians {
  std::vector<Hessians> by_number;

  std::size_t samples() const { return by_number.front().size(); }
  Eigen::Matrix2d at(std::size_t sample, const Eigen::VectorXd& numbers) const {
    Eigen::Matrix2d sum = Eigen::Matrix2d::Zero();
    for (std::size_t i = 0; i < by_number.size(); ++i) {
      sum += numbers(static_cast<Eigen::Index>(i)) * by_number[i][sample];
    }
    return sum;
  }
};

LinearHessians linear_hessians(Material material, const PairDomain& domain, Eigen::Index count) {
  const std::vector<SolidStrain> samples = samples_of(domain);
  LinearHessians result;
  for (Eigen::Index i = 0; i < count; ++i) {
    set_numbers(Eigen::VectorXd::Unit(count, i), material);
    result.by_number.push_back(hessians_of(material, domain, samples));
  }
  return result;
}

using Eigen2d = Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>;

/// One condition for each sample at which an energy is concave.
Eigen::MatrixXd violated_at(const std::vector<LinearHessians>& domains,
                            const Eigen::VectorXd& numbers) {
  std::vector<Eigen::VectorXd> rows;
  for (const LinearHessians& domain : domains) {
    std::vector<Eigen2d> solved;
    double largest = 0;
    for (std::size_t s = 0; s < domain.samples(); ++s) {
      solved.emplace_back(domain.at(s, numbers));
      largest = std::max(largest, solved.back().eigenvalues().cwiseAbs().maxCoeff());
    }
    for (std::size_t s = 0; s < solved.size(); ++s) {
      if (solved[s].eigenvalues()(0) >= -kTolerance * largest) continue;
      const Eigen::Vector2d v = solved[s].eigenvectors().col(0);
      Eigen::VectorXd& row = rows.emplace_back(numbers.size());
      for (std::size_t i = 0; i < domain.by_number.size(); ++i) {
        row(static_cast<Eigen::Index>(i)) = v.dot(domain.by_number[i][s] * v);
      }
    }
  }
  Eigen::MatrixXd matrix(std::ssize(rows), numbers.size());
  for (std::size_t r = 0; r < rows.size(); ++r) {
    matrix.row(static_cast<Eigen::Index>(r)) = rows[r].transpose();
  }
  return matrix;
}

}  // namespace

Material by_green_strains(const Material& material) {
  Material elastic = material;
  elastic.limits.clear();
  std::erase_if(elastic.components, [](const auto& component) {
    return !component.first.starts_with("green.") && !component.first.starts_with("trace");
  });
  return elastic;
}

ConvexSet convex_numbers(const Material& form, const std::vector<PairDomain>& domains) {
  Material material = form;
  material.limits.clear();
  Eigen::Index count = 0;
  const std::vector<Block> blocks = blocks_of(material, count);
  const auto limits = static_cast<Eigen::Index>(form.limits.size());
  ConvexSet set{rows_of_energies(blocks, count + limits), {}};
  if (domains.empty()) return set;
  std::vector<LinearHessians> hessians;
  for (const PairDomain& domain : domains) {
    hessians.push_back(linear_hessians(material, domain, count));
  }
  set.violated = [hessians = std::move(hessians), count](const Eigen::VectorXd& numbers) {
    const Eigen::MatrixXd own = violated_at(hessians, numbers.head(count));
    Eigen::MatrixXd rows = Eigen::MatrixXd::Zero(own.rows(), numbers.size());
    rows.leftCols(count) = own;
    return rows;
  };
  return set;
}

double least_convexity(const Material& material, const PairDomain& domain) {
  double least = INFINITY, largest = 0;
  for (const Eigen::Matrix2d& hessian : hessians_of(material, domain, samples_of(domain))) {
    const Eigen::Vector2d values = Eigen2d(hessian, Eigen::EigenvaluesOnly).eigenvalues();
    least = std::min(least, values(0));
    largest = std::max(largest, values.cwiseAbs().maxCoeff());
  }
  return largest > 0 ? least / largest : 0;
}

std::optional<PairDomain> stated_domain(const Material& material, const std::string& pair) {
  const auto metric = find_pair_metric(pair);
  PLIANT_ASSERT(metric.has_value(), "a term of two strains");
  PairDomain domain;
  domain.strains = metric->strains;
  for (std::size_t side = 0; side < 2; ++side) {
    auto& [low, high] = domain.range[side];
    for (const auto& [name, component] : material.components) {
      const auto other = find_pair_metric(name);
      if (other && other->strains == metric->strains && other->bump) {
        low = std::min(low, other->bump->place[side]);
        high = std::max(high, other->bump->place[side]);
      }
      if (name == metric->of()[side] && component.range) {
        low = std::min(low, component.range->first);
        high = std::max(high, component.range->second);
      }
    }
    if (low == high) return std::nullopt;
  }
  return domain;
}

}  // namespace pliant
