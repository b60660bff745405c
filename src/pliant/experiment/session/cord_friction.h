#pragma once

namespace pliant {

/// What is known of the friction of a session's cords ([T] 3.2.3).
struct CordFriction {
  double width = 0;      ///< of the loop between pulling and giving way, of each cord (N)
  bool unknown = false;  ///< each cord's own width is estimated along
};

}  // namespace pliant
