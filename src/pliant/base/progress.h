#pragma once

#include <atomic>
#include <string_view>

namespace pliant {

enum class Level { debug, info, warning, error };

/// Where long work reports to. Calls come from one thread at a time; tasks do not nest.
class Progress {
 public:
  virtual ~Progress() = default;

  /// @param total  work of the whole task in a unit of the caller's choice; 0 = unknown
  virtual void begin(std::string_view task, double total) = 0;
  /// @param done  work done since `begin`, in the unit of `total`
  virtual void advance(double done) = 0;
  virtual void end() = 0;
  virtual void message(Level level, std::string_view text) = 0;
};

/// A sink that does nothing.
Progress& silent_progress();

/// Begins a task and ends it with the scope, also when an exception leaves it.
class ProgressTask {
 public:
  ProgressTask(Progress& progress, std::string_view task, double total) : progress_(progress) {
    progress_.begin(task, total);
  }
  ~ProgressTask() { progress_.end(); }
  ProgressTask(const ProgressTask&) = delete;
  ProgressTask& operator=(const ProgressTask&) = delete;

  void advance(double done) { progress_.advance(done); }

 private:
  Progress& progress_;
};

/// What long work asks, at least every tenth of a second, whether it should stop.
/// A default-constructed token never asks to stop. The flag must outlive the token.
class StopToken {
 public:
  StopToken() = default;
  explicit StopToken(const std::atomic<bool>& flag) : flag_(&flag) {}

  bool stop_requested() const noexcept {
    return flag_ != nullptr && flag_->load(std::memory_order_relaxed);
  }

  /// @throws Interrupted when a stop was requested
  void throw_if_requested() const;

 private:
  const std::atomic<bool>* flag_ = nullptr;
};

/// The owner's side of a StopToken; `request` is safe in a signal handler.
class StopFlag {
 public:
  void request() noexcept { flag_.store(true, std::memory_order_relaxed); }
  StopToken token() const { return StopToken(flag_); }

 private:
  static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler sets the flag");
  std::atomic<bool> flag_ = false;
};

}  // namespace pliant
