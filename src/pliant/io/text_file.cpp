#include "pliant/io/text_file.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <string_view>
#include <sys/stat.h>
#include <unistd.h>
#include <utility>

#include <fmt/format.h>
#include <iconv.h>

#include "pliant/base/errors.h"

namespace pliant {
namespace {

constexpr std::string_view kUtf8Mark = "\xEF\xBB\xBF";
constexpr std::string_view kUtf16LittleMark = "\xFF\xFE";
constexpr std::string_view kUtf16BigMark = "\xFE\xFF";

class FileDescriptor {
 public:
  explicit FileDescriptor(int descriptor) : descriptor_(descriptor) {}
  ~FileDescriptor() {
    if (descriptor_ >= 0) ::close(descriptor_);
  }
  FileDescriptor(const FileDescriptor&) = delete;
  FileDescriptor& operator=(const FileDescriptor&) = delete;
  int get() const { return descriptor_; }

 private:
  int descriptor_;
};

[[noreturn]] void fail_too_large(const std::string& file, std::size_t limit) {
  throw InputError({file}, "the file is too large",
                   fmt::format("at most {} MiB", std::max<std::size_t>(1, limit >> 20)));
}

/// @throws InputError unless it is a regular file of at most `limit` bytes
void check_kind(const struct stat& status, const std::string& file, std::size_t limit) {
  if (S_ISDIR(status.st_mode)) throw InputError({file}, "is a directory", "a file");
  if (!S_ISREG(status.st_mode)) throw InputError({file}, "is not a regular file", "a file");
  if (static_cast<std::uintmax_t>(status.st_size) > limit) fail_too_large(file, limit);
}

/// Converts with iconv; `decode` may be called once.
class Decoder {
 public:
  Decoder(const std::string& encoding, const std::string& file)
      : converter_(::iconv_open("UTF-8", encoding.c_str())), encoding_(encoding), file_(file) {
    if (converter_ == reinterpret_cast<iconv_t>(-1)) {
      throw InputError({file, 0, "encoding"}, "unknown encoding " + quoted_value(encoding),
                       "a name such as utf-8, utf-16le, latin1, windows-1252, gbk or shift_jis");
    }
  }
  ~Decoder() { ::iconv_close(converter_); }
  Decoder(const Decoder&) = delete;
  Decoder& operator=(const Decoder&) = delete;

  std::string decode(std::string bytes) {
    std::string text;
    char* in = bytes.data();
    std::size_t in_left = bytes.size();
    while (in_left > 0) convert(&in, &in_left, text);
    convert(nullptr, nullptr, text);  // some encodings hold back a character
    return text;
  }

 private:
  void convert(char** in, std::size_t* in_left, std::string& text) {
    std::array<char, 1 << 14> buffer;
    char* out = buffer.data();
    std::size_t out_left = buffer.size();
    const std::size_t result = ::iconv(converter_, in, in_left, &out, &out_left);
    text.append(buffer.data(), out);
    if (result == static_cast<std::size_t>(-1) && errno != E2BIG) fail(text);
  }

  [[noreturn]] void fail(const std::string& decoded) const {
    const auto line = static_cast<int>(1 + std::count(decoded.begin(), decoded.end(), '\n'));
    throw InputError({file_, line, {}}, fmt::format("the text is not {}", encoding_),
                     "UTF-8, or for a data file the encoding named by \"encoding:\"");
  }

  iconv_t converter_;
  std::string encoding_;
  std::string file_;
};

/// iconv takes conversion options after a slash; those are none of the user's business.
bool is_encoding_name(const std::string& encoding) {
  return std::all_of(encoding.begin(), encoding.end(), [](unsigned char c) {
    return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '-' ||
           c == '_' || c == '.' || c == ':' || c == '+';
  });
}

void refuse_nul(const std::string& text, const std::string& file) {
  const std::size_t nul = text.find('\0');
  if (nul == std::string::npos) return;
  const auto end = text.begin() + static_cast<std::ptrdiff_t>(nul);
  const auto line = static_cast<int>(1 + std::count(text.begin(), end, '\n'));
  throw InputError({file, line, {}}, "the file is not text (it holds NUL characters)",
                   "a text file; UTF-16 without byte order mark needs \"encoding: utf-16le\"");
}

}  // namespace

std::string read_text_file(const std::filesystem::path& path, std::size_t limit) {
  const std::string file = path.string();
  // O_NONBLOCK: opening a named pipe that nobody writes to must not wait.
  const FileDescriptor descriptor(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
  struct stat status {};
  if (descriptor.get() < 0 || ::fstat(descriptor.get(), &status) != 0) {
    throw InputError({file}, fmt::format("cannot be read: {}", std::strerror(errno)));
  }
  check_kind(status, file, limit);
  std::string bytes(static_cast<std::size_t>(status.st_size) + 1, '\0');
  std::size_t size = 0;
  while (true) {
    if (size == bytes.size()) bytes.resize(2 * size);  // it grew, or its size was not known
    const ssize_t count = ::read(descriptor.get(), bytes.data() + size, bytes.size() - size);
    if (count == 0) break;
    if (count < 0 && errno == EINTR) continue;
    if (count < 0)
      throw InputError({file}, fmt::format("cannot be read: {}", std::strerror(errno)));
    size += static_cast<std::size_t>(count);
    if (size > limit) fail_too_large(file, limit);
  }
  bytes.resize(size);
  return bytes;
}

std::string decode_text(std::string bytes, const std::string& encoding, const std::string& file) {
  if (!is_encoding_name(encoding)) {
    throw InputError({file, 0, "encoding"}, "unknown encoding " + quoted_value(encoding));
  }
  std::string from = encoding.empty() ? "UTF-8" : encoding;
  const std::string_view start = bytes;
  if (start.starts_with(kUtf8Mark)) {
    bytes.erase(0, kUtf8Mark.size());
    from = "UTF-8";
  } else if (start.starts_with(kUtf16LittleMark)) {
    bytes.erase(0, kUtf16LittleMark.size());
    from = "UTF-16LE";
  } else if (start.starts_with(kUtf16BigMark)) {
    bytes.erase(0, kUtf16BigMark.size());
    from = "UTF-16BE";
  }
  std::string text = Decoder(from, file).decode(std::move(bytes));
  refuse_nul(text, file);
  return text;
}

}  // namespace pliant
