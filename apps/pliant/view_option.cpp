#include "apps/pliant/view_option.h"

#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "pliant/base/errors.h"
#include "pliant/base/nearest_name.h"

namespace pliant {
namespace {

struct NamedView {
  const char* name;
  ViewDirection direction;
};

constexpr NamedView kViews[] = {{"front", ViewDirection::front},
                                {"back", ViewDirection::back},
                                {"left", ViewDirection::left},
                                {"right", ViewDirection::right},
                                {"top", ViewDirection::top},
                                {"bottom", ViewDirection::bottom},
                                {kDefaultView, ViewDirection::three_quarter},
                                {"three-quarter-back", ViewDirection::three_quarter_back}};

std::vector<std::string> view_names() {
  std::vector<std::string> names;
  for (const NamedView& view : kViews) names.emplace_back(view.name);
  return names;
}

}  // namespace

void add_view_option(CLI::App& command, std::string& view, const std::string& description) {
  command.add_option("--view", view, description)
      ->type_name(fmt::format("{{{}}}", fmt::join(view_names(), ",")))
      ->capture_default_str();
}

ViewDirection parse_view(const std::string& text) {
  if (text == "side") return ViewDirection::right;  // as it was called
  for (const NamedView& view : kViews) {
    if (text == view.name) return view.direction;
  }
  throw InputError({"--view"}, quoted_value(text) + did_you_mean(text, view_names()),
                   list_of_names(view_names()));
}

}  // namespace pliant
