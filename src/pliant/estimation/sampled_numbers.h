#pragma once

#include <vector>

#include <Eigen/Core>

#include "pliant/estimation/unknown.h"
#include "pliant/material/material.h"

namespace pliant {

/// What to tell where samples are fitted to a material that needs none.
inline constexpr const char* kNoSamples =
    "the samples explain no more than one material everywhere: the data do not show that the body "
    "is heterogeneous";

/// How often a fit looks for the numbers of a component: once for each sample, where these differ
/// in it.
int copies_of(const Material& material, const std::string& component);

/// Appends the unknowns of components that share a law: those of each sample, where they differ in
/// it, one sample after the other.
/// @param own  of the components where the material is the same everywhere
void append_unknowns(const Material& material, const ComponentGroup& group,
                     const std::vector<Unknown>& own, std::vector<Unknown>& unknowns);

/// Gives components that share a law other numbers, from `first` on, in the order of their
/// unknowns; what differs from place to place gets the means of its samples, too.
/// @return the place of the next number
Eigen::Index set_numbers(const Eigen::VectorXd& numbers, Eigen::Index first,
                         const ComponentGroup& group, Material& material);

}  // namespace pliant
