#include "real/matlab_file.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <stdexcept>

#include <zlib.h>

#include "pliant/io/byte_order.h"
#include "pliant/io/text_file.h"

namespace pliant::test {
namespace {

// Types of elements, and classes of arrays.
constexpr std::uint32_t kDoubles = 9, kCompressed = 15;
constexpr unsigned kStructs = 2, kDoubleArray = 6;

struct Element {
  std::uint32_t type = 0;
  std::string_view bytes;
};

std::uint32_t number_at(std::string_view bytes, std::size_t at) {
  if (at + 4 > bytes.size()) throw std::runtime_error("a MATLAB file that is cut off");
  return load_number<std::uint32_t>(bytes.data() + at, ByteOrder::little);
}

/// Takes the first element off: type and length, then its bytes, filled up to eights unless they
/// are compressed; of four bytes or fewer all in eight.
Element next_element(std::string_view& bytes) {
  const std::uint32_t type = number_at(bytes, 0), length = number_at(bytes, 4);
  if (type >> 16U) {
    const Element small{type & 0xffffU, bytes.substr(4, type >> 16U)};
    bytes.remove_prefix(8);
    return small;
  }
  const std::size_t filled = type == kCompressed ? length : (length + std::size_t{7}) / 8 * 8;
  if (8 + filled > bytes.size()) throw std::runtime_error("a MATLAB file that is cut off");
  const Element element{type, bytes.substr(8, length)};
  bytes.remove_prefix(8 + filled);
  return element;
}

std::string unpacked(std::string_view packed) {
  std::string bytes;
  std::array<char, 1 << 16> part;
  z_stream stream{};
  inflateInit(&stream);
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(packed.data()));
  stream.avail_in = static_cast<uInt>(packed.size());
  int end = Z_OK;
  while (end == Z_OK) {
    stream.next_out = reinterpret_cast<Bytef*>(part.data());
    stream.avail_out = part.size();
    end = inflate(&stream, Z_NO_FLUSH);
    bytes.append(part.data(), part.size() - stream.avail_out);
  }
  inflateEnd(&stream);
  if (end != Z_STREAM_END) throw std::runtime_error("a MATLAB file that cannot be unpacked");
  return bytes;
}

/// What stands before the values of an array; takes it off.
/// @return rows and columns
std::array<Eigen::Index, 2> begin_array(MatlabValue& value, unsigned expected) {
  const Element flags = next_element(value), sizes = next_element(value);
  next_element(value);  // its name
  if ((number_at(flags.bytes, 0) & 0xffU) != expected || sizes.bytes.size() != 8) {
    throw std::runtime_error("a MATLAB array of another kind");
  }
  return {number_at(sizes.bytes, 0), number_at(sizes.bytes, 4)};
}

}  // namespace

std::string matlab_variable(const std::filesystem::path& file) {
  const std::string content = read_text_file(file);
  constexpr std::size_t kHeader = 128;
  std::string_view rest = content;
  rest.remove_prefix(std::min(kHeader, rest.size()));
  std::string variable = unpacked(next_element(rest).bytes);
  return variable.substr(8);  // its own type and length
}

std::vector<MatlabStruct> matlab_structs(MatlabValue value) {
  const auto [rows, columns] = begin_array(value, kStructs);
  const std::size_t width = number_at(next_element(value).bytes, 0);
  const std::string_view padded = next_element(value).bytes;
  std::vector<std::string> names;  // each filled up by zeros
  for (std::size_t at = 0; at < padded.size(); at += width) {
    names.emplace_back(padded.substr(at, padded.substr(at, width).find('\0')));
  }
  std::vector<MatlabStruct> structs(static_cast<std::size_t>(rows * columns));
  for (MatlabStruct& one : structs) {
    for (const std::string& name : names) one[name] = next_element(value).bytes;
  }
  return structs;
}

Eigen::MatrixXd matlab_matrix(MatlabValue value) {
  const auto [rows, columns] = begin_array(value, kDoubleArray);
  const Element numbers = next_element(value);
  Eigen::MatrixXd matrix(rows, columns);
  if (numbers.type != kDoubles || numbers.bytes.size() != sizeof(double) * matrix.size()) {
    throw std::runtime_error("a MATLAB matrix that is packed");
  }
  for (Eigen::Index i = 0; i < matrix.size(); ++i) {
    matrix(i) = load_number<double>(numbers.bytes.data() + sizeof(double) * i, ByteOrder::little);
  }
  return matrix;
}

}  // namespace pliant::test
