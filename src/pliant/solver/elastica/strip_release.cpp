#include "pliant/solver/elastica/strip_release.h"

#include <utility>

#include "pliant/solver/elastica/strip_front.h"

namespace pliant {
namespace {

constexpr int kFirstSteps = 2, kElasticSteps = 4;
constexpr int kMostHalvings = 9;
// A law under which points snap one by one has no end of turns; past this many shapes the steps are
// taken as they come.
constexpr int kMostShapes = 48;

// A strip and what holds it.
class Release {
 public:
  Release(const Elastica& strip, const ComponentLaw& law, double weight, const StripEnds& ends,
          const StripHistory& history, bool with_derivatives, double accuracy)
      : strip_(strip),
        law_(law),
        weight_(weight),
        ends_(ends),
        held_(strip.holding_moments(law, weight, ends, history)),
        with_derivatives_(with_derivatives),
        accuracy_(accuracy),
        history_(history) {
    shape_.curvature = history.curvature;
  }

  // Where it has come to.
  const StripShape& shape() const { return shape_; }
  const StripHistory& history() const { return history_; }
  // Before the last step.
  const StripHistory& before() const { return before_; }

  // Goes on from a share of the moments to another.
  bool follow(double from, double to) { return follow(from, to, at(to), kMostHalvings); }

 private:
  using MaybeShape = std::optional<StripShape>;

  bool follow(double from, double to, const MaybeShape& whole, int halvings) {
    if (whole && (!remembers() || shapes_ > kMostShapes)) {
      accept(*whole);
      return true;
    }
    const double middle = (from + to) / 2;
    const MaybeShape half = at(middle);
    if (half) {
      const MaybeShape end = at(to, *half, strip_.accepted(law_, history_, *half));
      if (end && (halvings == 0 || (whole && agree(*whole, *end)))) {
        accept(*half);
        accept(*end);
        return true;
      }
    }
    if (halvings == 0) return false;
    return follow(from, middle, half, halvings - 1) && follow(middle, to, at(to), halvings - 1);
  }

  bool remembers() const { return law_.remembers(); }

  MaybeShape at(double share) { return at(share, shape_, history_); }

  MaybeShape at(double share, const StripShape& guess, const StripHistory& history) {
    ++shapes_;
    return strip_.equilibrium(law_, weight_, ends_, history, guess, share * held_);
  }

  bool agree(const StripShape& a, const StripShape& b) const {
    return strip_.line().integrals(a.curvature - b.curvature).cwiseAbs().maxCoeff() < accuracy_;
  }

  void accept(StripShape shape) {
    if (with_derivatives_) strip_.differentiate(law_, weight_, ends_, history_, shape);
    before_ = std::exchange(history_, strip_.accepted(law_, history_, shape));
    shape_ = std::move(shape);
  }

  const Elastica& strip_;
  const ComponentLaw& law_;
  double weight_;
  const StripEnds& ends_;
  Eigen::VectorXd held_;
  bool with_derivatives_;
  double accuracy_;
  StripShape shape_;
  StripHistory history_, before_;
  int shapes_ = 0;  // tried
};

}  // namespace

std::optional<StripShape> released(const Elastica& strip, const ComponentLaw& law, double weight,
                                   const StripEnds& ends, bool with_derivatives,
                                   StripHistory& history, double accuracy) {
  Release release(strip, law, weight, ends, history, with_derivatives, accuracy);
  const int steps = law.remembers() ? kFirstSteps : kElasticSteps;
  for (int step = 0; step < steps; ++step) {
    const double from = 1 - static_cast<double>(step) / steps;
    if (!release.follow(from, from - 1.0 / steps)) return std::nullopt;
  }
  StripShape shape = release.shape();
  settle_fronts(strip, law, weight, ends, history, release.before(), shape);
  history = release.history();
  return shape;
}

}  // namespace pliant
