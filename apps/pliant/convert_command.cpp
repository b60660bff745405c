#include <optional>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "pliant/base/errors.h"
#include "pliant/base/quantity.h"
#include "pliant/exchange/solid_conversion.h"
#include "pliant/geometry/volume_file.h"
#include "pliant/io/atomic_file.h"
#include "pliant/material/material_file.h"

#include "apps/pliant/command.h"
#include "apps/pliant/file_info.h"
#include "apps/pliant/given_document.h"

namespace pliant {
namespace {

struct ConvertArguments {
  std::string material;
  std::string output;
  std::string to;
  std::string mesh;
  std::string unit;
  std::string up = "z";
};

/// Whoever completes the file of a tool has work in it: it is never replaced.
void require_new_file(const std::string& output, const ConversionFormat& format) {
  if (lower_case_extension(output) != format.ending) {
    throw InputError({output}, fmt::format("is no name of a file of {}", format.tool),
                     fmt::format("a name that ends in {}", format.ending));
  }
  if (std::filesystem::exists(output)) throw InputError({output}, "is there already", "a new file");
}

std::optional<VolumeMesh> mesh_of(const ConvertArguments& arguments) {
  if (arguments.mesh.empty()) return std::nullopt;
  const std::optional<double> unit = unit_scale(arguments.unit, Dimension::length);
  if (!unit) {
    throw InputError({"--unit"},
                     arguments.unit.empty() ? "is missing" : quoted_value(arguments.unit),
                     fmt::format("the length unit of {}: {}", arguments.mesh,
                                 fmt::join(units_of(Dimension::length), ", ")));
  }
  return read_volume_mesh(arguments.mesh, {*unit, arguments.up});
}

void convert(const CommandContext& context, const ConvertArguments& arguments) {
  const ConversionFormat& format = conversion_format(arguments.to);
  require_new_file(arguments.output, format);
  const std::string file = given_document(arguments.material, "material").string();
  const Material material = read_material(file);
  const StandardLaw law = standard_law(material, file);
  const std::optional<VolumeMesh> mesh = mesh_of(arguments);
  const ConvertedSolid converted = format.convert({material, file, law, mesh ? &*mesh : nullptr});
  write_file_atomically(arguments.output, converted.text);
  for (const std::string& lost : converted.lost) {
    context.run.progress.message(Level::warning, "lost: " + lost);
  }
  context.say(fmt::format("{}: {} for {}", arguments.output, name_of(law), format.tool));
  const nlohmann::ordered_json json{{"command", "convert"},
                                    {"written", arguments.output},
                                    {"law", name_of(law)},
                                    {"lost", converted.lost}};
  context.print_json(json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) +
                     "\n");
}

}  // namespace

void add_convert(CommandRegistry& registry) {
  CLI::App& command = registry.add(
      "convert", "Write a solid's material, and a mesh, for another finite element program");
  auto arguments = std::make_shared<ConvertArguments>();
  command
      .add_option("IN", arguments->material,
                  "Material file (material/1, kind solid), or results of a fit")
      ->required();
  command.add_option("OUT", arguments->output, "New file: .feb of FEBio, .inp of the others")
      ->required();
  command.add_option("--to", arguments->to, "febio, abaqus or calculix")
      ->type_name("FORMAT")
      ->required();
  command
      .add_option(
          "--mesh", arguments->mesh,
          "Volume mesh (.msh, .mesh, .vtu): nodes, elements and their section are written, too")
      ->type_name("FILE");
  command
      .add_option("--unit", arguments->unit, "Length unit of the mesh's coordinates: mm, m, ...")
      ->type_name("UNIT");
  command.add_option("--up", arguments->up, "Axis of the mesh's file that becomes z")
      ->check(CLI::IsMember({"x", "y", "z", "-x", "-y", "-z"}))
      ->type_name("AXIS");
  command.footer(
      "St. Venant-Kirchhoff, Neo-Hookean, Mooney-Rivlin, Yeoh, Ogden and Arruda-Boyce are written\n"
      "with equal energy, in SI units. What the tool does not have is said, a line each, and "
      "stands\n"
      "in the file: internal friction, limits, damping, the form of the volume's energy. A law of\n"
      "which nothing would stay true is refused.\n"
      "Exit status: 0 done, 1 stopped, 2 bad usage or bad input.");
  registry.on(command, [arguments](CommandContext& context) { convert(context, *arguments); });
}

}  // namespace pliant
