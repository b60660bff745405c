#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace pliant {

/// What a stopped command leaves for the next, see `ResultDirectory::set_aside`.
inline constexpr const char* kProgressFile = "progress.bin";

/// A folder of results that a command fills completely or leaves as it was.
///
/// Files are collected in a hidden folder inside `directory`; `commit` moves them into place and
/// removes what an earlier run of the same command left there. A long run may `publish` what it has
/// so far, again and again. A hidden list of files, `.pliant-results.json`, tells results from
/// anything else. A folder with files and without the list of the same command is refused, and so
/// are other files in the folders of listed results, where new results may want their names. What
/// the user put beside listed results stays there, and is never overwritten.
/// One run at a time may write to a folder.
class ResultDirectory {
 public:
  /// What becomes of the results of an earlier run.
  enum class Earlier {
    replace,  ///< removed when the first new results are put into place
    keep,     ///< they are the beginning of this run's
  };

  /// Makes `directory` (and what is missing above it) or checks that it can be written to.
  /// @param command  the name of the command that makes the results, e.g. "fit"
  /// @throws InputError when the folder cannot be made or written to, holds something else and no
  ///         results of the command, or is being written to by another run
  ResultDirectory(std::filesystem::path directory, std::string command,
                  Earlier earlier = Earlier::replace);

  /// Removes what was written and not put into place, and, where nothing was, the folders that the
  /// constructor made.
  ~ResultDirectory();
  ResultDirectory(const ResultDirectory&) = delete;
  ResultDirectory& operator=(const ResultDirectory&) = delete;

  const std::filesystem::path& path() const { return directory_; }
  /// Where the files written so far stand until `commit`, for work that reads them back.
  const std::filesystem::path& staging() const { return staging_; }

  /// Adds a file; `relative_name` may have folders in it ("predictions/warp.csv"). A file that was
  /// put into place before is replaced.
  /// @throws OutputError when writing fails
  /// @throws InputError where a file of that name stands there that is not of the command
  void write(const std::string& relative_name, std::string_view content);

  /// Puts what was written so far into place, in the order in which it was written; more can be
  /// written afterwards. What tells of other files, such as a checkpoint, is best written last.
  /// @throws OutputError
  void publish();

  /// Puts a file into place at once, beside the results of an earlier run, which stay. `publish`
  /// and `commit` remove it.
  /// @throws OutputError
  void set_aside(const std::string& relative_name, std::string_view content);

  /// Adds a file that grows in place from now on, complete at any time.
  /// @return where it is to be written
  /// @throws OutputError
  std::filesystem::path grow(const std::string& relative_name);

  /// Puts the files into place. Nothing can be written afterwards.
  /// @throws OutputError
  void commit();

 private:
  void prepare();
  void lock();
  void find_foreign_files(bool has_results);
  void refuse_foreign(const std::string& relative_name) const;
  void create_staging();
  void stage(const std::string& relative_name, std::string_view content);
  /// The list of what is in place and of what comes to it.
  void stage_list_of_all();
  void remove_staging() noexcept;

  std::filesystem::path directory_;
  std::string command_;
  std::filesystem::path staging_;
  std::vector<std::filesystem::path> created_;  // folders made by the constructor, outermost first
  std::set<std::string> earlier_files_;
  std::set<std::string> foreign_;   // the user's
  std::set<std::string> files_;     // of this run
  std::set<std::string> pending_;   // those of them that are not in place yet
  std::vector<std::string> order_;  // in which the pending ones were written
  int lock_ = -1;                   // descriptor of directory_; closing it releases the lock
  bool published_ = false;
  bool committed_ = false;
};

}  // namespace pliant
