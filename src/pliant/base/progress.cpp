#include "pliant/base/progress.h"

#include "pliant/base/errors.h"

namespace pliant {
namespace {

class SilentProgress : public Progress {
 public:
  void begin(std::string_view /*task*/, double /*total*/) override {}
  void advance(double /*done*/) override {}
  void end() override {}
  void message(Level /*level*/, std::string_view /*text*/) override {}
};

}  // namespace

Progress& silent_progress() {
  static SilentProgress progress;  // has no state
  return progress;
}

void StopToken::throw_if_requested() const {
  if (stop_requested()) throw Interrupted();
}

}  // namespace pliant
