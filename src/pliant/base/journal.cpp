#include "pliant/base/journal.h"

#include <utility>

#include "pliant/base/errors.h"

namespace pliant {

Journal::Journal(std::function<void(const Content&)> changed) : changed_(std::move(changed)) {}

void Journal::resume(Content earlier, std::string file) {
  content_ = std::move(earlier);
  file_ = std::move(file);
  next_ = 0;
  parts_.clear();
}

Journal::Numbers Journal::answer(const std::string& question,
                                 const std::function<Numbers()>& work) {
  if (!remembers()) return work();
  if (next_ < content_.entries.size()) {
    const Entry& known = content_.entries[next_++];
    if (known.question == question) return known.answer;
    throw InputError({file_}, "is the progress of something else: " + quoted_value(known.question),
                     quoted_value(question) + ", with the same data, settings and version");
  }
  Numbers found = work();
  content_.entries.push_back({question, found});
  content_.reached.clear();
  ++next_;
  changed_(content_);
  return found;
}

void Journal::reach(Numbers where) {
  if (!remembers()) return;
  content_.reached = std::move(where);
  changed_(content_);
}

void Journal::keep(std::map<std::string, Numbers> all) {
  if (remembers()) content_.kept = std::move(all);
}

Journal& Journal::part(const std::string& name) {
  if (!remembers()) return *this;
  const std::lock_guard lock(parts_change_);
  std::unique_ptr<Journal>& part = parts_[name];
  if (part) return *part;
  part = std::make_unique<Journal>([this, name](const Content& own) {
    const std::lock_guard change(parts_change_);
    content_.parts[name] = own.entries;
    changed_(content_);
  });
  part->resume({content_.parts[name], {}, {}}, file_);
  return *part;
}

Journal& forgetful_journal() {
  static Journal journal;
  return journal;
}

}  // namespace pliant
