#pragma once

#include <functional>

namespace pliant {

/// Runs `work` with at most `threads` threads for all loops in it; where a limit holds already,
/// with no more than that. Loops outside of any limit run on one thread.
void with_threads(int threads, const std::function<void()>& work);

/// Runs work(0) .. work(count - 1), each index once, on the threads of the present limit. Results
/// must not depend on the order. The exception of the lowest index that threw is thrown again after
/// all have ended. A thread that waits for a loop takes part in that loop alone, so that what it
/// holds is not used twice.
void parallel_for(int count, const std::function<void(int)>& work);

/// Makes items 0 .. count - 1, one after the other, and uses each when it is made, also one after
/// the other; the next is made while the last is used where the present limit allows two threads.
/// After an exception nothing more is made, nor is anything used that comes later; that of the
/// lowest item is thrown again.
void pipeline(int count, const std::function<void(int)>& make, const std::function<void(int)>& use);

/// The loop on at most `threads` threads.
void parallel_for(int count, int threads, const std::function<void(int)>& work);

}  // namespace pliant
