#include "pliant/report/html.h"
#include "pliant/report/number_format.h"
#include "pliant/report/sections.h"

namespace pliant::report {
namespace {

using Align = HtmlTable::Align;

std::string information_criterion(double value) { return format_significant(value, 5); }

}  // namespace

std::string model_section(const Results& results) {
  if (results.models.empty()) return {};
  HtmlTable table({{"Component"},
                   {"Model"},
                   {"Parameters", Align::number},
                   {"RMS error", Align::number, "of peak force"},
                   {"AIC", Align::number},
                   {"BIC", Align::number},
                   {"BIC above best", Align::number},
                   {"Told by"}});
  for (const ModelRank& model : results.models) {
    table.begin_row(model.delta_bic <= 0.0 ? "best" : "");
    table.cell(model.component);
    table.cell(model.name);
    table.cell(std::to_string(model.parameters));
    table.cell(format_percent(model.rms_percent));
    table.cell(information_criterion(model.aic));
    table.cell(information_criterion(model.bic));
    table.cell(format_significant(model.delta_bic, 3));
    table.cell(model.told_by);
  }
  return "<section id=\"models\"><h2>Comparison of models</h2>\n"
         "<p>AIC and BIC weigh how closely a model follows the data against the number of its "
         "parameters; lower is better, and the best of each component is in bold. A BIC more than "
         "10 "
         "above the best is clear evidence against a model; less than 2 is none.</p>\n" +
         table.html() + "</section>\n";
}

}  // namespace pliant::report
