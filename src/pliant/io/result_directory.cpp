#include "pliant/io/result_directory.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <iterator>
#include <optional>
#include <sys/file.h>
#include <system_error>
#include <unistd.h>
#include <utility>

#include <fmt/format.h>

#include "pliant/base/assert.h"
#include "pliant/base/errors.h"
#include "pliant/io/atomic_file.h"
#include "pliant/io/result_manifest.h"

namespace pliant {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kStagingPrefix = ".pliant-partial-";
constexpr const char* kListOfAll = ".pliant-results/all.json";
constexpr const char* kListOfNew = ".pliant-results/new.json";

[[noreturn]] void fail_unusable(const fs::path& directory, const std::string& reason) {
  throw InputError({directory.string()}, "cannot be used for results: " + reason,
                   "a folder that can be written to");
}

[[noreturn]] void fail_unusable(const fs::path& directory, const std::error_code& error) {
  if (error == std::errc::no_space_on_device || error == std::errc::io_error) {
    throw OutputError(directory.string(), error.message());
  }
  fail_unusable(directory, error.message());
}

bool is_staging(const fs::path& path) {
  return path.filename().string().starts_with(kStagingPrefix);
}

/// Makes `directory` and its parents; returns those that were missing, outermost first, also when
/// `error` is set on the way.
std::vector<fs::path> create_missing(const fs::path& directory, std::error_code& error) {
  std::vector<fs::path> missing;
  std::error_code ignored;
  for (fs::path path = directory; !path.empty() && !fs::exists(path, ignored);
       path = path.parent_path()) {
    missing.push_back(path);
  }
  std::reverse(missing.begin(), missing.end());
  std::vector<fs::path> created;
  for (const fs::path& path : missing) {
    if (fs::create_directory(path, error)) created.push_back(path);
    if (error) break;
  }
  return created;
}

/// The relative names of everything but folders below `directory`, staging folders left out,
/// sorted.
std::set<std::string> files_below(const fs::path& directory, std::error_code& error) {
  std::set<std::string> files;
  fs::recursive_directory_iterator entry(directory, error);
  for (; !error && entry != fs::recursive_directory_iterator(); entry.increment(error)) {
    std::error_code ignored;
    const bool is_folder = entry->symlink_status(ignored).type() == fs::file_type::directory;
    if (is_folder && entry.depth() == 0 && is_staging(entry->path())) {
      entry.disable_recursion_pending();
    } else if (!is_folder) {
      files.insert(entry->path().lexically_relative(directory).string());
    }
  }
  return files;
}

/// Removes a file and the folders above it, up to `directory`, that it leaves empty.
void remove_file(const fs::path& directory, const std::string& name) {
  std::error_code ignored;
  fs::remove(directory / name, ignored);
  for (fs::path folder = fs::path(name).parent_path(); !folder.empty();
       folder = folder.parent_path()) {
    if (!fs::remove(directory / folder, ignored)) return;
  }
}

void move_into_place(const fs::path& from, const fs::path& to) {
  std::error_code error;
  fs::create_directories(to.parent_path(), error);
  if (!error) fs::rename(from, to, error);
  if (error) throw OutputError(to.string(), error.message());
}

}  // namespace

ResultDirectory::ResultDirectory(fs::path directory, std::string command, Earlier earlier)
    : directory_(std::move(directory)), command_(std::move(command)) {
  // The parent of "results/" is "results" itself: the loop over parents needs it without slash.
  if (!directory_.has_filename() && directory_.has_relative_path()) {
    directory_ = directory_.parent_path();
  }
  try {
    prepare();
  } catch (...) {
    remove_staging();
    throw;
  }
  if (earlier == Earlier::keep) files_ = std::exchange(earlier_files_, {});
}

ResultDirectory::~ResultDirectory() { remove_staging(); }

void ResultDirectory::write(const std::string& relative_name, std::string_view content) {
  PLIANT_ASSERT(!committed_, "results are written before they are committed");
  PLIANT_ASSERT(is_safe_relative_name(relative_name), "a result stays in its folder");
  PLIANT_ASSERT(!pending_.contains(relative_name), "a result is written once");
  refuse_foreign(relative_name);
  stage(relative_name, content);
  files_.insert(relative_name);
  pending_.insert(relative_name);
  order_.push_back(relative_name);
}

void ResultDirectory::publish() {
  PLIANT_ASSERT(!committed_, "results are published before they are committed");
  // Both lists are written before anything is moved, when the disk may still turn out to be full.
  // The first names old and new files: a run that dies half-way leaves no file that is foreign.
  stage_list_of_all();
  stage(kListOfNew, manifest_text({command_, files_}));

  published_ = true;
  move_into_place(staging_ / kListOfAll, directory_ / kManifestName);
  for (const std::string& file : std::exchange(earlier_files_, {})) {
    if (!files_.contains(file)) remove_file(directory_, file);
  }
  pending_.clear();
  for (const std::string& file : std::exchange(order_, {})) {
    move_into_place(staging_ / file, directory_ / file);
  }
  move_into_place(staging_ / kListOfNew, directory_ / kManifestName);
}

void ResultDirectory::set_aside(const std::string& relative_name, std::string_view content) {
  PLIANT_ASSERT(!committed_, "files are set aside before results are committed");
  refuse_foreign(relative_name);
  stage(relative_name, content);
  earlier_files_.insert(relative_name);
  stage_list_of_all();
  published_ = true;
  move_into_place(staging_ / kListOfAll, directory_ / kManifestName);
  move_into_place(staging_ / relative_name, directory_ / relative_name);
}

fs::path ResultDirectory::grow(const std::string& relative_name) {
  PLIANT_ASSERT(is_safe_relative_name(relative_name), "a result stays in its folder");
  refuse_foreign(relative_name);
  files_.insert(relative_name);
  publish();
  fs::path file = directory_ / relative_name;
  std::error_code error;
  fs::create_directories(file.parent_path(), error);
  if (error) throw OutputError(file.string(), error.message());
  return file;
}

void ResultDirectory::commit() {
  PLIANT_ASSERT(!committed_, "results are committed once");
  publish();
  committed_ = true;
  remove_staging();
}

void ResultDirectory::stage(const std::string& relative_name, std::string_view content) {
  const std::string shown = (directory_ / relative_name).string();
  const fs::path path = staging_ / relative_name;
  std::error_code error;
  fs::create_directories(path.parent_path(), error);
  if (error) throw OutputError(shown, error.message());
  try {
    write_new_file(path, content);
  } catch (const OutputError& failure) {
    throw OutputError(shown, failure.reason());
  } catch (const InputError& failure) {
    throw OutputError(shown, failure.problem());
  }
}

void ResultDirectory::stage_list_of_all() {
  std::set<std::string> all = earlier_files_;
  all.insert(files_.begin(), files_.end());
  stage(kListOfAll, manifest_text({command_, all}));
}

void ResultDirectory::prepare() {
  std::error_code error;
  created_ = create_missing(directory_, error);
  if (error) fail_unusable(directory_, error);
  if (!fs::is_directory(directory_, error)) fail_unusable(directory_, "is not a folder");
  lock();
  const std::optional<ResultManifest> manifest = read_manifest(directory_);
  if (manifest) {
    if (manifest->command != command_) {
      throw InputError({directory_.string()},
                       fmt::format("holds results of {}", quoted_value(manifest->command)),
                       fmt::format("an empty folder or results of \"{}\"", command_));
    }
    earlier_files_ = manifest->files;
  }
  find_foreign_files(manifest.has_value());
  create_staging();
}

void ResultDirectory::lock() {
  lock_ = ::open(directory_.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (lock_ < 0) fail_unusable(directory_, std::strerror(errno));
  // Some network file systems cannot lock folders; there the user keeps runs apart.
  if (::flock(lock_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) {
    fail_unusable(directory_, "another run is writing to it");
  }
}

void ResultDirectory::find_foreign_files(bool has_results) {
  std::error_code error;
  std::set<std::string> files = files_below(directory_, error);
  if (error) fail_unusable(directory_, error);
  files.erase(std::string(kManifestName));
  std::ranges::set_difference(files, earlier_files_, std::inserter(foreign_, foreign_.end()));
  const auto in_the_way = [&](const std::string& file) {
    const std::string folder = file.substr(0, file.find('/') + 1);
    const auto beside = earlier_files_.lower_bound(folder);
    return !folder.empty() && beside != earlier_files_.end() && beside->starts_with(folder);
  };
  for (const std::string& file : foreign_) {
    if (!has_results || in_the_way(file)) refuse_foreign(file);
  }
}

void ResultDirectory::refuse_foreign(const std::string& relative_name) const {
  if (!foreign_.contains(relative_name)) return;
  throw InputError(
      {directory_.string()},
      fmt::format("holds a file that no \"{}\" wrote: {}", command_, quoted_value(relative_name)),
      fmt::format("an empty folder or results of \"{}\"", command_));
}

void ResultDirectory::create_staging() {
  // This run has the lock: staging folders that stand there are of runs that were killed.
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(directory_, error)) {
    std::error_code ignored;
    if (is_staging(entry.path())) fs::remove_all(entry.path(), ignored);
  }
  const fs::path staging = directory_ / fmt::format("{}{}", kStagingPrefix, ::getpid());
  fs::create_directory(staging, error);
  if (error) fail_unusable(directory_, error);
  staging_ = staging;
}

void ResultDirectory::remove_staging() noexcept {
  std::error_code ignored;
  if (!staging_.empty()) fs::remove_all(staging_, ignored);
  staging_.clear();
  if (lock_ >= 0) ::close(lock_);
  lock_ = -1;
  if (published_) return;
  // Only empty folders go: `remove` leaves what someone else put there meanwhile.
  for (auto folder = created_.rbegin(); folder != created_.rend(); ++folder) {
    fs::remove(*folder, ignored);
  }
  created_.clear();
}

}  // namespace pliant
