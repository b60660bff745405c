#include "pliant/study/example_data.h"

#include <algorithm>

#include "pliant/experiment/test_type.h"

namespace pliant {
namespace {

bool is_same_table(const CsvTable& a, const CsvTable& b) {
  return a.rows() == b.rows() && a.headers() == b.headers() &&
         std::ranges::all_of(a.headers(), [&](const std::string& header) {
           return a.texts(header) == b.texts(header);
         });
}

}  // namespace

bool is_example_data(const ExperimentSpec& experiment) {
  const auto& files = experiment.test->type().template_files;
  const auto example =
      std::ranges::find_if(files, [](const auto& file) { return file.first.ends_with(".csv"); });
  if (example == files.end() || experiment.data.files.size() != 1) return false;
  return is_same_table(read_csv(experiment.data.files.front(), experiment.data.csv),
                       parse_csv(example->second, example->first));
}

}  // namespace pliant
