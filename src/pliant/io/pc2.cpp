#include "pliant/io/pc2.h"

#include <cerrno>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <string>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "pliant/base/assert.h"
#include "pliant/base/errors.h"
#include "pliant/io/byte_order.h"
#include "pliant/io/text_file.h"

namespace pliant {
namespace {

// The header: signature, version, number of points, first frame, step, number of frames.
constexpr std::string_view kSignature("POINTCACHE2\0", 12);
constexpr std::int32_t kVersion = 1;
constexpr std::size_t kPointCountAt = 16;
constexpr std::size_t kStartFrameAt = 20;
constexpr std::size_t kFrameStepAt = 24;
constexpr std::size_t kFrameCountAt = 28;
constexpr std::size_t kHeaderSize = 32;
constexpr std::size_t kPointSize = 12;

struct Header {
  int point_count = 0;
  double start_frame = 0;
  double frame_step = 1;
  int frame_count = 0;

  std::size_t size_with(std::size_t frames) const {
    return kHeaderSize + frames * static_cast<std::size_t>(point_count) * kPointSize;
  }
};

std::string header_bytes(const Header& header) {
  std::string bytes(kSignature);
  append_number(kVersion, ByteOrder::little, bytes);
  append_number(static_cast<std::int32_t>(header.point_count), ByteOrder::little, bytes);
  append_number(static_cast<float>(header.start_frame), ByteOrder::little, bytes);
  append_number(static_cast<float>(header.frame_step), ByteOrder::little, bytes);
  append_number(static_cast<std::int32_t>(header.frame_count), ByteOrder::little, bytes);
  return bytes;
}

/// @param size  of the whole file; must hold the frames that the header claims
Header parse_header(std::string_view bytes, std::uintmax_t size, const std::string& file) {
  if (bytes.size() < kHeaderSize || !bytes.starts_with(kSignature)) {
    throw InputError({file}, "is no PC2 file", "a point cache that starts with POINTCACHE2");
  }
  const auto integer = [&](std::size_t at) {
    return load_number<std::int32_t>(bytes.data() + at, ByteOrder::little);
  };
  const auto real = [&](std::size_t at) {
    return static_cast<double>(load_number<float>(bytes.data() + at, ByteOrder::little));
  };
  if (integer(kSignature.size()) != kVersion) {
    throw InputError({file}, fmt::format("unknown version {}", integer(kSignature.size())), "1");
  }
  const Header header{integer(kPointCountAt), real(kStartFrameAt), real(kFrameStepAt),
                      integer(kFrameCountAt)};
  if (header.point_count < 1 || header.frame_count < 0) {
    throw InputError({file}, fmt::format("claims {} points and {} frames", header.point_count,
                                         header.frame_count));
  }
  if (!std::isfinite(header.start_frame) || !std::isfinite(header.frame_step)) {
    throw InputError({file}, "the first frame or the step is not finite");
  }
  if (header.size_with(static_cast<std::size_t>(header.frame_count)) > size) {
    throw InputError({file}, fmt::format("is too small for its {} frames of {} points",
                                         header.frame_count, header.point_count));
  }
  return header;
}

}  // namespace

Pc2Writer::Pc2Writer(std::filesystem::path path, int point_count, double frame_step)
    : path_(std::move(path)), point_count_(point_count) {
  PLIANT_ASSERT(point_count > 0 && frame_step > 0, "a cache has points and goes forward");
  file_.open(path_, std::ios::in | std::ios::out | std::ios::binary | std::ios::trunc);
  if (!file_) {
    throw InputError({path_.string()}, fmt::format("cannot be created: {}", std::strerror(errno)),
                     "a place that can be written to");
  }
  write(0, header_bytes({point_count, 0, frame_step, 0}));
}

Pc2Writer Pc2Writer::resume(const std::filesystem::path& path, int point_count, int frames) {
  PLIANT_ASSERT(frames >= 0, "a number of frames");
  const std::string name = path.string();
  Pc2Writer writer;
  writer.path_ = path;
  writer.file_.open(path, std::ios::in | std::ios::out | std::ios::binary);
  std::string bytes(kHeaderSize, '\0');
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(path, error);
  if (error || !writer.file_.read(bytes.data(), kHeaderSize)) {
    throw InputError({name}, "cannot be read", "the PC2 file of the run to go on with");
  }
  Header header = parse_header(bytes, size, name);
  if (header.point_count != point_count || header.frame_count < frames) {
    throw InputError(
        {name}, fmt::format("has {} frames of {} points", header.frame_count, header.point_count),
        fmt::format("{} frames of {} points", frames, point_count));
  }
  header.frame_count = frames;
  std::filesystem::resize_file(path, header.size_with(static_cast<std::size_t>(frames)), error);
  if (error) throw OutputError(name, error.message());
  writer.point_count_ = point_count;
  writer.frame_count_ = frames;
  writer.write(0, header_bytes(header));
  return writer;
}

void Pc2Writer::append(std::span<const Point3> points) {
  PLIANT_ASSERT(points.size() == static_cast<std::size_t>(point_count_),
                "a frame has the points of the cache");
  std::string bytes;
  bytes.reserve(points.size() * kPointSize);
  for (const Point3& point : points) {
    for (const double coordinate : point) {
      append_number(static_cast<float>(coordinate), ByteOrder::little, bytes);
    }
  }
  const Header header{point_count_};
  write(static_cast<std::streamoff>(header.size_with(static_cast<std::size_t>(frame_count_))),
        bytes);
  // Counted only when it is there: a run that is killed leaves a file that can be read.
  ++frame_count_;
  std::string count;
  append_number(static_cast<std::int32_t>(frame_count_), ByteOrder::little, count);
  write(kFrameCountAt, count);
}

void Pc2Writer::write(std::streamoff at, const std::string& bytes) {
  file_.seekp(at);
  file_.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  file_.flush();
  if (!file_) throw OutputError(path_.string(), std::strerror(errno));
}

Pc2Cache read_pc2(const std::filesystem::path& path) {
  const std::string bytes = read_text_file(path, kMaxMeshFileSize);
  const Header header = parse_header(bytes, bytes.size(), path.string());
  Pc2Cache cache{header.point_count, header.start_frame, header.frame_step, {}};
  const char* at = bytes.data() + kHeaderSize;
  for (int i = 0; i < header.frame_count; ++i) {
    auto& frame = cache.frames.emplace_back(static_cast<std::size_t>(header.point_count));
    for (auto& point : frame) {
      for (float& coordinate : point) {
        coordinate = load_number<float>(at, ByteOrder::little);
        at += sizeof(float);
      }
    }
  }
  return cache;
}

}  // namespace pliant
