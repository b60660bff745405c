#include "pliant/experiment/textile_figure.h"

#include <algorithm>
#include <numbers>

#include <fmt/format.h>

#include "pliant/base/number_text.h"
#include "pliant/base/quantity.h"

namespace pliant {
namespace {

constexpr double kGramForce = 1e-3 * kStandardGravity;  // N
constexpr double kPerGramForcePerCm = 1e-2 / kGramForce;
constexpr double kDegree = std::numbers::pi / 180;

// Usual ranges are those of the charts of Kawabata (1980) and of FAST (Minazio 1995), widened to
// the fabrics of fabric_figures.h.
constexpr TextileFigure kFigures[] = {
    {"kes_EMT", "KES-FB1", "EMT", "extension at 500 gf/cm", "1", "%", 100, 1, 40},
    {"kes_LT", "KES-FB1", "LT", "work of the pull over that of a straight line", "1", "1", 1, 0.4,
     1.1},
    {"kes_WT", "KES-FB1", "WT", "work of the pull to 500 gf/cm", "N/m", "gf cm/cm^2",
     kPerGramForcePerCm, 2, 50},
    {"kes_RT", "KES-FB1", "RT", "share of the work that comes back", "1", "%", 100, 30, 85},
    {"kes_G", "KES-FB1", "G", "shear rigidity, 0.5 to 2.5 degrees", "N/m", "gf/(cm deg)",
     kPerGramForcePerCm* kDegree, 0.2, 5},
    {"kes_2HG", "KES-FB1", "2HG", "width of the shear loop at 0.5 degrees", "N/m", "gf/cm",
     kPerGramForcePerCm, 0.2, 10},
    {"kes_2HG5", "KES-FB1", "2HG5", "width of the shear loop at 5 degrees", "N/m", "gf/cm",
     kPerGramForcePerCm, 0.4, 15},
    {"kes_B", "KES-FB2", "B", "bending rigidity, 0.5 to 1.5 1/cm", "N m", "gf cm^2/cm",
     1e2 / kGramForce, 0.01, 1},
    {"kes_2HB", "KES-FB2", "2HB", "width of the bending loop at 1 1/cm", "N", "gf cm/cm",
     1 / kGramForce, 0.003, 0.8},
    {"fast_E5", "FAST-3", "E5", "extension at 5 gf/cm", "1", "%", 100, 0.1, 15},
    {"fast_E20", "FAST-3", "E20", "extension at 20 gf/cm", "1", "%", 100, 0.3, 25},
    {"fast_E100", "FAST-3", "E100", "extension at 100 gf/cm", "1", "%", 100, 1, 40},
    {"fast_G", "FAST-3", "G", "shear rigidity by the bias extension EB5", "N/m", "N/m", 1, 10, 200},
    {"fast_formability", "FAST", "F", "(E20 - E5) B / 14.7", "m^2", "mm^2", 1e6, 0.1, 5},
    {"flexural_rigidity", "ASTM D1388, ISO 9073-7", "G",
     "weight per area times the cube of the "
     "bending length",
     "N m", "uN m", 1e6, 1, 100},
    {"overall_flexural_rigidity", "ASTM D1388, ISO 9073-7", "G overall",
     "root of the product of weft's and warp's", "N m", "uN m", 1e6, 1, 100},
    {"bending_length", "ASTM D1388, ISO 9073-7", "c", "half of the overhang at 41.5 degrees", "m",
     "mm", 1e3, 7, 55},
    {"iso_elongation", "ISO 20932-1", "S", "elongation at the largest force of the last cycle", "1",
     "%", 100},
    {"iso_permanent", "ISO 20932-1", "C", "elongation that is left at 1 cN/cm after it", "1", "%",
     100},
    {"iso_recovery", "ISO 20932-1", "D", "share of the elongation that has come back", "1", "%",
     100},
};

}  // namespace

std::string in_lab_unit(const TextileFigure& figure, double si) {
  constexpr int kDigits = 4;
  std::string text = format_number(figure.per_si * si, kDigits);
  if (figure.lab_unit != "1") text += fmt::format(" {}", figure.lab_unit);
  return text;
}

const TextileFigure* find_textile_figure(std::string_view name) {
  const auto found = std::ranges::find(kFigures, name, &TextileFigure::name);
  return found == std::end(kFigures) ? nullptr : found;
}

}  // namespace pliant
