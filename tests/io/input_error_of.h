#pragma once

#include <utility>

#include <gtest/gtest.h>

#include "pliant/base/errors.h"

namespace pliant::test {

/// The InputError that `action` throws; a test failure when it throws none.
template <typename Action>
InputError input_error_of(Action&& action) {
  try {
    std::forward<Action>(action)();
  } catch (const InputError& error) {
    return error;
  }
  ADD_FAILURE() << "no InputError";
  return InputError({}, "");
}

}  // namespace pliant::test
