// .nrrd files of labels (teem.sourceforge.net/nrrd/format.html): a header of lines `field: value`,
// an empty line, and the numbers, raw, packed with gzip or as text; they may stand in a file of
// their own.

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <map>
#include <sstream>
#include <string>

#include <Eigen/LU>
#include <fmt/format.h>
#include <zlib.h>

#include "pliant/base/errors.h"
#include "pliant/base/number_text.h"
#include "pliant/geometry/label_volume.h"
#include "pliant/io/text_file.h"

namespace pliant {
namespace {

constexpr std::int64_t kMostVoxels = 2'000'000'000;

struct NrrdHeader {
  std::string file;
  std::map<std::string, std::string> fields;
  std::size_t end = 0;  ///< of the header in its file

  const std::string& need(const std::string& field) const {
    const auto found = fields.find(field);
    if (found != fields.end()) return found->second;
    throw InputError({file, 0, field}, "is missing", "a .nrrd file of three dimensions");
  }
  std::string get(const std::string& field) const {
    const auto found = fields.find(field);
    return found == fields.end() ? std::string() : found->second;
  }
  [[noreturn]] void refuse(const std::string& field, const std::string& problem,
                           const std::string& expected) const {
    throw InputError({file, 0, field}, problem, expected);
  }
};

NrrdHeader header_of(const std::string& text, const std::string& file) {
  NrrdHeader header{file, {}, text.size()};
  if (!text.starts_with("NRRD")) {
    throw InputError({file, 1, {}}, "is no .nrrd file", "a first line NRRD0004 or the like");
  }
  std::size_t at = 0;
  while (at < text.size()) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    std::string line = text.substr(at, end - at);
    if (line.ends_with('\r')) line.pop_back();
    at = end + 1;
    if (line.empty()) {
      header.end = std::min(at, text.size());
      break;
    }
    const std::size_t colon = line.find(": ");
    if (colon == std::string::npos || line.front() == '#') continue;
    header.fields[line.substr(0, colon)] = line.substr(colon + 2);
  }
  return header;
}

std::vector<double> numbers_in(std::string text) {
  std::ranges::replace_if(
      text, [](char c) { return c == '(' || c == ')' || c == ','; }, ' ');
  std::istringstream words(text);
  std::vector<double> numbers;
  std::string word;
  while (words >> word) {
    if (const auto number = parse_number(word)) numbers.push_back(*number);
  }
  return numbers;
}

void read_geometry(const NrrdHeader& header, LabelVolume& volume) {
  const std::vector<double> sizes = numbers_in(header.need("sizes"));
  if (sizes.size() != 3 || header.need("dimension") != "3") {
    header.refuse("sizes", "are not three numbers of voxels", "a volume of one label a voxel");
  }
  double voxels = 1;
  for (int a = 0; a < 3; ++a) {
    volume.size(a) = static_cast<int>(sizes[static_cast<std::size_t>(a)]);
    voxels *= sizes[static_cast<std::size_t>(a)];
  }
  if (volume.size.minCoeff() < 2 || voxels > static_cast<double>(kMostVoxels)) {
    header.refuse("sizes", "make no volume that can be used", "2 voxels along each axis or more");
  }
  const std::vector<double> axes = numbers_in(header.get("space directions"));
  const std::vector<double> spacings = numbers_in(header.get("spacings"));
  if (axes.size() == 9) {
    volume.axes = Eigen::Map<const Eigen::Matrix3d>(axes.data());
  } else if (spacings.size() == 3) {
    volume.axes = Eigen::Map<const Eigen::Vector3d>(spacings.data()).asDiagonal();
  } else {
    header.refuse("space directions", "are missing, and so are `spacings`",
                  "how far voxels are apart");
  }
  if (!(std::abs(volume.axes.determinant()) > 0)) {
    header.refuse("space directions", "span no volume", "three directions");
  }
  const std::vector<double> origin = numbers_in(header.get("space origin"));
  if (origin.size() == 3) volume.origin = Eigen::Map<const Eigen::Vector3d>(origin.data());
}

std::string unpacked(const std::string& packed, std::size_t bytes, const NrrdHeader& header) {
  std::string raw(bytes, '\0');
  z_stream stream{};
  constexpr int kGzip = 16 + MAX_WBITS;
  inflateInit2(&stream, kGzip);
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(packed.data()));
  stream.avail_in = static_cast<uInt>(packed.size());
  stream.next_out = reinterpret_cast<Bytef*>(raw.data());
  stream.avail_out = static_cast<uInt>(raw.size());
  const int end = inflate(&stream, Z_FINISH);
  const bool whole = end == Z_STREAM_END && stream.total_out == bytes;
  inflateEnd(&stream);
  if (!whole)
    header.refuse("encoding", "is `gzip`, and what follows cannot be unpacked", "a whole file");
  return raw;
}

template <class Number>
void append_numbers(const std::string& raw, bool swap, std::vector<int>& labels) {
  for (std::size_t at = 0; at + sizeof(Number) <= raw.size(); at += sizeof(Number)) {
    std::array<char, sizeof(Number)> bytes{};
    std::copy_n(raw.begin() + static_cast<std::ptrdiff_t>(at), sizeof(Number), bytes.begin());
    if (swap) std::ranges::reverse(bytes);
    labels.push_back(static_cast<int>(std::bit_cast<Number>(bytes)));
  }
}

struct NumberType {
  std::size_t bytes = 0;
  void (*append)(const std::string& raw, bool swap, std::vector<int>& labels) = nullptr;
};

template <class Number>
constexpr NumberType number_type() {
  return {sizeof(Number), append_numbers<Number>};
}

/// The type of a name; null for others.
const NumberType* find_number_type(const std::string& name) {
  constexpr NumberType kInt8 = number_type<std::int8_t>(), kUint8 = number_type<std::uint8_t>();
  constexpr NumberType kInt16 = number_type<std::int16_t>(), kUint16 = number_type<std::uint16_t>();
  constexpr NumberType kInt32 = number_type<std::int32_t>(), kUint32 = number_type<std::uint32_t>();
  static const std::map<std::string, NumberType> kTypes{
      {"signed char", kInt8},    {"int8", kInt8},
      {"int8_t", kInt8},         {"uchar", kUint8},
      {"unsigned char", kUint8}, {"uint8", kUint8},
      {"uint8_t", kUint8},       {"short", kInt16},
      {"short int", kInt16},     {"signed short", kInt16},
      {"int16", kInt16},         {"int16_t", kInt16},
      {"ushort", kUint16},       {"unsigned short", kUint16},
      {"uint16", kUint16},       {"uint16_t", kUint16},
      {"int", kInt32},           {"signed int", kInt32},
      {"int32", kInt32},         {"int32_t", kInt32},
      {"uint", kUint32},         {"unsigned int", kUint32},
      {"uint32", kUint32},       {"uint32_t", kUint32}};
  const auto found = kTypes.find(name);
  return found == kTypes.end() ? nullptr : &found->second;
}

void read_numbers(const NrrdHeader& header, const std::string& body, LabelVolume& volume) {
  const std::string& type = header.need("type");
  const NumberType* numbers = find_number_type(type);
  if (!numbers) header.refuse("type", "is `" + type + "`", "whole numbers: uchar, short, int, ...");
  const auto count = static_cast<std::size_t>(volume.size.cast<std::int64_t>().prod());
  const std::string& encoding = header.need("encoding");
  const std::size_t needed = count * numbers->bytes;
  std::string raw;
  if (encoding == "raw") {
    raw = body.substr(0, needed);
  } else if (encoding == "gzip" || encoding == "gz") {
    raw = unpacked(body, needed, header);
  } else if (encoding == "text" || encoding == "txt" || encoding == "ascii") {
    for (const double number : numbers_in(body)) volume.labels.push_back(static_cast<int>(number));
  } else {
    header.refuse("encoding", "is `" + encoding + "`", "raw, gzip or ascii");
  }
  const bool swap = (header.get("endian") == "big") == (std::endian::native == std::endian::little);
  numbers->append(raw, swap, volume.labels);
  if (volume.labels.size() != count) {
    header.refuse("sizes",
                  fmt::format("are of {} voxels, and the file has {}", count, volume.labels.size()),
                  "as many numbers as voxels");
  }
}

}  // namespace

LabelVolume read_label_volume(const std::filesystem::path& path) {
  constexpr std::size_t kLargest = std::size_t{8} << 30;
  const std::string text = read_text_file(path, kLargest);
  const NrrdHeader header = header_of(text, path.string());
  LabelVolume volume;
  read_geometry(header, volume);
  std::string apart = header.get("data file");
  if (apart.empty()) apart = header.get("datafile");
  read_numbers(header,
               apart.empty() ? text.substr(header.end)
                             : read_text_file(path.parent_path() / apart, kLargest),
               volume);
  return volume;
}

}  // namespace pliant
