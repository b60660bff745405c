#include "pliant/study/shape_table.h"

#include <limits>
#include <vector>

#include "pliant/io/csv_writer.h"

namespace pliant {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
constexpr double kMillimetres = 1e3;

void add_point(const ProfileLine& line, size_t i, CsvWriter& csv) {
  csv.cell(kMillimetres * line.arc_length[i]);
  csv.cell(kMillimetres * line.x[i]).cell(kMillimetres * line.y[i]);
  csv.cell(line.curvature[i]).cell(line.moment[i]);
}

void add_measured(const ExperimentResult& experiment, int number, const ProfileLine& line,
                  CsvWriter& csv) {
  for (size_t i = 0; i < line.x.size(); ++i) {
    const auto row = static_cast<size_t>(line.first_row) + i;
    csv.cell("measured").cell(kMillimetres * line.setting).cell(number);
    csv.cell(experiment.specimens[static_cast<size_t>(experiment.specimen_of_row[row])]);
    add_point(line, i, csv);
    csv.cell(kMillimetres * experiment.predicted(static_cast<Eigen::Index>(row)));
    csv.cell(experiment.used[row] ? 1 : 0);
    csv.end_row();
  }
}

void add_predicted(const ProfileLine& line, CsvWriter& csv) {
  for (size_t i = 0; i < line.x.size(); ++i) {
    csv.cell("predicted").cell(kMillimetres * line.setting).cell("").cell("");
    add_point(line, i, csv);
    csv.cell("").cell("");
    csv.end_row();
  }
}

void add_bent(const BendingPath& path, CsvWriter& csv) {
  for (size_t i = 0; i < path.curvature.size(); ++i) {
    csv.cell("bent").cell(kMillimetres * path.setting).cell("").cell("");
    csv.cell(kNone).cell(kNone).cell(kNone).cell(path.curvature[i]).cell(path.moment[i]);
    csv.cell("").cell("");
    csv.end_row();
  }
}

}  // namespace

std::string shape_table(const ExperimentResult& experiment) {
  const StripShapes& shapes = *experiment.shapes;
  const std::vector<std::string> header{
      "series", shapes.setting_name + "_mm", "profile",  "specimen",    "arc_length_mm", "x_mm",
      "y_mm",   "curvature_1_per_m",         "moment_N", "distance_mm", "used"};
  CsvWriter csv(header);
  int number = 0;
  for (const ProfileLine& line : shapes.measured) add_measured(experiment, ++number, line, csv);
  for (const ProfileLine& line : shapes.predicted) add_predicted(line, csv);
  for (const BendingPath& path : shapes.bent) add_bent(path, csv);
  return csv.text();
}

}  // namespace pliant
