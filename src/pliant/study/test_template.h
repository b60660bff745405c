#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace pliant {

/// What a laboratory starts a test with: a commented study, a table with an example to overwrite,
/// and a protocol of one page. The study can be read, and fitted, as it stands.
struct TestTemplate {
  std::vector<std::pair<std::string, std::string>> files;  ///< name and content
};

/// The experiment types that have a template.
std::vector<std::string> template_tests();

/// The template of an experiment type, e.g. "hanging-weights".
/// @throws InputError when there is none, with the nearest name
TestTemplate make_test_template(std::string_view test);

}  // namespace pliant
