#pragma once

#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

namespace pliant {

/// What a long computation has found out so far, in the order in which it asked. One that was
/// stopped asks the same questions again, is answered at once as far as it had come, and goes on
/// from there.
class Journal {
 public:
  using Numbers = std::vector<double>;
  struct Entry {
    std::string question;
    Numbers answer;
  };
  /// Everything that it remembers.
  struct Content {
    std::vector<Entry> entries;
    Numbers reached;
    std::map<std::string, Numbers> kept;
    std::map<std::string, std::vector<Entry>> parts =
        {};  ///< answers of works that go on side by side
  };

  /// @param changed  is called whenever there is more to remember; without it nothing is remembered
  explicit Journal(std::function<void(const Content&)> changed = {});
  virtual ~Journal() = default;

  const Content& content() const { return content_; }

  /// Begins with what an earlier run remembered.
  /// @param file  of that, for errors
  void resume(Content earlier, std::string file);

  /// The answer that is known already, else the one that `work` finds.
  /// @throws InputError where the journal knows the answer to another question: it was written by
  ///         another computation
  virtual Numbers answer(const std::string& question, const std::function<Numbers()>& work);

  /// Where the work on the present question has come to; empty at its beginning.
  const Numbers& reached() const { return content_.reached; }
  void reach(Numbers where);

  /// What the next questions start from, by name.
  const std::map<std::string, Numbers>& kept() const { return content_.kept; }
  void keep(std::map<std::string, Numbers> all);

  /// The journal of one of several works that go on side by side, which remembers answers alone.
  /// Works on different threads may ask theirs at the same time, while nobody asks this one.
  /// @return lives as long as this journal
  Journal& part(const std::string& name);

 private:
  bool remembers() const { return static_cast<bool>(changed_); }

  std::function<void(const Content&)> changed_;
  Content content_;
  std::string file_;
  std::size_t next_ = 0;  // entry that is asked for next
  std::map<std::string, std::unique_ptr<Journal>> parts_;
  std::mutex parts_change_;
};

/// One that remembers nothing.
Journal& forgetful_journal();

}  // namespace pliant
