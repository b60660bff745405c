#pragma once

#include <functional>

namespace pliant {

/// Runs work(0) .. work(count - 1) on at most `threads` threads, each index once. Results must not
/// depend on the order. The exception of the lowest index that threw is thrown again after all have
/// ended.
void parallel_for(int count, int threads, const std::function<void(int)>& work);

}  // namespace pliant
