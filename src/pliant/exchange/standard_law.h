#pragma once

#include <array>
#include <string>
#include <variant>
#include <vector>

#include <Eigen/Core>

#include "pliant/material/material.h"

namespace pliant {

/// St. Venant-Kirchhoff: lambda / 2 tr(E)^2 + mu tr(E^2) ([T] Eq. 4.3); Pa.
struct StvkLaw {
  double lambda = 0, mu = 0;

  double young() const { return mu * (3 * lambda + 2 * mu) / (lambda + mu); }
  double poisson() const { return lambda / (2 * (lambda + mu)); }
};

/// Half of E . D E: nine numbers of a body whose axes are x, y and z; Pa.
struct OrthotropicStvkLaw {
  Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();  ///< D of E_xx, E_yy, E_zz
  Eigen::Vector3d shear = Eigen::Vector3d::Zero();   ///< D of 2 E_yz, 2 E_xz, 2 E_xy
};

/// Powers of the isochoric invariants: sum_i first[i - 1] (I1-bar - 3)^i + second (I2-bar - 3), in
/// Pa. Neo-Hookean, Mooney-Rivlin and Yeoh's materials are its first one, two and three terms.
struct InvariantLaw {
  std::array<double, 3> first{};
  double second = 0;
};

/// sum 2 mu / alpha^2 (s1^alpha + s2^alpha + s3^alpha - 3) over terms ([Ogden1972]), s being the
/// principal stretches over J^(1/3); or the stretches themselves, each term less 2 mu / alpha ln J,
/// so that nothing is stressed at rest.
struct OgdenLaw {
  struct Term {
    double mu = 0;     ///< shear modulus, Pa
    double alpha = 0;  ///< not 0
  };
  std::vector<Term> terms;  ///< no two of one power
  bool isochoric = true;
};

/// Five terms of the series of eight chains on I1-bar ([Arruda1993]): `arruda_boyce_energy`.
struct ArrudaBoyceLaw {
  double mu = 0, lock = 0;  ///< Pa, 1
};

/// Mooney-Rivlin of stretches, not of those over J^(1/3): first (I1 - 3) + second (I2 - 3) -
/// 2 (first + 2 second) ln J; Pa.
struct CoupledMooneyRivlinLaw {
  double first = 0, second = 0;
};

/// What resists a change of volume beside it.
struct VolumeEnergy {
  enum class Form {
    none,       ///< nothing: the volume stays
    of_ratio,   ///< bulk / 2 (J - 1)^2
    of_log,     ///< bulk / 2 (ln J)^2
    of_square,  ///< bulk / 2 ((J^2 - 1) / 2 - ln J)
    something,  ///< another energy, of which `bulk` tells the modulus at rest
  };
  Form form = Form::none;
  double bulk = 0;  ///< bulk modulus of this part (Pa), > 0 but for `none`
};

/// The law of a solid as other tools know it, too.
struct StandardLaw {
  std::variant<StvkLaw, OrthotropicStvkLaw, InvariantLaw, OgdenLaw, ArrudaBoyceLaw,
               CoupledMooneyRivlinLaw>
      shape;
  VolumeEnergy volume;
  std::vector<std::string> lost;  ///< what the material has beside it: friction, damping, errors
};

/// What a material of kind solid is, component by component: a sum of addends that has the energy
/// of a standard law is that law, whatever it is written as.
/// @param file  of the material, for errors
/// @throws InputError, with the field, for cloth and for an elastic component that no standard law
///         has: without it nothing of the law would stay true
StandardLaw standard_law(const Material& material, const std::string& file);

/// "Neo-Hookean", "Ogden of 2 terms", ...
std::string name_of(const StandardLaw& law);

/// Shear modulus at rest (Pa), the least where it differs by direction.
double shear_modulus(const StandardLaw& law);

/// Coefficients of an Arruda-Boyce law as a polynomial: its energy is sum_i c[i - 1] (I1-bar -
/// 3)^i.
std::array<double, 5> powers_of(const ArrudaBoyceLaw& law);

}  // namespace pliant
