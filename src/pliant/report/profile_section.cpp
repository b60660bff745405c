#include <fmt/format.h>

#include "pliant/report/html.h"
#include "pliant/report/labels.h"
#include "pliant/report/number_format.h"
#include "pliant/report/profile_figure.h"
#include "pliant/report/sections.h"

namespace pliant::report {
namespace {

constexpr PrintSize kProfileSize = {345, 240};

/// An end that the scan did not reach is named, not left out.
std::string interval(const Profile& profile) {
  const UncertainFormat format(profile.lower ? profile.lower : profile.upper, profile.std_error);
  return fmt::format("95 % interval {} to {} {}", profile.lower ? format(profile.lower) : "(open)",
                     profile.upper ? format(profile.upper) : "(open)", shown_unit(profile.unit));
}

}  // namespace

std::string profile_section(const Results& results, FigureSheet& figures) {
  if (results.profiles.empty()) return {};
  std::string html =
      "<section id=\"profiles\"><h2>Profile likelihoods</h2>\n"
      "<p>The parameter is held at each value while all others are fitted anew; the curve is how "
      "much "
      "worse the fit becomes. Values below the horizontal line (3.84) form the 95 % interval, "
      "marked "
      "by dotted lines. Where the dashed parabola of the standard error differs, trust the "
      "curve.</p>\n<div class=\"pair\">\n";
  for (const Profile& stated : results.profiles) {
    const Profile profile = in_readable_unit(stated);
    Figure figure = profile_figure(profile);
    figure.print_size = kProfileSize;
    html += fmt::format("<figure><figcaption><code>{}</code>, {}</figcaption>\n{}</figure>\n",
                        escape_html(profile.parameter), escape_html(interval(profile)),
                        figures.add(figure, "figure-medium"));
  }
  return html + "</div></section>\n";
}

}  // namespace pliant::report
