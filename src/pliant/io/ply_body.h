#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>

#include "pliant/base/errors.h"
#include "pliant/io/ply_header.h"

namespace pliant {

/// The numbers behind the header of a PLY file, in its order. A row is one vertex, face or the
/// like.
class PlyBody {
 public:
  virtual ~PlyBody() = default;

  virtual void begin_row(const PlyElement& element, std::size_t row) = 0;
  /// @throws InputError where the row or the file ends, or holds something else
  virtual double next(PlyType type) = 0;
  virtual void end_row() = 0;
  /// Numbers that the rest of the file, or of the row, can hold at most.
  virtual std::size_t max_count(PlyType type) const = 0;
  /// The line of the next row; 0 in a binary file.
  virtual int next_line() const = 0;
  virtual std::size_t bytes_left() const = 0;
  /// Throws the InputError of the row.
  [[noreturn]] virtual void fail(const std::string& problem, const std::string& expected) const = 0;
};

/// Where a row stands; `line` is 0 in a binary file, and rows are counted from 0.
Location ply_row_location(const std::string& file, int line, const std::string& element,
                          std::size_t row);

/// @param bytes  the whole file; it and `file` must outlive what is returned
std::unique_ptr<PlyBody> make_ply_body(std::string_view bytes, const PlyHeader& header,
                                       const std::string& file);

}  // namespace pliant
