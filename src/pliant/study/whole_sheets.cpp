#include "pliant/study/whole_sheets.h"

#include <algorithm>
#include <cmath>
#include <mutex>

#include "pliant/base/assert.h"
#include "pliant/material/fill.h"
#include "pliant/study/study_experiments.h"

namespace pliant {
namespace {

double rms_of_used(const WholeSheetResult& whole) {
  double squares = 0;
  int used = 0;
  for (Eigen::Index i = 0; i < whole.measured.size(); ++i) {
    if (!whole.info.used[static_cast<std::size_t>(i)]) continue;
    squares += std::pow(whole.prediction.value(i) - whole.measured(i), 2);
    ++used;
  }
  return used == 0 ? 0 : std::sqrt(squares / used);
}

/// Steps that several threads take, told by one at a time.
class SharedTask {
 public:
  SharedTask(Progress& progress, int steps)
      : task_(progress, "predict", static_cast<double>(steps)) {}

  void add(int steps) {
    const std::lock_guard lock(mutex_);
    done_ += steps;
    task_.advance(done_);
  }

 private:
  ProgressTask task_;
  std::mutex mutex_;
  int done_ = 0;
};

WholeSheetResult predicted(const ExperimentSpec& spec, const WholeSheetTest& test,
                           const Material& material, const RunContext& context) {
  SharedTask task(context.progress, test.work());
  WholeSheetResult whole;
  whole.type = spec.type;
  whole.info = test.info();
  whole.measured = test.measured();
  whole.prediction =
      test.predict(material, {context.threads, context.stop, [&](int steps) { task.add(steps); }});
  whole.rms = rms_of_used(whole);
  return whole;
}

}  // namespace

bool is_only_predicted(const ExperimentSpec& spec) {
  return spec.test->type().facts.only_predicted;
}

std::unique_ptr<WholeSheetTest> read_whole_sheet_test(const ExperimentSpec& spec) {
  const TestType& type = spec.test->type();
  PLIANT_ASSERT(type.make_whole, "other tests are fitted");
  return type.make_whole(spec, DataRows(spec.data));
}

void evaluate_whole_sheets(const Study& study, const Material& material, const RunContext& context,
                           StudyResult& result) {
  std::vector<std::string> missing = sheet_component_names();
  std::erase_if(missing, [&](const std::string& name) { return is_known(material, name); });
  for (const ExperimentSpec& spec : study.experiments) {
    if (!is_only_predicted(spec)) continue;
    const std::unique_ptr<WholeSheetTest> test = read_whole_sheet_test(spec);
    add_remarks(spec.name, test->info(), result);
    if (!missing.empty()) {
      result.skipped.push_back({spec.name, missing});
      continue;
    }
    Material weighed = material;
    if (weighed.density == 0) weighed.density = study.density;
    test->require(weighed, {study.file, 0, "experiments"});
    result.whole_sheets.push_back(predicted(spec, *test, weighed, context));
    for (const std::string& warning : result.whole_sheets.back().prediction.warnings) {
      result.warnings.push_back(spec.name + ": " + warning);
    }
  }
}

void warn_of_whole_sheets(const Study& study, StudyResult& result) {
  for (const ExperimentSpec& spec : study.experiments) {
    if (!is_only_predicted(spec)) continue;
    result.warnings.push_back(spec.name +
                              ": left out, as all of a material shows in it together; `pliant "
                              "evaluate` predicts it with a complete material");
  }
}

}  // namespace pliant
