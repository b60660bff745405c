#pragma once

#include <string>
#include <utility>

#include "pliant/base/errors.h"

namespace pliant {

/// A photograph in which no single strip is found, with a picture of what was seen in its place.
class RefusedPhoto : public InputError {
 public:
  /// @param as_seen  the content of a PNG file (`photo_as_seen`)
  RefusedPhoto(const InputError& error, std::string as_seen)
      : InputError(error), as_seen_(std::move(as_seen)) {}

  const std::string& as_seen() const { return as_seen_; }

 private:
  std::string as_seen_;
};

}  // namespace pliant
