#pragma once

#include <string>

#include "pliant/report/figure.h"

namespace pliant::report {

/// The sheet for the figures of a page, which knows whether this build can draw them.
FigureSheet page_figures();

/// A whole HTML page with its style, its figures and the script that draws them: one file that
/// loads nothing, from the network or from beside it.
/// @param title    text, not HTML
/// @param body     HTML, with the places of the figures
/// @param figures  of `page_figures`
std::string page(const std::string& title, const std::string& body, const FigureSheet& figures);

}  // namespace pliant::report
