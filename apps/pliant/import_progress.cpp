#include "apps/pliant/import_progress.h"

#include "pliant/base/errors.h"
#include "pliant/io/answer_file.h"

namespace pliant {

ImportedStudy remembering(ResultDirectory& results, bool resume, const CommandContext& context,
                          const std::function<ImportedStudy(const RunContext&)>& work) {
  AnswerFile answers(results.path() / kProgressFile,
                     [&](const std::string& bytes) { results.set_aside(kProgressFile, bytes); });
  if (resume) answers.resume();
  const RunContext& run = context.run;
  const auto save = [&] {
    if (answers.save()) context.say("--resume goes on from " + answers.file().string());
  };
  try {
    return work({run.progress, run.stop, run.threads, run.seed, answers});
  } catch (const Interrupted&) {
    save();
    throw;
  } catch (const InputError&) {
    if (answers.is_begun()) save();
    throw;
  }
}

}  // namespace pliant
