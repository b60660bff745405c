#pragma once

namespace pliant {

/// Schemes that take a system from one time to the next.
enum class Integrator {
  backward_euler,  ///< first order, damps strongly; the papers'
  bdf2,            ///< second order, two steps; begins with a step of backward Euler
};

/// How far the equations of a time step are solved.
enum class StepSolve {
  linearized,  ///< one linear system, as published ([T] 5.4, Baraff and Witkin 1998): a preview
  iterated,    ///< three linear systems at most, each with a line search on the energy
  converged,   ///< Newton's method to the tolerance
};

}  // namespace pliant
