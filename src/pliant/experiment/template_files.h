#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace pliant {

/// Names and contents of files.
using TestFiles = std::vector<std::pair<std::string, std::string>>;

/// The files of src/pliant/experiment/TEST/template, or of src/pliant/capture/template for
/// `capture`; none for an unknown folder.
TestFiles template_files(std::string_view test);

}  // namespace pliant
