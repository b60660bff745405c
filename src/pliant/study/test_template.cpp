#include "pliant/study/test_template.h"

#include "pliant/base/errors.h"
#include "pliant/base/nearest_name.h"
#include "pliant/experiment/registry.h"

namespace pliant {

std::vector<std::string> template_tests() {
  std::vector<std::string> tests;
  for (const TestType* type : test_types()) {
    if (!type->template_files.empty()) tests.emplace_back(type->name);
  }
  return tests;
}

TestFiles test_template(std::string_view test) {
  const TestType* type = find_test_type(test);
  if (type && !type->template_files.empty()) return type->template_files;
  const std::vector<std::string> tests = template_tests();
  throw InputError({}, "there is no template for " + quoted_value(test) + did_you_mean(test, tests),
                   list_of_names(tests));
}

}  // namespace pliant
