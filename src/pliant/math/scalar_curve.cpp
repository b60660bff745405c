#include "pliant/math/scalar_curve.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "pliant/base/assert.h"
#include "pliant/math/hermite_energy.h"
#include "pliant/math/tangent_spline.h"

namespace pliant {
namespace {

// A cubic in t by its coefficients: c[0] + c[1] t + c[2] t^2 + c[3] t^3.
using Cubic = std::array<double, 4>;

// Hermite basis on [0, 1]: value and tangent at the left end, then at the right end.
constexpr std::array<Cubic, 4> kHermiteBasis{{
    {1, 0, -3, 2},
    {0, 1, -2, 1},
    {0, 0, 3, -2},
    {0, 0, -1, 1},
}};

double evaluate(const Cubic& c, double t) { return c[0] + t * (c[1] + t * (c[2] + t * c[3])); }

double derivative(const Cubic& c, double t) { return c[1] + t * (2 * c[2] + t * 3 * c[3]); }

double integral(const Cubic& c, double t) {
  return t * (c[0] + t * (c[1] / 2 + t * (c[2] / 3 + t * c[3] / 4)));
}

double first_moment(const Cubic& c, double t) {
  return t * t * (c[0] / 2 + t * (c[1] / 3 + t * (c[2] / 4 + t * c[3] / 5)));
}

Eigen::MatrixXd tangent_matrix(const std::vector<double>& x, bool level_at_rest) {
  const auto n = static_cast<Eigen::Index>(x.size());
  Eigen::MatrixXd tangents = Eigen::MatrixXd::Zero(n, n);
  for (Eigen::Index i = level_at_rest ? 1 : 0; i < n && n > 1; ++i) {
    const Eigen::Index left = std::max<Eigen::Index>(i - 1, 0);
    const Eigen::Index right = std::min<Eigen::Index>(i + 1, n - 1);
    const double span = x[static_cast<size_t>(right)] - x[static_cast<size_t>(left)];
    tangents(i, right) += 1 / span;
    tangents(i, left) -= 1 / span;
  }
  return tangents;
}

// Weights of the four Hermite functions on one span, spread over the control values.
void add_span(const Eigen::MatrixXd& tangents, Eigen::Index span, double length,
              const std::array<double, 4>& w, Eigen::VectorXd& weights) {
  weights(span) += w[0];
  weights(span + 1) += w[2];
  weights += length * (w[1] * tangents.row(span) + w[3] * tangents.row(span + 1)).transpose();
}

template <class Function>
std::array<double, 4> on_basis(Function f) {
  return {f(kHermiteBasis[0]), f(kHermiteBasis[1]), f(kHermiteBasis[2]), f(kHermiteBasis[3])};
}

struct HermiteShape {
  const std::vector<double>& knots;
  const Eigen::MatrixXd& tangents;

  Eigen::Index size() const { return tangents.rows(); }
  double knot(Eigen::Index i) const { return knots[static_cast<size_t>(i)]; }

  // The span that holds x; x lies within the knots and there are at least two of them.
  Eigen::Index span_of(double x) const {
    const auto above = std::upper_bound(knots.begin() + 1, knots.end() - 1, x);
    return above - knots.begin() - 1;
  }

  // A function of the four Hermite cubics at x, summed with the values and tangents of its span.
  template <class Function>
  double on_span(double x, const Eigen::VectorXd& slopes, const std::vector<double>& values,
                 Function f) const {
    const Eigen::Index i = span_of(x);
    const auto k = static_cast<size_t>(i);
    const double h = knots[k + 1] - knots[k];
    const double t = (x - knots[k]) / h;
    return f(kHermiteBasis[0], t) * values[k] + f(kHermiteBasis[2], t) * values[k + 1] +
           h * (f(kHermiteBasis[1], t) * slopes(i) + f(kHermiteBasis[3], t) * slopes(i + 1));
  }

  Eigen::VectorXd value(double x) const {
    Eigen::VectorXd weights = Eigen::VectorXd::Zero(size());
    if (x <= knots.front()) {
      weights(0) = 1;
    } else if (x >= knots.back()) {
      weights(size() - 1) = 1;
    } else {
      const Eigen::Index i = span_of(x);
      const double h = knot(i + 1) - knot(i);
      const double t = (x - knot(i)) / h;
      add_span(tangents, i, h, on_basis([t](const Cubic& c) { return evaluate(c, t); }), weights);
    }
    return weights;
  }

  Eigen::VectorXd slope(double x) const {
    Eigen::VectorXd weights = Eigen::VectorXd::Zero(size());
    if (x <= knots.front() || x >= knots.back()) return weights;
    const Eigen::Index i = span_of(x);
    const double h = knot(i + 1) - knot(i);
    const double t = (x - knot(i)) / h;
    add_span(tangents, i, h, on_basis([t, h](const Cubic& c) { return derivative(c, t) / h; }),
             weights);
    return weights;
  }

  // Integral of curve(t) t^order dt from the first knot to x, order 0 or 1.
  Eigen::VectorXd primitive(double x, int order) const {
    Eigen::VectorXd weights = Eigen::VectorXd::Zero(size());
    const auto power = [order](double from, double to) {
      return order == 0 ? to - from : (to * to - from * from) / 2;
    };
    if (x <= knots.front()) {
      weights(0) = power(knots.front(), x);
      return weights;
    }
    for (Eigen::Index i = 0; i + 1 < size() && knot(i) < x; ++i) {
      const double h = knot(i + 1) - knot(i);
      const double t = std::min((x - knot(i)) / h, 1.0);
      const double start = knot(i);
      add_span(tangents, i, h, on_basis([=](const Cubic& c) {
                 const double flat = h * integral(c, t);
                 return order == 0 ? flat : start * flat + h * h * first_moment(c, t);
               }),
               weights);
    }
    if (x > knots.back()) weights(size() - 1) += power(knots.back(), x);
    return weights;
  }
};

Eigen::VectorXd pair(double first, double second) { return Eigen::Vector2d(first, second); }

Eigen::VectorXd single(double weight) { return Eigen::VectorXd::Constant(1, weight); }

double sign(double x) { return x < 0 ? -1 : 1; }

void require_knots(const std::vector<double>& knots, const std::vector<double>& values, bool even) {
  PLIANT_ASSERT(!knots.empty() && knots.size() == values.size(),
                "a curve has as many knots as values, at least one");
  PLIANT_ASSERT(
      std::adjacent_find(knots.begin(), knots.end(), std::greater_equal<>()) == knots.end(),
      "the knots of a curve increase");
  PLIANT_ASSERT(!even || knots.front() >= 0, "an even curve has no negative knots");
}

}  // namespace

std::string_view name_of(CurveKind kind) {
  switch (kind) {
    case CurveKind::none:
      return "none";
    case CurveKind::constant:
      return "constant";
    case CurveKind::affine:
      return "affine";
    case CurveKind::hermite:
      return "hermite";
    case CurveKind::spline:
      return "spline";
    case CurveKind::energy:
      return "energy";
  }
  return "";
}

ScalarCurve::ScalarCurve(CurveKind kind, std::vector<double> knots, std::vector<double> values,
                         bool even)
    : kind_(kind), even_(even), knots_(std::move(knots)), values_(std::move(values)) {
  if (kind_ != CurveKind::hermite) return;
  // Mirrored at a control point at 0 a curve with a slope there would have an edge.
  tangents_ = tangent_matrix(knots_, even_ && knots_.front() == 0);
  update_tangents();
}

void ScalarCurve::update_tangents() {
  slopes_ = tangents_ * Eigen::Map<const Eigen::VectorXd>(values_.data(), size());
  const HermiteShape shape{knots_, tangents_};
  moments_.clear();
  for (const double knot : knots_) moments_.push_back(apply(shape.primitive(knot, 1)));
}

ScalarCurve ScalarCurve::none() { return {CurveKind::none, {}, {}, true}; }

ScalarCurve ScalarCurve::constant(double value) { return {CurveKind::constant, {}, {value}, true}; }

ScalarCurve ScalarCurve::affine(double k1, double k2) {
  return {CurveKind::affine, {}, {k1, k2}, true};
}

ScalarCurve ScalarCurve::hermite(std::vector<double> knots, std::vector<double> values, bool even) {
  require_knots(knots, values, even);
  return {CurveKind::hermite, std::move(knots), std::move(values), even};
}

ScalarCurve ScalarCurve::spline(std::vector<double> knots, std::vector<double> values, bool even) {
  require_knots(knots, values, even);
  return {CurveKind::spline, std::move(knots), std::move(values), even};
}

ScalarCurve ScalarCurve::energy(std::vector<double> knots, std::vector<double> values, bool even) {
  require_knots(knots, values, even);
  PLIANT_ASSERT(std::ranges::find(knots, 0.0) == knots.end(),
                "an energy is zero at rest, which is no control point of it");
  return {CurveKind::energy, std::move(knots), std::move(values), even};
}

ScalarCurve ScalarCurve::with_values(const double* values) const {
  ScalarCurve other = *this;
  std::copy_n(values, values_.size(), other.values_.begin());
  if (kind_ == CurveKind::hermite) other.update_tangents();
  return other;
}

double ScalarCurve::apply(const Eigen::VectorXd& weights) const {
  return weights.dot(Eigen::Map<const Eigen::VectorXd>(values_.data(), size()));
}

// value and slope are what paths and simulations ask for again and again: no weights, no
// allocation.
double ScalarCurve::value(double x) const {
  if (kind_ == CurveKind::none) return 0;
  if (kind_ == CurveKind::constant) return values_[0];
  if (kind_ == CurveKind::affine) return values_[0] + values_[1] * std::abs(x);
  if (is_of_energy()) return apply(weights(x));
  const HermiteShape shape{knots_, tangents_};
  const double at = even_ ? std::abs(x) : x;
  if (at <= knots_.front()) return values_.front();
  if (at >= knots_.back()) return values_.back();
  return shape.on_span(at, slopes_, values_, evaluate);
}

double ScalarCurve::slope(double x) const {
  if (kind_ == CurveKind::none || kind_ == CurveKind::constant) return 0;
  if (kind_ == CurveKind::affine) return values_[1] * sign(x);
  if (is_of_energy()) return apply(slope_weights(x));
  const HermiteShape shape{knots_, tangents_};
  const double at = even_ ? std::abs(x) : x;
  if (at <= knots_.front() || at >= knots_.back()) return 0;
  const auto i = static_cast<size_t>(shape.span_of(at));
  const double per_length = 1 / (knots_[i + 1] - knots_[i]);
  return (even_ ? sign(x) : 1) * per_length * shape.on_span(at, slopes_, values_, derivative);
}

double ScalarCurve::integral(double x) const { return apply(integral_weights(x)); }

double ScalarCurve::first_moment(double x) const {
  if (kind_ == CurveKind::none) return 0;
  const double magnitude = std::abs(x);
  if (kind_ == CurveKind::constant) return values_[0] * x * x / 2;
  if (kind_ == CurveKind::affine) return x * x * (values_[0] / 2 + values_[1] * magnitude / 3);
  if (is_of_energy()) return apply(first_moment_weights(x));
  return first_moment_from_front(even_ ? magnitude : x) - first_moment_from_front(0);
}

double ScalarCurve::first_moment_from_front(double x) const {
  const auto between = [](double from, double to) { return (to * to - from * from) / 2; };
  if (x <= knots_.front()) return values_.front() * between(knots_.front(), x);
  if (x >= knots_.back()) return moments_.back() + values_.back() * between(knots_.back(), x);
  const HermiteShape shape{knots_, tangents_};
  const auto i = static_cast<size_t>(shape.span_of(x));
  const double h = knots_[i + 1] - knots_[i], start = knots_[i];
  return moments_[i] + shape.on_span(x, slopes_, values_, [=](const Cubic& c, double t) {
    return h * (start * pliant::integral(c, t) + h * pliant::first_moment(c, t));
  });
}

Eigen::VectorXd ScalarCurve::weights(double x) const {
  if (kind_ == CurveKind::none) return {};
  if (kind_ == CurveKind::constant) return single(1);
  if (kind_ == CurveKind::affine) return pair(1, std::abs(x));
  const double at = even_ ? std::abs(x) : x;
  if (kind_ == CurveKind::spline) return spline_secant_weights(knots_, at);
  if (kind_ == CurveKind::energy) return hermite_energy_secant_weights(knots_, at);
  return HermiteShape{knots_, tangents_}.value(at);
}

Eigen::VectorXd ScalarCurve::slope_weights(double x) const {
  if (kind_ == CurveKind::none) return {};
  if (kind_ == CurveKind::constant) return single(0);
  if (kind_ == CurveKind::affine) return pair(0, sign(x));
  if (is_of_energy()) {
    const double at = even_ ? std::abs(x) : x;
    const auto weights_of = kind_ == CurveKind::spline ? spline_secant_slope_weights
                                                       : hermite_energy_secant_slope_weights;
    return (even_ ? sign(x) : 1) * weights_of(knots_, at);
  }
  const HermiteShape shape{knots_, tangents_};
  if (!even_) return shape.slope(x);
  return sign(x) * shape.slope(std::abs(x));
}

Eigen::VectorXd ScalarCurve::integral_weights(double x) const {
  if (kind_ == CurveKind::none) return {};
  if (kind_ == CurveKind::constant) return single(x);
  if (kind_ == CurveKind::affine) return pair(x, x * std::abs(x) / 2);
  PLIANT_ASSERT(kind_ == CurveKind::hermite, "nobody asks for the integral of an energy's secant");
  const HermiteShape shape{knots_, tangents_};
  if (!even_) return shape.primitive(x, 0) - shape.primitive(0, 0);
  return sign(x) * (shape.primitive(std::abs(x), 0) - shape.primitive(0, 0));
}

Eigen::VectorXd ScalarCurve::first_moment_weights(double x) const {
  if (kind_ == CurveKind::none) return {};
  const double magnitude = std::abs(x);
  if (kind_ == CurveKind::constant) return single(x * x / 2);
  if (kind_ == CurveKind::affine) return pair(x * x / 2, magnitude * magnitude * magnitude / 3);
  const double to = even_ ? magnitude : x;
  if (kind_ == CurveKind::spline) return spline_energy_weights(knots_, to);
  if (kind_ == CurveKind::energy) return hermite_energy_weights(knots_, to);
  const HermiteShape shape{knots_, tangents_};
  return shape.primitive(to, 1) - shape.primitive(0, 1);
}

}  // namespace pliant
