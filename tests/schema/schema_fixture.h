#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "schema/documents.h"
#include "schema/schema_judge.h"

namespace pliant::test {

/// Documents that are judged by the schemas and by the readers.
class Schema : public testing::Test {
 protected:
  void SetUp() override {
    if (!can_judge_schemas())
      GTEST_SKIP() << "needs python3 with fastjsonschema (python3-fastjsonschema)";
  }

  static std::vector<std::optional<std::string>> schema_verdicts(
      const std::vector<NamedDocument>& documents) {
    std::vector<SchemaCase> cases;
    for (const NamedDocument& one : documents) cases.push_back(one.document);
    return judge_by_schema(cases);
  }

  /// Both judges, or a test failure that names the document on which they differ.
  /// @return of each document, whether both accept it
  std::vector<bool> accepted_by_both(const std::vector<NamedDocument>& documents) {
    const auto by_schema = schema_verdicts(documents);
    std::vector<bool> accepted;
    for (std::size_t i = 0; i < documents.size(); ++i) {
      const auto by_reader = judge_by_reader(documents[i].document, folder_.path());
      EXPECT_EQ(by_reader.has_value(), by_schema[i].has_value())
          << documents[i].name << "\n  reader: " << by_reader.value_or("accepts")
          << "\n  schema: " << by_schema[i].value_or("accepts");
      accepted.push_back(!by_reader && !by_schema[i]);
    }
    return accepted;
  }

  /// @return how many of the documents both accept
  int expect_agreement(const std::vector<NamedDocument>& documents) {
    const std::vector<bool> accepted = accepted_by_both(documents);
    return static_cast<int>(std::ranges::count(accepted, true));
  }

  DocumentFolder folder_;
};

}  // namespace pliant::test
