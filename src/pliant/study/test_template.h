#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "pliant/experiment/template_files.h"

namespace pliant {

/// The types of tests that have a template.
std::vector<std::string> template_tests();

/// What a laboratory starts a test with: a commented study, a table with an example to overwrite,
/// and a protocol of one page. The study can be read, and fitted, as it stands.
/// @param test  a type
/// @throws InputError when there is none, with the nearest name
TestFiles test_template(std::string_view test);

}  // namespace pliant
