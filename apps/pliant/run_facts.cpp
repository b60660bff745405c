#include "apps/pliant/run_facts.h"

#include <ctime>

#include <fmt/chrono.h>

#include "pliant/io/digest.h"

namespace pliant {

RunFacts run_facts(const CommandContext& context, const std::filesystem::path& study) {
  RunFacts facts;
  facts.command = context.command_line();
  facts.created = fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::time(nullptr)));
  facts.version = PLIANT_VERSION;
  facts.study = study.string();
  facts.study_sha256 = sha256_of_file(study);
  return facts;
}

}  // namespace pliant
