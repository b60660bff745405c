#pragma once

#include <csignal>
#include <sys/resource.h>
#include <unistd.h>

namespace pliant::test {

/// Files larger than `bytes` cannot be written in this scope: as on a full disk, a write ends early
/// and the next one fails.
class FileSizeLimit {
 public:
  explicit FileSizeLimit(rlim_t bytes) : handler_(std::signal(SIGXFSZ, SIG_IGN)) {
    ::getrlimit(RLIMIT_FSIZE, &earlier_);
    const rlimit limit{bytes, earlier_.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~FileSizeLimit() {
    ::setrlimit(RLIMIT_FSIZE, &earlier_);
    std::signal(SIGXFSZ, handler_);
  }
  FileSizeLimit(const FileSizeLimit&) = delete;
  FileSizeLimit& operator=(const FileSizeLimit&) = delete;

 private:
  rlimit earlier_{};
  void (*handler_)(int);
};

/// Gives up the rights of root in this scope, which may write everywhere.
class WithoutRootRights {
 public:
  WithoutRootRights() : root_(::geteuid() == 0) {
    constexpr uid_t kNobody = 65534;
    if (root_ && ::seteuid(kNobody) != 0) ADD_FAILURE() << "seteuid";
  }
  ~WithoutRootRights() {
    if (root_ && ::seteuid(0) != 0) ADD_FAILURE() << "seteuid";
  }
  WithoutRootRights(const WithoutRootRights&) = delete;
  WithoutRootRights& operator=(const WithoutRootRights&) = delete;

 private:
  bool root_;
};

}  // namespace pliant::test
