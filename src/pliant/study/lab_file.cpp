#include <algorithm>
#include <set>

#include <fmt/format.h>

#include "pliant/experiment/registry.h"
#include "pliant/io/document.h"
#include "pliant/io/fields.h"
#include "pliant/io/result_name.h"
#include "pliant/material/material_file.h"
#include "pliant/study/virtual_lab.h"

namespace pliant {
namespace {

using VirtualTests = std::vector<std::shared_ptr<VirtualTest>>;

/// The test that `test` comes after.
std::shared_ptr<const VirtualTest> earlier_test(const VirtualTest& test,
                                                const VirtualTests& earlier) {
  const auto before = std::ranges::find(earlier, test.after, [](const auto& e) { return e->name; });
  const bool fits = before != earlier.end() && (*before)->type().name == test.type().name &&
                    (*before)->heading() == test.heading();
  if (fits) return *before;
  throw InputError({test.where.file, test.where.line, test.where.field + ".after"},
                   quoted_value(test.after) + " names no such experiment that stands before it",
                   fmt::format("an earlier experiment of the list, {} along {}", test.type().name,
                               test.heading()));
}

std::shared_ptr<VirtualTest> read_experiment(const Value& node, std::set<std::string>& names,
                                             const VirtualTests& earlier) {
  Fields fields = node.fields();
  const std::string name = read_experiment_name(fields.require("name"), names);
  std::shared_ptr<VirtualTest> test = read_test_type(fields.require("type")).read_virtual(fields);
  test->name = name;
  test->where = node.location();
  if (!test->after.empty()) test->before = earlier_test(*test, earlier);
  fields.finish();
  return test;
}

}  // namespace

VirtualLab read_lab(const std::filesystem::path& path) { return lab_of(read_yaml(path)); }

VirtualLab lab_of(const Document& document) {
  Fields fields = Value(document).fields();
  require_document(fields, "lab", 1);
  VirtualLab lab;
  const Value material = fields.require("material");
  lab.material = read_material(std::filesystem::path(document.file).parent_path() /
                               material.text("a material file"));
  lab.name = lab.material.name;
  if (auto v = fields.optional("name")) lab.name = v->text();
  if (auto v = fields.optional("specimens")) lab.specimens = v->integer(1, 1000);
  if (auto v = fields.optional("specimen_variation")) {
    lab.specimen_variation = v->quantity_from_zero(Dimension::fraction);
  }
  std::set<std::string> names;
  const Value list = fields.require("experiments");
  for (const Value& node : list.items()) {
    lab.experiments.push_back(read_experiment(node, names, lab.experiments));
    lab.experiments.back()->require(lab.material);
  }
  if (lab.experiments.empty()) list.fail("has no experiment", "at least one");
  if (auto v = fields.optional("validate")) {
    for (const Value& pattern : v->items()) lab.validate.push_back(pattern.text());
  }
  if (auto v = fields.optional("cameras")) {
    lab.cameras = read_virtual_cameras(*v);
    const bool any = std::ranges::any_of(
        lab.experiments, [](const auto& test) { return test->type().facts.measures_sheets; });
    if (!any) v->fail("see nothing", "an experiment of the type session");
  }
  fields.finish();
  return lab;
}

}  // namespace pliant
