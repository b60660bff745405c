#include "pliant/study/test_template.h"

#include "pliant/base/errors.h"
#include "pliant/base/nearest_name.h"
#include "pliant/study/templates/templates.h"

namespace pliant {
namespace {

struct Entry {
  const char* test;
  TestTemplate (*make)();
};

constexpr Entry kTemplates[] = {
    {"hanging-weights", hanging_weights_template}, {"tensile-cycles", tensile_cycles_template},
    {"shear-cycles", shear_cycles_template},       {"pure-bending", pure_bending_template},
    {"cantilever", cantilever_template},           {"rolled-strip", rolled_strip_template},
    {"bending-length", bending_length_template},   {"buckling-bend", buckling_bend_template}};

}  // namespace

std::vector<std::string> template_tests() {
  std::vector<std::string> tests;
  for (const Entry& entry : kTemplates) tests.emplace_back(entry.test);
  return tests;
}

TestTemplate make_test_template(std::string_view test) {
  for (const Entry& entry : kTemplates) {
    if (test == entry.test) return entry.make();
  }
  const std::vector<std::string> tests = template_tests();
  throw InputError({}, "there is no template for " + quoted_value(test) + did_you_mean(test, tests),
                   list_of_names(tests));
}

}  // namespace pliant
