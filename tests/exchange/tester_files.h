#pragma once

#include <map>
#include <string>
#include <vector>

namespace pliant::test {

/// A file as a testing machine writes it. Its readings are those of `reference_rows`.
struct MadeUpFile {
  std::string name;
  std::string file;  ///< its own name
  std::string content;
  std::string blanks = "direction length width";  ///< fields that the study leaves to be filled in
  std::map<std::string, std::string> columns = {};  ///< what to fill in for columns, if anything
  int specimens = 1;
  std::string type = "tensile-cycles";
};

/// What all of the files of a type have measured.
std::string reference_rows(const std::string& type);

/// Files whose study can be fitted once its blanks are filled in.
std::vector<MadeUpFile> good_files();

struct RefusedFile {
  std::string name;
  std::string file;
  std::string content;
  std::string way_out;  ///< in the message: what to add to the study
};
std::vector<RefusedFile> refused_files();

}  // namespace pliant::test
