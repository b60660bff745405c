#include "pliant/estimation/sheet/sheet_journal.h"

#include <array>
#include <limits>
#include <memory>

#include "pliant/base/assert.h"
#include "pliant/estimation/fit_journal.h"
#include "pliant/io/digest.h"
#include "pliant/material/material_file.h"

namespace pliant {
namespace {

using Numbers = Journal::Numbers;

constexpr std::array kCounts{&EquilibriumCounts::equilibria,     &EquilibriumCounts::iterations,
                             &EquilibriumCounts::factors,        &EquilibriumCounts::unstable,
                             &EquilibriumCounts::differentiated, &EquilibriumCounts::differences};

/// Digest of the shapes and of what is compared.
std::string digest_of(const SheetTest& test) {
  const SheetNoise& noise = test.session().noise;
  const Eigen::Vector2d stated(noise.position.value_or(0), noise.force.value_or(0));
  std::string digests =
      sha256_of(as_bytes(test.session().rest.positions)) + sha256_of(as_bytes(stated));
  for (int frame = 0; frame < test.frame_count(); ++frame) {
    const SessionFrame& seen = test.session().frames[static_cast<std::size_t>(frame)];
    digests += sha256_of(as_bytes(seen.positions));
    for (const Pose& pose : seen.poses) {
      digests +=
          sha256_of(as_bytes(pose.translation)) + sha256_of(as_bytes(pose.rotation.coeffs()));
    }
    const Eigen::VectorXd compared = test.measured(frame);
    digests += sha256_of(as_bytes(compared));
  }
  return sha256_of(digests);
}

/// The columns of each shape, then all coordinates.
Numbers numbers_of(const std::vector<Eigen::Matrix3Xd>& shapes) {
  Numbers numbers;
  for (const Eigen::Matrix3Xd& shape : shapes) {
    numbers.push_back(static_cast<double>(shape.cols()));
    numbers.insert(numbers.end(), shape.data(), shape.data() + shape.size());
  }
  return numbers;
}

std::vector<Eigen::Matrix3Xd> shapes_of(const Numbers& numbers) {
  std::vector<Eigen::Matrix3Xd> shapes;
  for (std::size_t at = 0; at < numbers.size();) {
    const auto columns = static_cast<Eigen::Index>(numbers[at]);
    shapes.emplace_back(Eigen::Matrix3Xd::Map(numbers.data() + at + 1, 3, columns));
    at += 1 + static_cast<std::size_t>(3 * columns);
  }
  return shapes;
}

}  // namespace

SheetGuesses begin_journal(Journal& journal, const FitSettings& settings,
                           const std::vector<SheetStage>& plan, const Material* start) {
  std::string digests;
  for (const SheetStage& stage : plan) {
    for (const SheetTest* test : stage.tests) digests += digest_of(*test);
  }
  if (start) digests += sha256_of(material_text(*start));
  begin_fit(journal, settings, digests);
  SheetGuesses shapes;
  for (const auto& [test, numbers] : journal.kept()) shapes[test] = shapes_of(numbers);
  return shapes;
}

void keep_shapes(Journal& journal, const SheetGuesses& shapes) {
  std::map<std::string, Numbers> all;
  for (const auto& [test, found] : shapes) all[test] = numbers_of(found);
  journal.keep(std::move(all));
}

void append_counts(const EquilibriumCounts& counts, Numbers& answer) {
  for (const auto member : kCounts) answer.push_back(counts.*member);
}

EquilibriumCounts take_counts(Numbers& answer) {
  PLIANT_ASSERT(answer.size() >= kCounts.size(), "an answer ends with what it has cost");
  EquilibriumCounts counts;
  for (std::size_t i = kCounts.size(); i-- > 0;) {
    counts.*kCounts[i] = static_cast<int>(answer.back());
    answer.pop_back();
  }
  return counts;
}

LeastSquaresProblem with_journal(LeastSquaresProblem problem, Journal& journal) {
  const auto best = std::make_shared<double>(std::numeric_limits<double>::infinity());
  problem.evaluate = [evaluate = problem.evaluate, best, &journal](const Eigen::VectorXd& values,
                                                                   Eigen::VectorXd& residual,
                                                                   Eigen::MatrixXd* jacobian) {
    if (!evaluate(values, residual, jacobian)) return false;
    if (residual.squaredNorm() < *best) {
      *best = residual.squaredNorm();
      journal.reach({values.begin(), values.end()});
    }
    return true;
  };
  return problem;
}

}  // namespace pliant
