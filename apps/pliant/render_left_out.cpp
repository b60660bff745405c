// `render` of a program that was built without Embree or libpng; CMake takes this file in place of
// render_command.cpp then.

#include "pliant/base/errors.h"

#include "apps/pliant/command.h"

namespace pliant {

void add_render(CommandRegistry& registry) {
  CLI::App& command = registry.add("render", "");
  command.group("");  // not listed in --help
  command.allow_extras();
  registry.on(command, [](CommandContext&) {
    throw InputError({"render"}, "this program was built without Embree 3 or libpng",
                     "a build where both are installed (libembree-dev, libpng-dev)");
  });
}

}  // namespace pliant
