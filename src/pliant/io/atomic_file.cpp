#include "pliant/io/atomic_file.h"

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <string>
#include <system_error>
#include <unistd.h>

#include <fmt/format.h>

#include "pliant/base/errors.h"

namespace pliant {
namespace {

/// The medium, not the place the user chose, is what failed.
bool is_medium_error(int error) {
  return error == ENOSPC || error == EDQUOT || error == EIO || error == EFBIG;
}

[[noreturn]] void fail_to_create(const std::filesystem::path& path, int error) {
  if (is_medium_error(error)) throw OutputError(path.string(), std::strerror(error));
  throw InputError({path.string()}, fmt::format("cannot be created: {}", std::strerror(error)),
                   "a place that can be written to");
}

/// Writes everything; returns 0 or the error.
int write_all(int descriptor, std::string_view content) {
  while (!content.empty()) {
    const ssize_t count = ::write(descriptor, content.data(), content.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return errno;
    content.remove_prefix(static_cast<std::size_t>(count));
  }
  return 0;
}

/// Some file systems tell only here that they were full.
int sync_and_close(int descriptor) {
  int error = ::fsync(descriptor) == 0 || errno == EINVAL || errno == EROFS ? 0 : errno;
  if (::close(descriptor) != 0 && error == 0) error = errno;
  return error;
}

}  // namespace

void write_new_file(const std::filesystem::path& path, std::string_view content) {
  const int descriptor = ::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  if (descriptor < 0) fail_to_create(path, errno);
  const int write_error = write_all(descriptor, content);
  const int close_error = sync_and_close(descriptor);
  const int error = write_error != 0 ? write_error : close_error;
  if (error == 0) return;
  ::unlink(path.c_str());
  throw OutputError(path.string(), std::strerror(error));
}

void write_file_atomically(const std::filesystem::path& path, std::string_view content) {
  const std::string name = fmt::format(".{}.partial-{}", path.filename().string(), ::getpid());
  const std::filesystem::path partial = path.parent_path() / name;
  std::error_code ignored;
  std::filesystem::remove(partial, ignored);  // of an earlier process with the same number
  try {
    write_new_file(partial, content);
  } catch (const OutputError& error) {
    throw OutputError(path.string(), error.reason());
  } catch (const InputError& error) {
    throw InputError({path.string()}, error.problem(), error.expected());
  }
  std::error_code error;
  std::filesystem::rename(partial, path, error);
  if (!error) return;
  std::filesystem::remove(partial, ignored);
  fail_to_create(path, error.value());
}

}  // namespace pliant
