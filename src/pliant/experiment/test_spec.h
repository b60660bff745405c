#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace pliant {

struct TestType;
struct VolumeMesh;

/// Keys and values of a mapping, as documents write them.
using WrittenFields = std::vector<std::pair<std::string, std::string>>;

/// What an experiment of a study has beside the fields of all: the specification of its test.
struct TestSpec {
  double length = 0;  ///< of the specimen (m); 0 where the test has none or it is not stated
  double width = 0;

  virtual ~TestSpec() = default;
  virtual const TestType& type() const = 0;
  /// The test's own fields, every default filled in.
  virtual WrittenFields fields() const = 0;
  /// Whether no component of its own describes it in one dimension.
  virtual bool is_only_sheet() const { return false; }
  /// Whether the volume of a solid may change in it: then something must resist that.
  virtual bool volume_may_change() const { return false; }
  /// The body at rest, where the test is of a whole one.
  virtual const VolumeMesh* body() const { return nullptr; }
  /// The same test of the body with elements half as large; null where it is of no body.
  virtual std::shared_ptr<const TestSpec> on_finer_body() const { return nullptr; }
  /// Files with more of what was measured than the rows: meshes, positions.
  virtual std::vector<std::filesystem::path> files() const { return {}; }
};

}  // namespace pliant
