#pragma once

#include <filesystem>
#include <ostream>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "io/input_error_of.h"

namespace pliant::test {

/// A document that its reader refuses, and where.
struct Refusal {
  std::string what;  ///< name of the test
  std::string text;
  int line = 0;
  std::string field;
  std::string message;    ///< part of the error's line
  std::string file = {};  ///< beside the document, that is at fault; empty: the document
};

inline void PrintTo(const Refusal& refusal, std::ostream* out) { *out << refusal.what; }

inline std::string name_of_refusal(const ::testing::TestParamInfo<Refusal>& instance) {
  return instance.param.what;
}

/// Checks where a document is refused, and why.
/// @param document  its file
template <typename Reader>
void expect_refused(const Refusal& refusal, const std::filesystem::path& document,
                    const Reader& read) {
  const InputError error = input_error_of([&] { read(document); });
  if (::testing::Test::HasFailure()) return;
  const std::filesystem::path file =
      refusal.file.empty() ? document : document.parent_path() / refusal.file;
  EXPECT_EQ(error.where().file, file.string());
  EXPECT_EQ(error.where().line, refusal.line);
  EXPECT_EQ(error.where().field, refusal.field);
  EXPECT_THAT(std::string(error.what()), ::testing::HasSubstr(refusal.message));
}

}  // namespace pliant::test
