#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace pliant::source_rules {

/// One line of source text that breaks a rule.
struct Offence {
  std::string file;  ///< relative to the root of the repository
  int line = 0;      ///< counted from 1
  std::string what;  ///< the rule it breaks, in words
};

/// A source file as text; `path` is relative to the root of the repository.
struct SourceFile {
  std::string path;
  std::string text;
};

/// All .h and .cpp files below `folder` (relative to `root`), in the order of their names.
std::vector<SourceFile> source_files(const std::filesystem::path& root, std::string_view folder);

/// Includes of a folder of src/pliant that stands later in the layer order than the file's own,
/// or that is not in the order at all. Files outside src/pliant may include every folder.
std::vector<Offence> layer_offences(const SourceFile& source);

/// Headers that include a third-party library whose cost nobody else shall pay.
std::vector<Offence> heavy_header_offences(const SourceFile& source);

/// Absolute paths into the file system of one machine.
std::vector<Offence> machine_path_offences(const SourceFile& source);

/// Library code that prints, ends the process or reads the environment.
std::vector<Offence> library_manner_offences(const SourceFile& source);

/// Files that are longer than a reader can keep in mind.
std::vector<Offence> length_offences(const SourceFile& source);

/// Headers that have the name of another one in another folder.
std::vector<Offence> header_name_offences(const std::vector<SourceFile>& sources);

/// The folders of src/pliant, lowest first.
std::span<const std::string_view> layers();

/// A type of test of the registry.
struct TestName {
  std::string name;    ///< as studies write it
  std::string folder;  ///< its own, relative to the root of the repository
};

/// The types of tests that sources define: `.name = "..."` in `*_type.cpp`.
std::vector<TestName> test_names(const std::vector<SourceFile>& sources);

/// Texts that name a type of test outside its folder; comments and includes may.
std::vector<Offence> test_name_offences(const SourceFile& source,
                                        const std::vector<TestName>& tests);

/// Whether a test's folder has the test's name, or a word or more of it.
bool is_in_folder_of_its_name(const TestName& test);

/// One line an offence, as compilers write it: `file:line: what`.
std::string describe(const std::vector<Offence>& offences);

}  // namespace pliant::source_rules
