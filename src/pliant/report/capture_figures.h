#pragma once

#include <string>

#include "pliant/capture/dic_session.h"
#include "pliant/capture/shown_view.h"
#include "pliant/report/figure.h"

/// Pictures and figures of a capture, each as HTML; empty where there is nothing to show.
namespace pliant::report {

/// Frame by frame: what was seen, how matches held, forces and their balance, strain and slip.
std::string frame_figures(const DicSession& made, FigureSheet& figures);

/// A picture with the mesh over it, in SVG.
std::string mesh_picture(const ShownView& view, const TriangleMesh& rest);

/// By how much a camera misses what it agrees on with others, by regions of its picture, in SVG.
/// @param largest  RMS of the colour scale (pixels)
std::string region_picture(const RegionMisses& misses, double largest);

}  // namespace pliant::report
