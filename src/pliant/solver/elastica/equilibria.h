#pragma once

#include <vector>

#include "pliant/solver/elastica/elastica.h"

namespace pliant {

/// The stable equilibria that a strip with a free end falls into when it is let go from shapes near
/// one: the same, bent further all along by angles up to `reach`, both ways. A strip under its
/// weight often has two or three.
///
/// The friction of each is that of one monotone stretch from the history.
/// @param reach  rad
/// @return in the order of the direction of their tips
std::vector<StripShape> equilibria_near(const Elastica& strip, const ComponentLaw& law,
                                        double weight, const StripEnds& ends,
                                        const StripHistory& history, const StripShape& near,
                                        double reach);

}  // namespace pliant
