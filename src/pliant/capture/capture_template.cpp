#include "pliant/capture/capture_template.h"

#include <string>

#include "pliant/capture/pattern_drawing.h"

namespace pliant {
namespace {

constexpr double kDpi = 600;

void add_print(const std::string& name, const Pattern& pattern, TestFiles& files) {
  files.emplace_back(name + ".pdf", draw_pattern(pattern, SheetFormat::pdf, kDpi));
  files.emplace_back(name + ".yaml", pattern_text(pattern));
}

}  // namespace

TestFiles capture_template() {
  TestFiles files = template_files("capture");
  Pattern labels, board;
  labels.kind = ClipCodes{.codes = {0, 1, 2, 3}};
  // Codes of labels are none of the board's.
  board.kind = TagBoard{.first_code = 10};
  add_print("labels", labels, files);
  add_print("board", board, files);
  return files;
}

}  // namespace pliant
