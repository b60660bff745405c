#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "pliant/base/errors.h"
#include "pliant/base/quantity.h"
#include "pliant/capture/pattern_drawing.h"
#include "pliant/io/atomic_file.h"
#include "pliant/io/fields.h"

#include "apps/pliant/command.h"
#include "apps/pliant/file_info.h"
#include "apps/pliant/pattern_options.h"

namespace pliant {
namespace {

namespace fs = std::filesystem;

SheetFormat format_of(const fs::path& file) {
  const std::string ending = lower_case_extension(file);
  if (ending == ".pdf") return SheetFormat::pdf;
  if (ending == ".svg") return SheetFormat::svg;
  if (ending == ".png") return SheetFormat::png;
  throw InputError({file.string()}, "is no name of a drawing",
                   "a name that ends in .pdf, .svg or .png");
}

/// The document beside a drawing. An earlier one is replaced, unless somebody has worked on it.
fs::path document_beside(const fs::path& drawing) {
  fs::path document = drawing;
  document.replace_extension(".yaml");
  if (!fs::exists(document)) return document;
  const std::string expected =
      fmt::format("another name than {}, beside which it would be written", drawing.string());
  const auto type = document_type(read_yaml(document));
  if (!type || !type->starts_with("pattern/")) {
    throw InputError({document.string()}, "is there already, and no pattern", expected);
  }
  if (read_pattern(document).measured_ruler) {
    throw InputError({document.string()}, "tells of a print whose ruler was measured", expected);
  }
  return document;
}

std::string words_of(const Pattern& pattern) {
  const auto length = [](double value) { return format_quantity(value, Dimension::length); };
  const auto sheet = fmt::format("{} x {}", length(pattern.sheet.x()), length(pattern.sheet.y()));
  return fmt::format("{} on {}, ruler {}", kind_name(pattern), sheet, length(pattern.ruler));
}

void draw(const CommandContext& context, const PatternArguments& arguments,
          const CLI::App& command) {
  const fs::path file = arguments.output;
  const SheetFormat format = format_of(file);
  const fs::path document = document_beside(file);
  const Pattern pattern = pattern_of(arguments, command, context.common.seed);
  write_file_atomically(file, draw_pattern(pattern, format, arguments.dpi));
  write_file_atomically(document, pattern_text(pattern));
  context.say(fmt::format("{}: {}; print it at 100 %", file.string(), words_of(pattern)));
  context.say(fmt::format("{}: what was drawn; measure the printed ruler", document.string()));
  const nlohmann::ordered_json json{{"command", "pattern"},
                                    {"written", file.string()},
                                    {"document", document.string()},
                                    {"kind", kind_name(pattern)},
                                    {"sheet", {pattern.sheet.x(), pattern.sheet.y()}},
                                    {"ruler", pattern.ruler}};
  context.print_json(json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) +
                     "\n");
}

}  // namespace

void add_pattern(CommandRegistry& registry) {
  CLI::App& command = registry.add(
      "pattern",
      "Draw a calibration board, labels of clips or a texture of cloth in its true size");
  auto arguments = std::make_shared<PatternArguments>();
  command
      .add_option("KIND", arguments->kind,
                  "board: a grid of AprilTags; chessboard; clips: tags to cut out; cloth: noise")
      ->check(CLI::IsMember({"board", "chessboard", "clips", "cloth"}))
      ->required();
  command
      .add_option("-o,--output", arguments->output,
                  "Drawing (FILE.pdf, .svg or .png); FILE.yaml beside it says what was drawn")
      ->required();
  add_pattern_options(command, *arguments);
  command.footer(
      "Print at 100 % on matt paper, glue boards to something flat, and lay a steel ruler beside\n"
      "the printed one: what it measures goes into FILE.yaml, `ruler: {..., measured: 99.7 mm}`.\n"
      "  pliant pattern board -o board.pdf\n"
      "  pliant pattern clips -o clips.pdf --codes 1-8\n"
      "  pliant pattern cloth -o cloth.pdf --camera \"0.25 mm\" --size \"200 mm x 280 mm\" --seed "
      "1\n"
      "Exit status: 0 done, 1 the work failed, 2 bad usage or bad input.");
  registry.on(command, [arguments, app = &command](CommandContext& context) {
    draw(context, *arguments, *app);
  });
}

}  // namespace pliant
