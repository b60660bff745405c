#include "pliant/io/zip_file.h"

#include <algorithm>
#include <memory>
#include <system_error>

#include <fmt/format.h>
#include <zip.h>

#include "pliant/base/errors.h"

namespace pliant {
namespace {

constexpr zip_int64_t kMaxEntries = 100'000;

using Archive = std::unique_ptr<zip_t, decltype(&zip_discard)>;
using Entry = std::unique_ptr<zip_file_t, decltype(&zip_fclose)>;

Archive open_archive(const std::filesystem::path& path) {
  std::error_code ignored;  // zip_open tells what is wrong
  if (std::filesystem::is_directory(path, ignored)) {
    throw InputError({path.string()}, "is a directory", "a zip archive");
  }
  int code = 0;
  Archive archive(zip_open(path.c_str(), ZIP_RDONLY, &code), &zip_discard);
  if (!archive) {
    zip_error_t error;
    zip_error_init_with_code(&error, code);
    const std::string reason = zip_error_strerror(&error);
    zip_error_fini(&error);
    throw InputError({path.string()}, "cannot be read as a zip archive: " + reason);
  }
  if (zip_get_num_entries(archive.get(), 0) > kMaxEntries) {
    throw InputError({path.string()}, "the archive has too many files",
                     fmt::format("at most {}", kMaxEntries));
  }
  return archive;
}

}  // namespace

std::vector<std::string> zip_entries(const std::filesystem::path& path) {
  const Archive archive = open_archive(path);
  std::vector<std::string> names;
  const zip_int64_t count = zip_get_num_entries(archive.get(), 0);
  for (zip_int64_t i = 0; i < count; ++i) {
    const char* name = zip_get_name(archive.get(), static_cast<zip_uint64_t>(i), 0);
    if (name == nullptr) {
      throw InputError({path.string()}, "the archive's list of files is damaged");
    }
    const std::string_view view(name);
    if (!view.empty() && !view.ends_with('/')) names.emplace_back(view);
  }
  return names;
}

std::string read_zip_entry(const std::filesystem::path& path, const std::string& name,
                           std::size_t limit) {
  const Archive archive = open_archive(path);
  const Location where{path.string(), 0, name};
  const Entry entry(zip_fopen(archive.get(), name.c_str(), 0), &zip_fclose);
  if (!entry) {
    throw InputError(
        where, fmt::format("cannot be read from the archive: {}", zip_strerror(archive.get())));
  }
  // Sizes stated in the archive may lie: what is unpacked is counted.
  std::string content;
  std::string buffer(std::size_t{1} << 16, '\0');
  while (true) {
    const zip_int64_t count = zip_fread(entry.get(), buffer.data(), buffer.size());
    if (count == 0) return content;
    if (count < 0) throw InputError(where, "is damaged in the archive");
    content.append(buffer, 0, static_cast<std::size_t>(count));
    if (content.size() > limit) {
      throw InputError(where, "is too large when unpacked", fmt::format("at most {} bytes", limit));
    }
  }
}

}  // namespace pliant
