#pragma once

#include <array>

#include "pliant/material/density/closed_form_density.h"

namespace pliant {

/// Coefficients of the inverse Langevin function's series in the energy of chains.
inline constexpr std::array kSeriesOfChains{1.0 / 2, 1.0 / 20, 11.0 / 1050, 19.0 / 7000,
                                            519.0 / 673750};

// Energies of one strain x in closed form, of which the standard laws of rubber are made; their
// parameters in this order.

/// c x: Neo-Hookean and Mooney-Rivlin materials on I1-bar and I2-bar.
EnergyAt linear_energy(double x, const Eigen::VectorXd& c);

/// c1 x + c2 x^2 + c3 x^3: Yeoh's material on I1-bar ([Yeoh1993]).
EnergyAt polynomial_energy(double x, const Eigen::VectorXd& c);

/// 2 mu / alpha^2 (s^alpha - 1 - alpha ln s) of the stretch s = 1 + x: a term of Ogden's material
/// ([Ogden1972]) on stretches, with shear modulus mu whatever alpha. The logarithm, which makes it
/// free of stress at rest, adds up to nothing over the stretches of a volume that stays.
EnergyAt ogden_energy(double x, const Eigen::VectorXd& mu_alpha);

/// The series of Arruda and Boyce's eight chains to its fifth term ([Arruda1993]), on I1-bar:
/// mu sum_i kSeriesOfChains[i - 1] lock^(2 - 2 i) ((x + 3)^i - 3^i), with the parameters mu and the
/// stretch at which chains lock.
EnergyAt arruda_boyce_energy(double x, const Eigen::VectorXd& mu_lock);

/// c (exp(b x) - 1) / b: tissue that stiffens exponentially, on I1-bar ([Demiray1972]).
EnergyAt exponential_energy(double x, const Eigen::VectorXd& c_b);

}  // namespace pliant
