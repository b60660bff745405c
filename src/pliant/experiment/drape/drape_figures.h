#pragma once

#include <vector>

namespace pliant {

/// What the drape test (Cusick 1965, ISO 9073-9) and its users read off a silhouette.
struct DrapeFigures {
  double coefficient = 0;  ///< (silhouette - disc) / (flat specimen - disc), areas
  int nodes = 0;           ///< folds: maxima of the radius of the outline
  double amplitude = 0;    ///< half of the mean height of the maxima over the minima (m)
  /// Standard deviation of the angles between neighbouring nodes over their mean: 0 where the folds
  /// are evenly spread; 0 for fewer than two.
  double irregularity = 0;
};

/// @param area      of the silhouette (m^2)
/// @param disc      area of the disc that carries the specimen (m^2)
/// @param specimen  area of the flat specimen (m^2), more than the disc's
double drape_coefficient(double area, double disc, double specimen);

/// Angles of the nodes (turns, [0, 1)): maxima of a radius over the whole turn that rise above the
/// minima beside them.
/// @param radii   at equal angles (m)
/// @param height  of the smallest rise that counts (m)
std::vector<double> nodes_of(const std::vector<double>& radii, double height);

/// Counts and measures the folds of an outline; the coefficient stays 0.
/// @param overhang  of the flat specimen beyond the disc (m): rises below a thirtieth of it are no
///                  folds
DrapeFigures fold_figures(const std::vector<double>& radii, double overhang);

}  // namespace pliant
