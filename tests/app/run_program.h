#pragma once

#include <chrono>
#include <csignal>
#include <fcntl.h>
#include <functional>
#include <string>
#include <sys/resource.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>
#include <vector>

#include "io/temporary_folder.h"

namespace pliant::test {

/// Sanitizers make a program several times slower and larger: limits of time and memory are those
/// of the plain build, times this.
#ifdef __SANITIZE_ADDRESS__
inline constexpr int kSanitizerFactor = 5;
#else
inline constexpr int kSanitizerFactor = 1;
#endif

/// What became of a run of the program.
struct ProgramRun {
  int status = -1;  ///< exit status; -signal when a signal ended it
  std::string out, err;
  double seconds = 0;
  long peak_memory_kb = 0;

  /// The last line of standard error, where an error stands.
  std::string last_line() const {
    const size_t end = err.find_last_not_of('\n');
    if (end == std::string::npos) return "";
    const size_t begin = err.rfind('\n', end);
    return err.substr(begin + 1, end - begin);
  }
};

/// How a test runs the program.
struct ProgramOptions {
  std::filesystem::path working_directory = {};
  std::function<void()> in_child = {};  ///< before the program starts, e.g. to set a limit
  double interrupt_after = 0;           ///< seconds until Ctrl-C; 0 = never
};

/// A program that has been started, its output going to files.
class StartedProgram {
 public:
  StartedProgram(const std::vector<std::string>& arguments, const ProgramOptions& options)
      : begun_(std::chrono::steady_clock::now()) {
    const std::string out = (folder_.path() / "out").string();
    const std::string err = (folder_.path() / "err").string();
    std::vector<char*> argv{const_cast<char*>(PLIANT_EXECUTABLE)};
    for (const std::string& argument : arguments)
      argv.push_back(const_cast<char*>(argument.c_str()));
    argv.push_back(nullptr);
    child_ = fork();
    if (child_ != 0) return;
    dup2(open(out.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600), STDOUT_FILENO);
    dup2(open(err.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600), STDERR_FILENO);
    if (!options.working_directory.empty()) {
      if (chdir(options.working_directory.c_str()) != 0) _exit(126);
    }
    if (options.in_child) options.in_child();
    execv(PLIANT_EXECUTABLE, argv.data());
    _exit(127);
  }

  pid_t pid() const { return child_; }

  ProgramRun wait() {
    int status = 0;
    rusage usage{};
    wait4(child_, &status, 0, &usage);
    ProgramRun run;
    run.status = WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
    run.out = content_of(folder_.path() / "out");
    run.err = content_of(folder_.path() / "err");
    run.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begun_).count();
    run.peak_memory_kb = usage.ru_maxrss;
    return run;
  }

 private:
  TemporaryFolder folder_;
  std::chrono::steady_clock::time_point begun_;
  pid_t child_ = -1;
};

inline ProgramRun run_program(const std::vector<std::string>& arguments,
                              const ProgramOptions& options = {}) {
  StartedProgram program(arguments, options);
  if (options.interrupt_after > 0) {
    std::this_thread::sleep_for(std::chrono::duration<double>(options.interrupt_after));
    kill(program.pid(), SIGINT);
  }
  return program.wait();
}

/// Names of everything in a folder, hidden files too; empty where there is no such folder.
inline std::vector<std::string> names_in(const std::filesystem::path& folder) {
  std::vector<std::string> names;
  if (!std::filesystem::exists(folder)) return names;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    names.push_back(entry.path().filename().string());
  }
  return names;
}

}  // namespace pliant::test
