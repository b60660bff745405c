#pragma once

#include <array>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include <Eigen/LU>

#include "pliant/material/density/density.h"
#include "pliant/material/density/stiffness_density.h"
#include "pliant/mechanics/solid.h"

namespace pliant::test {

/// Energy, stress and tangent of one point, as functions of Green strain.
struct PointResponse {
  double energy = 0;
  Eigen::Matrix<double, 6, 1> stress = Eigen::Matrix<double, 6, 1>::Zero();
  Eigen::Matrix<double, 6, 6> tangent = Eigen::Matrix<double, 6, 6>::Zero();
};

/// What the terms of solids' laws are made of: C = 2 E + 1, its invariants and its inverse.
struct CauchyGreen {
  using Vector = Eigen::Matrix<double, 6, 1>;
  using Matrix = Eigen::Matrix<double, 6, 6>;

  double trace = 0, volume = 0;  ///< tr C and J
  Vector one, inverse;           ///< 1 and C^-1 as stresses stand
  Matrix inverse_change;         ///< -d C^-1 / d E

  explicit CauchyGreen(const Vector& e) {
    Eigen::Matrix3d c;
    c << 1 + 2 * e(0), e(5), e(4), e(5), 1 + 2 * e(1), e(3), e(4), e(3), 1 + 2 * e(2);
    constexpr int kAxes[6][2] = {{0, 0}, {1, 1}, {2, 2}, {1, 2}, {0, 2}, {0, 1}};
    const Eigen::Matrix3d b = c.inverse();
    trace = c.trace();
    volume = std::sqrt(c.determinant());
    one << 1, 1, 1, 0, 0, 0;
    for (int v = 0; v < 6; ++v) {
      const auto [i, j] = kAxes[v];
      inverse(v) = b(i, j);
      for (int u = 0; u < 6; ++u) {
        const auto [k, l] = kAxes[u];
        inverse_change(v, u) = b(i, k) * b(j, l) + b(i, l) * b(j, k);
      }
    }
  }
};

/// A law of six strains that is a sum of terms, each times a parameter.
class SolidTerms : public ParametricDensity {
 public:
  using Term = PointResponse (*)(const Eigen::Matrix<double, 6, 1>& strain);

  SolidTerms(std::vector<Term> terms, Eigen::VectorXd values)
      : terms_(std::move(terms)), values_(std::move(values)) {}

  int history_size() const override { return 0; }
  void add(const Samples& samples, const StepTime&, Response& response) const override {
    for (int l = 0; l < kLanes; ++l) {
      for (size_t t = 0; t < terms_.size(); ++t) {
        const PointResponse own = terms_[t](samples.strain.row(l).transpose().matrix());
        const double factor = values_(static_cast<Eigen::Index>(t));
        response.stored(l) += factor * own.energy;
        response.stress.row(l) += factor * own.stress.transpose().array();
        for (int i = 0; i < 36; ++i) response.tangent(l, i) += factor * own.tangent(i % 6, i / 6);
      }
    }
  }
  void advance(const Samples&, const StepTime&, MutableLaneView, Lane&) const override {}
  Eigen::VectorXd parameters() const override { return values_; }
  std::unique_ptr<ParametricDensity> with_parameters(const Eigen::VectorXd& values) const override {
    return std::make_unique<SolidTerms>(terms_, values);
  }
  void differentiate(const Samples& samples, int lane, int, int first_parameter,
                     SampleDerivatives& derivatives) const override {
    for (size_t t = 0; t < terms_.size(); ++t) {
      const PointResponse own = terms_[t](samples.strain.row(lane).transpose().matrix());
      derivatives.stress_by_parameter.col(first_parameter + static_cast<Eigen::Index>(t)) =
          own.stress;
    }
  }

 private:
  std::vector<Term> terms_;
  Eigen::VectorXd values_;
};

/// tr(E)^2 / 2.
inline PointResponse square_of_trace(const Eigen::Matrix<double, 6, 1>& e) {
  const CauchyGreen c(e);
  const double trace = e.head<3>().sum();
  return {trace * trace / 2, trace * c.one, c.one * c.one.transpose()};
}

/// tr(E^2).
inline PointResponse trace_of_square(const Eigen::Matrix<double, 6, 1>& e) {
  PointResponse r;
  Eigen::Matrix<double, 6, 1> weights;
  weights << 1, 1, 1, 0.5, 0.5, 0.5;
  r.energy = e.cwiseProduct(weights).dot(e);
  r.stress = 2 * weights.cwiseProduct(e);
  r.tangent.diagonal() = 2 * weights;
  return r;
}

/// (tr C - 3) / 2 - ln J.
inline PointResponse neo_hookean_shear(const Eigen::Matrix<double, 6, 1>& e) {
  const CauchyGreen c(e);
  return {(c.trace - 3) / 2 - std::log(c.volume), c.one - c.inverse, c.inverse_change};
}

/// (ln J)^2 / 2.
inline PointResponse square_of_logarithm(const Eigen::Matrix<double, 6, 1>& e) {
  const CauchyGreen c(e);
  const double logarithm = std::log(c.volume);
  return {logarithm * logarithm / 2, logarithm * c.inverse,
          c.inverse * c.inverse.transpose() - logarithm * c.inverse_change};
}

/// (J^(-2/3) tr C - 3) / 2.
inline PointResponse isochoric_shear(const Eigen::Matrix<double, 6, 1>& e) {
  const CauchyGreen c(e);
  const double scale = std::pow(c.volume, -2.0 / 3);
  const auto cross = c.one * c.inverse.transpose();
  return {(scale * c.trace - 3) / 2, scale * (c.one - c.trace / 3 * c.inverse),
          scale * (-2.0 / 3 * (cross + cross.transpose()) +
                   2.0 / 9 * c.trace * c.inverse * c.inverse.transpose() +
                   c.trace / 3 * c.inverse_change)};
}

/// (J - 1)^2 / 2.
inline PointResponse square_of_dilatation(const Eigen::Matrix<double, 6, 1>& e) {
  const CauchyGreen c(e);
  const double j = c.volume;
  return {(j - 1) * (j - 1) / 2, (j - 1) * j * c.inverse,
          (2 * j - 1) * j * c.inverse * c.inverse.transpose() - (j - 1) * j * c.inverse_change};
}

/// Stiffness in tension and Poisson's ratio as other pairs of numbers.
struct ElasticModuli {
  double young = 0, poisson = 0;
  double shear() const { return young / (2 * (1 + poisson)); }
  double lambda() const { return young * poisson / ((1 + poisson) * (1 - 2 * poisson)); }
  double bulk() const { return young / (3 * (1 - 2 * poisson)); }
};

inline SolidLaw law_of_terms(std::vector<SolidTerms::Term> terms, const Eigen::VectorXd& values) {
  SolidLaw law;
  law.of_points = std::make_shared<SolidTerms>(std::move(terms), values);
  return law;
}

/// St. Venant-Kirchhoff ([T] Eq. 4.3).
inline SolidLaw stvk_law(const ElasticModuli& m) {
  return law_of_terms({square_of_trace, trace_of_square}, Eigen::Vector2d(m.lambda(), m.shear()));
}

inline SolidLaw neo_hookean_law(const ElasticModuli& m) {
  return law_of_terms({neo_hookean_shear, square_of_logarithm},
                      Eigen::Vector2d(m.shear(), m.lambda()));
}

/// mu (J^(-2/3) tr C - 3) / 2 + kappa (J - 1)^2 / 2, all of it at the points.
inline SolidLaw pointwise_rubber_law(const ElasticModuli& m) {
  return law_of_terms({isochoric_shear, square_of_dilatation},
                      Eigen::Vector2d(m.shear(), m.bulk()));
}

/// The same with one volume an element, or a node of tetrahedra.
inline SolidLaw rubber_law(const ElasticModuli& m) {
  SolidLaw law = law_of_terms({isochoric_shear}, Eigen::VectorXd::Constant(1, m.shear()));
  law.of_volume = std::make_shared<StiffnessDensity>(0, ScalarCurve::constant(m.bulk()));
  return law;
}

}  // namespace pliant::test
