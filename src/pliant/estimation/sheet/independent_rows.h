#pragma once

#include <Eigen/Core>

#include "pliant/experiment/session/sheet_test.h"

namespace pliant {

/// Positions that are independent as far as their errors go: rows over the number of those that go
/// together along the frames (`correlation_length`), and again over that of those that go together
/// on the mesh, where errors correlated by r along an edge spread over ((1 + r) / (1 - r))^2 nodes.
/// @param test  compares positions
/// @param differences  of its rows (m)
double independent_rows(const SheetTest& test, const Eigen::VectorXd& differences);

/// What the errors of neighbours on the mesh do not share: their root mean square if each node had
/// only an error of its own (m).
double own_scatter(const SheetTest& test, const Eigen::VectorXd& differences);

}  // namespace pliant
