#include "pliant/solver/workspace.h"

#include "pliant/math/sparse_cholesky.h"

namespace pliant {

Workspace::Workspace(const System& system)
    : hessian(system.make_hessian()), solver(std::make_unique<SparseCholesky>(hessian.matrix)) {}

}  // namespace pliant
