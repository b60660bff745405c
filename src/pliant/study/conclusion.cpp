#include "pliant/study/conclusion.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "pliant/estimation/judgement.h"
#include "pliant/estimation/number_errors.h"
#include "pliant/io/digest.h"

namespace pliant {
namespace {

std::vector<DataFile> data_of(const Study& study) {
  const std::filesystem::path folder = std::filesystem::path(study.file).parent_path();
  std::vector<DataFile> data;
  for (const ExperimentSpec& spec : study.experiments) {
    std::vector<std::filesystem::path> files = spec.data.files;
    std::ranges::move(spec.test->files(), std::back_inserter(files));
    for (const std::filesystem::path& file : files) {
      data.push_back(
          {spec.name, file.lexically_proximate(folder).generic_string(), sha256_of_path(file)});
    }
  }
  return data;
}

/// Components in the order of their names' list, as tables show them.
void order_figures(std::vector<LabFigure>& figures) {
  const std::vector<std::string>& names = cloth_component_names();
  std::ranges::stable_sort(figures, {}, [&](const LabFigure& figure) {
    return std::ranges::find(names, figure.component) - names.begin();
  });
}

/// The evaluated material; what states no range has that of the experiments. Sessions know strains
/// of their clips alone.
Material with_ranges(const StudyResult& result) {
  Material material = result.material;
  for (auto& [name, component] : material.components) {
    if (component.range) continue;
    for (const ExperimentResult& e : result.experiments) {
      if (e.component != name || e.sheet) continue;
      const double largest =
          std::max(std::abs(e.strain_range.first), std::abs(e.strain_range.second));
      component.range = {0, std::max(largest, component.range ? component.range->second : 0)};
    }
  }
  return material;
}

}  // namespace

void conclude_fit(const Study& study, StudyResult& result) {
  state_errors(result.parameters, study.model.isotropic, result.material);
  result.data = data_of(study);
  result.judgement = judge(result, study.accept, /*evaluation=*/false);
  order_figures(result.figures);
}

void conclude_evaluation(const Study& study, StudyResult& result) {
  result.data = data_of(study);
  result.judgement = judge(result, study.accept, /*evaluation=*/true);
  const Material material = with_ranges(result);
  for (const auto& [name, component] : material.components) {
    if (material.kind == MaterialKind::solid) break;  // textile laboratories know sheets
    if (component.status != ComponentStatus::measured || !component.stiffness) continue;
    std::ranges::move(lab_figures(material, name, {}), std::back_inserter(result.figures));
  }
  order_figures(result.figures);
}

}  // namespace pliant
