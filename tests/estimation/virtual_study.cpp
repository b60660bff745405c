#include "estimation/virtual_study.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "pliant/material/addend/addend_registry.h"
#include "pliant/material/material_file.h"

namespace pliant::test {
namespace {

std::string text_of(const VirtualStudy::Rows& rows) {
  std::string text;
  for (const std::vector<double>& row : rows) {
    text += fmt::format("{}\n", fmt::join(row, ","));  // shortest texts that read back the same
  }
  return text;
}

}  // namespace

Material published_fabric(const std::string& name) {
  return read_material(std::filesystem::path(PLIANT_SOURCE_DIR) / "materials" / (name + ".json"));
}

Material knit_of_two_branches(const ScalarCurve& stiffness) {
  ComponentLaw law{stiffness, FrictionLaw::dahl, {1.2, 2, 0.01}};
  law.addends = {{*find_addend_kind("dahl"), Eigen::Vector3d(2, 5, 0.2)}};
  return made_up_material("stretch.warp", law);
}

Material strip_of_five_points() {
  return made_up_material("stretch.warp",
                          {ScalarCurve::hermite({0, 0.05, 0.1, 0.15, 0.2}, {60, 45, 40, 60, 100}),
                           FrictionLaw::dahl,
                           {0.5, 1, 0.01}});
}

VirtualStudy::VirtualStudy(const VirtualLab& lab, std::uint64_t seed)
    : folder_(measurements_of(lab, seed)), study_(content_of(folder() / "study.yaml")) {
  if (!study_.ends_with('\n')) study_ += '\n';
}

VirtualStudy& VirtualStudy::add_to_experiment(const std::string& line) {
  const size_t model = study_.find("model:");
  study_.insert(model, fmt::format("    {}\n", line));
  write_study();
  return *this;
}

VirtualStudy& VirtualStudy::set_in_experiment(const std::string& field, const std::string& value) {
  const size_t begin = study_.find(fmt::format("    {}:", field));
  if (begin == std::string::npos) throw std::invalid_argument("no field " + field);
  const size_t end = study_.find('\n', begin);
  study_.replace(begin, end - begin, fmt::format("    {}: {}", field, value));
  write_study();
  return *this;
}

VirtualStudy& VirtualStudy::add(const std::string& field) {
  study_ += field + "\n";
  write_study();
  return *this;
}

VirtualStudy& VirtualStudy::set_model(const std::string& fields) {
  const size_t begin = study_.find("model:");
  const size_t end = study_.find('\n', begin);
  study_.replace(begin, end - begin, fmt::format("model: {{{}}}", fields));
  write_study();
  return *this;
}

VirtualStudy& VirtualStudy::edit_rows(const std::string& file,
                                      const std::function<void(Rows&)>& edit) {
  std::istringstream lines(content_of(folder() / file));
  std::string header, line, cell;
  std::getline(lines, header);
  Rows rows;
  while (std::getline(lines, line)) {
    std::istringstream cells(line);
    rows.emplace_back();
    while (std::getline(cells, cell, ',')) rows.back().push_back(std::stod(cell));
  }
  edit(rows);
  folder_.write(file, header + "\n" + text_of(rows));
  return *this;
}

void VirtualStudy::write_study() const { folder_.write("study.yaml", study_); }

StudyResult VirtualStudy::fit(const StudyFitOptions& options, int threads) const {
  RunContext context;
  context.threads = threads;
  return fit_study(study(), options, context);
}

ParameterEstimate estimate_named(const StudyResult& result, const std::string& name) {
  for (const auto* list : {&result.parameters, &result.nuisance}) {
    const auto found = std::find_if(list->begin(), list->end(),
                                    [&](const ParameterEstimate& p) { return p.name == name; });
    if (found != list->end()) return *found;
  }
  ADD_FAILURE() << "no estimate of " << name;
  return {};
}

std::vector<std::string> names_of(const Material& material, const std::string& component) {
  return parameter_names(*law_of(material, component), component);
}

double truth_of(const Material& material, const std::string& name) {
  for (const auto& [component, ignored] : material.components) {
    const auto law = law_of(material, component);
    if (!law) continue;
    const std::vector<std::string> names = parameter_names(*law, component);
    const auto found = std::find(names.begin(), names.end(), name);
    if (found != names.end()) return law->parameters()(found - names.begin());
  }
  throw std::invalid_argument("the material has no " + name);
}

double relative_error(const StudyResult& result, const Material& truth, const std::string& name) {
  const double expected = truth_of(truth, name);
  return std::abs(estimate_named(result, name).value - expected) / expected;
}

}  // namespace pliant::test
