#include "layers/source_rules.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <iterator>
#include <map>
#include <optional>
#include <regex>
#include <sstream>

namespace pliant::source_rules {
namespace {

/// Lowest first: a folder may include those before it, and itself.
constexpr std::array<std::string_view, 18> kLayers = {
    "base",    "io",       "math",        "geometry",   "material",   "mechanics",
    "contact", "solver",   "measurement", "experiment", "estimation", "study",
    "scene",   "exchange", "capture",     "imaging",    "render",     "report"};

std::optional<std::size_t> layer_of(std::string_view folder) {
  const auto found = std::find(kLayers.begin(), kLayers.end(), folder);
  if (found == kLayers.end()) return std::nullopt;
  return static_cast<std::size_t>(found - kLayers.begin());
}

/// The folder of src/pliant in which a file stands; empty elsewhere.
std::string folder_of(const std::string& path) {
  static const std::regex pattern("^src/pliant/([^/]+)/");
  std::smatch match;
  return std::regex_search(path, match, pattern) ? match[1].str() : std::string();
}

bool is_header(const std::string& path) { return path.ends_with(".h"); }

template <typename CheckLine>
std::vector<Offence> check_lines(const SourceFile& source, CheckLine check) {
  std::vector<Offence> offences;
  std::istringstream lines(source.text);
  std::string line;
  for (int number = 1; std::getline(lines, line); ++number) {
    if (std::string what = check(line); !what.empty()) {
      offences.push_back({source.path, number, std::move(what)});
    }
  }
  return offences;
}

std::vector<Offence> lines_matching(const SourceFile& source, const std::regex& pattern,
                                    const std::string& what) {
  return check_lines(source, [&](const std::string& line) {
    std::smatch match;
    return std::regex_search(line, match, pattern) ? what + ": " + match[0].str() : std::string();
  });
}

std::string read_text(const std::filesystem::path& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

}  // namespace

std::vector<SourceFile> source_files(const std::filesystem::path& root, std::string_view folder) {
  std::vector<SourceFile> files;
  const std::filesystem::path top = root / folder;
  if (!std::filesystem::exists(top)) return files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(top)) {
    const std::filesystem::path& path = entry.path();
    if (path.extension() != ".h" && path.extension() != ".cpp") continue;
    files.push_back({path.lexically_relative(root).generic_string(), read_text(path)});
  }
  std::sort(files.begin(), files.end(),
            [](const SourceFile& a, const SourceFile& b) { return a.path < b.path; });
  return files;
}

std::vector<Offence> layer_offences(const SourceFile& source) {
  static const std::regex include(R"(^\s*#\s*include\s*["<]pliant/([^">]*)[">])");
  const std::string own = folder_of(source.path);
  const std::optional<std::size_t> own_layer = layer_of(own);
  return check_lines(source, [&](const std::string& line) -> std::string {
    std::smatch match;
    if (!std::regex_search(line, match, include)) return {};
    const std::string target = match[1].str();
    const std::string folder = target.substr(0, target.find('/'));
    const std::optional<std::size_t> layer = layer_of(folder);
    if (!layer) return "includes pliant/" + target + ", which is in no folder of the layer order";
    if (own.empty()) return {};
    if (!own_layer) return "the folder " + own + " is not in the layer order";
    if (*layer > *own_layer) return own + " may not include " + folder + ", a later layer";
    return {};
  });
}

std::vector<Offence> heavy_header_offences(const SourceFile& source) {
  static const std::regex heavy(R"(^\s*#\s*include\s*["<](ceres/|opencv2/|itk|embree3/)[^">]*)");
  if (!is_header(source.path)) return {};
  return lines_matching(source, heavy, "heavy third-party header outside a .cpp file");
}

std::vector<Offence> machine_path_offences(const SourceFile& source) {
  static const std::regex path(R"((^|[^\w.>])/(home|root|tmp|work|mnt|srv|opt|Users)/)");
  return lines_matching(source, path, "path of one machine");
}

std::vector<Offence> library_manner_offences(const SourceFile& source) {
  static const std::regex manners(
      R"(std::(cout|cerr|clog|exit|quick_exit|abort|terminate)\b|fmt::print\b|)"
      R"(\b(printf|fprintf|puts|exit|getenv|secure_getenv|setenv)\s*\()");
  if (folder_of(source.path).empty()) return {};
  return lines_matching(source, manners, "a library never prints, exits or reads the environment");
}

std::vector<Offence> length_offences(const SourceFile& source) {
  constexpr int kMostLines = 450;
  const auto lines = static_cast<int>(std::ranges::count(source.text, '\n'));
  if (lines <= kMostLines) return {};
  return {{source.path, lines, "has more than " + std::to_string(kMostLines) + " lines"}};
}

std::vector<Offence> header_name_offences(const std::vector<SourceFile>& sources) {
  std::map<std::string, std::string> first;  // by name
  std::vector<Offence> offences;
  for (const SourceFile& source : sources) {
    if (!is_header(source.path)) continue;
    const std::string name = source.path.substr(source.path.rfind('/') + 1);
    const auto [other, is_new] = first.emplace(name, source.path);
    if (!is_new) offences.push_back({source.path, 1, "has the name of " + other->second});
  }
  return offences;
}

std::span<const std::string_view> layers() { return kLayers; }

std::vector<TestName> test_names(const std::vector<SourceFile>& sources) {
  static const std::regex name(R"re(\.name = "([^"]+)")re");
  std::vector<TestName> tests;
  for (const SourceFile& source : sources) {
    if (!source.path.ends_with("_type.cpp")) continue;
    const std::string folder = source.path.substr(0, source.path.rfind('/') + 1);
    for (std::sregex_iterator it(source.text.begin(), source.text.end(), name), end; it != end;
         ++it) {
      tests.push_back({(*it)[1].str(), folder});
    }
  }
  return tests;
}

std::vector<Offence> test_name_offences(const SourceFile& source,
                                        const std::vector<TestName>& tests) {
  static const std::regex literal(R"re("((?:[^"\\]|\\.)*)")re");
  return check_lines(source, [&](const std::string& line) -> std::string {
    if (line.starts_with("#include") || line.find('"') == std::string::npos) return {};
    const std::string code = line.substr(0, line.find("//"));
    for (std::sregex_iterator it(code.begin(), code.end(), literal), end; it != end; ++it) {
      const std::string text = (*it)[1].str();
      for (const TestName& test : tests) {
        // A name of one word is a word of sentences, too.
        const bool named = test.name.find('-') == std::string::npos
                               ? text == test.name
                               : text.find(test.name) != std::string::npos;
        if (named && !source.path.starts_with(test.folder)) {
          return "names the test " + test.name + " outside " + test.folder;
        }
      }
    }
    return {};
  });
}

bool is_in_folder_of_its_name(const TestName& test) {
  const size_t end = test.folder.size() - 1;
  std::string folder = test.folder.substr(test.folder.rfind('/', end - 1) + 1);
  folder.pop_back();
  std::ranges::replace(folder, '_', '-');
  return ("-" + test.name + "-").find("-" + folder + "-") != std::string::npos;
}

std::string describe(const std::vector<Offence>& offences) {
  std::ostringstream text;
  for (const Offence& offence : offences) {
    text << "\n" << offence.file << ":" << offence.line << ": " << offence.what;
  }
  return text.str();
}

}  // namespace pliant::source_rules
