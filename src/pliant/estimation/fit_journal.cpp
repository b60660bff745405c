#include "pliant/estimation/fit_journal.h"

#include "pliant/io/digest.h"

namespace pliant {
namespace {

constexpr std::size_t kBesideParameters = 3;  // cost, iterations, whether it converged

Journal::Numbers numbers_of(const LeastSquaresSummary& end) {
  Journal::Numbers numbers(end.parameters.begin(), end.parameters.end());
  numbers.push_back(end.cost);
  numbers.push_back(end.iterations);
  numbers.push_back(end.converged ? 1 : 0);
  return numbers;
}

LeastSquaresSummary summary_of(const Journal::Numbers& numbers) {
  const std::size_t count = numbers.size() - kBesideParameters;
  LeastSquaresSummary end;
  end.parameters = Eigen::VectorXd::Map(numbers.data(), static_cast<Eigen::Index>(count));
  end.cost = numbers[count];
  end.iterations = static_cast<int>(numbers[count + 1]);
  end.converged = numbers[count + 2] > 0;
  return end;
}

}  // namespace

std::string digest_of(const ComponentExperiment& experiment) {
  const MeasuredPath& path = experiment.path();
  return sha256_of(sha256_of(as_bytes(path.strain)) + sha256_of(as_bytes(path.specimen)) +
                   sha256_of(as_bytes(experiment.measured())));
}

void begin_fit(Journal& journal, const FitSettings& settings, const std::string& data) {
  journal.answer("fit of " + settings.name + ", " + sha256_of(settings.digest + data), [&] {
    journal.keep({});
    return Journal::Numbers{};
  });
}

LeastSquaresSummary answered(Journal& journal, const std::string& question,
                             const std::function<LeastSquaresSummary()>& search) {
  return summary_of(journal.answer(question, [&] { return numbers_of(search()); }));
}

}  // namespace pliant
