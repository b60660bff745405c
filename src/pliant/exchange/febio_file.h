#pragma once

#include "pliant/exchange/converted_solid.h"

namespace pliant {

/// A file of FEBio 4 (.feb) in SI units: the material; or, with a mesh, a model to which supports,
/// loads and steps are added: nodes and elements in the order of the mesh from 1 on, sets of its
/// groups and of its regions.
///
/// The energies are those of FEBio's theory manual. Uncoupled laws have a bulk modulus k and one of
/// its pressure models: k / 2 (J - 1)^2 ("Abaqus"), k / 2 (ln J)^2 ("default"), k / 2 ((J^2 - 1) /
/// 2
/// - ln J) ("NIKE3D"). Ogden's c is twice mu; the chains of Arruda and Boyce are written as powers
/// of I1-bar ("Yeoh"), which hold their five terms exactly, while FEBio's own "Arruda-Boyce"
/// multiplies the terms of its series by 1 to 5.
/// @throws InputError, with the field, for a law that FEBio does not have
ConvertedSolid febio_file(const SolidToConvert& solid);

}  // namespace pliant
