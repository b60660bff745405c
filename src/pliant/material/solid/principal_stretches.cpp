#include "pliant/material/solid/principal_stretches.h"

#include <cmath>

#include <Eigen/Eigenvalues>

namespace pliant {
namespace {

SolidVector symmetric_part(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  SolidVector m;
  m << a(0) * b(0), a(1) * b(1), a(2) * b(2), (a(1) * b(2) + a(2) * b(1)) / 2,
      (a(0) * b(2) + a(2) * b(0)) / 2, (a(0) * b(1) + a(1) * b(0)) / 2;
  return m;
}

}  // namespace

PrincipalStretches::PrincipalStretches(const SolidVector& green) {
  Eigen::Matrix3d strain;
  strain << green(0), green(5) / 2, green(4) / 2,  //
      green(5) / 2, green(1), green(3) / 2,        //
      green(4) / 2, green(3) / 2, green(2);
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(strain);
  strains_ = eigen.eigenvalues();
  squares_ = (1 + 2 * strains_.array()).matrix();
  logs_ = ((2 * strains_.array()).log1p() / 2).matrix();
  const Eigen::Matrix3d& n = eigen.eigenvectors();
  for (int a = 0; a < 3; ++a) {
    const auto k = static_cast<std::size_t>(a);
    along_[k] = symmetric_part(n.col(a), n.col(a));
    between_[k] = symmetric_part(n.col((a + 1) % 3), n.col((a + 2) % 3));
  }
}

// dE_a = square_a d log_a
SolidVector PrincipalStretches::stress(const Eigen::Vector3d& by_log) const {
  SolidVector result = SolidVector::Zero();
  for (int a = 0; a < 3; ++a) {
    result += by_log(a) / squares_(a) * along_[static_cast<std::size_t>(a)];
  }
  return result;
}

// (S_a - S_b) / (E_a - E_b), what a turn of the axes a and b costs. Near coincidence the difference
// quotient loses its digits; its limit dS_a / dE_a - dS_b / dE_a, in the mean over both, misses the
// square of the gap.
double PrincipalStretches::turning_stiffness(int a, int b, const Eigen::Vector3d& stress,
                                             const Eigen::Matrix3d& tangent) const {
  constexpr double kCoincident = 1e-5;
  const double gap = strains_(a) - strains_(b);
  if (std::abs(gap) > kCoincident * (squares_(a) + squares_(b))) {
    return (stress(a) - stress(b)) / gap;
  }
  return (tangent(a, a) + tangent(b, b)) / 2 - tangent(a, b);
}

SolidMatrix PrincipalStretches::tangent(const Eigen::Vector3d& by_log,
                                        const Eigen::Matrix3d& second_by_log) const {
  const Eigen::Vector3d stress = by_log.cwiseQuotient(squares_);
  Eigen::Matrix3d principal;  // dS_a / dE_b
  for (int a = 0; a < 3; ++a) {
    for (int b = 0; b < 3; ++b) {
      principal(a, b) = second_by_log(a, b) / (squares_(a) * squares_(b));
    }
    principal(a, a) -= 2 * stress(a) / squares_(a);
  }
  SolidMatrix result = SolidMatrix::Zero();
  for (int a = 0; a < 3; ++a) {
    const auto k = static_cast<std::size_t>(a);
    for (int b = 0; b < 3; ++b) {
      result += principal(a, b) * along_[k] * along_[static_cast<std::size_t>(b)].transpose();
    }
    const double turning = turning_stiffness((a + 1) % 3, (a + 2) % 3, stress, principal);
    result += 2 * turning * between_[k] * between_[k].transpose();
  }
  return result;
}

}  // namespace pliant
