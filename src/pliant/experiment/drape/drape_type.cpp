#include "pliant/experiment/drape/drape_type.h"

#include <algorithm>

#include <fmt/format.h>

#include "pliant/experiment/drape/drape_test.h"
#include "pliant/experiment/drape/virtual_drape.h"

namespace pliant {
namespace {

// A fold has some edges, and a mesh some ten thousand vertices at most.
constexpr double kCoarsest = 0.25, kFinest = 1.0 / 40;  // of the overhang
constexpr double kUsualEdge = 2.0 / 15;                 // of the overhang: 8 mm at 6 cm
constexpr int kMostRepeats = 100;

void read_edge(Fields& fields, DrapeSetup& setup) {
  setup.edge = kUsualEdge * setup.overhang();
  const auto edge = fields.optional("edge");
  if (!edge) return;
  setup.edge = edge->positive_quantity(Dimension::length);
  const double coarsest = kCoarsest * setup.overhang(), finest = kFinest * setup.overhang();
  // Rounding of what the message says.
  if (setup.edge > coarsest * (1 + 1e-9) || setup.edge < finest * (1 - 1e-9)) {
    edge->fail("makes a mesh that is too coarse or too fine",
               fmt::format("{} to {}", format_quantity(finest, Dimension::length),
                           format_quantity(coarsest, Dimension::length)));
  }
}

std::shared_ptr<VirtualTest> read_virtual(Fields& fields) {
  auto test = std::make_shared<VirtualDrape>();
  test->setup = read_drape_setup(fields);
  if (auto v = fields.optional("repeats")) test->repeats = v->integer(1, kMostRepeats);
  return test;
}

std::shared_ptr<const TestSpec> read(Fields& fields, const SpecimenDefaults&, ExperimentSpec&) {
  auto spec = std::make_shared<DrapeSpec>();
  spec->setup = read_drape_setup(fields);
  return spec;
}

}  // namespace

DrapeSetup read_drape_setup(Fields& fields) {
  DrapeSetup setup;
  if (auto v = fields.optional("disc")) setup.disc = v->positive_quantity(Dimension::length);
  const auto specimen = fields.optional("specimen");
  if (specimen) setup.specimen = specimen->positive_quantity(Dimension::length);
  const double least = least_specimen(setup.disc);
  if (setup.specimen < least) {
    const std::string expected =
        "a diameter of at least " + format_quantity(least, Dimension::length);
    const std::string problem = "hardly hangs over the disc";
    if (specimen) specimen->fail(problem, expected);
    const Location where = fields.location();
    throw InputError({where.file, where.line, where.field + ".specimen"},
                     fmt::format("of {} by default {}",
                                 format_quantity(setup.specimen, Dimension::length), problem),
                     expected);
  }
  if (auto v = fields.optional("history")) {
    const std::string name = v->choice({"lowered", "shaken", "pulled"});
    setup.history = *std::ranges::find(drape_histories(), name,
                                       [](DrapeHistory history) { return name_of(history); });
  }
  read_edge(fields, setup);
  return setup;
}

WrittenFields written(const DrapeSetup& setup) {
  return {{"specimen", exact_quantity(setup.specimen, Dimension::length)},
          {"disc", exact_quantity(setup.disc, Dimension::length)},
          {"history", std::string(name_of(setup.history))},
          {"edge", exact_quantity(setup.edge, Dimension::length)}};
}

const TestType& drape_type() {
  static const TestType type{
      .name = "drape",
      .facts = {.only_predicted = true, .needs_density = true},
      .template_files = template_files("drape"),
      .read = read,
      .make_whole = [](const ExperimentSpec& spec, const DataRows& data)
          -> std::unique_ptr<WholeSheetTest> { return std::make_unique<DrapeTest>(spec, data); },
      .read_virtual = read_virtual,
      .own_quantities = {{"drape", Dimension::fraction}},
      .is_table =
          [](const TableColumns& columns) { return columns.has("drape", Dimension::fraction); }};
  return type;
}

WrittenFields DrapeSpec::fields() const { return written(setup); }

}  // namespace pliant
