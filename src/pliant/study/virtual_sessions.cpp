#include "pliant/study/virtual_sessions.h"

#include <cmath>
#include <mutex>
#include <optional>

#include <fmt/format.h>

#include "pliant/base/errors.h"
#include "pliant/base/parallel.h"
#include "pliant/experiment/session/virtual_session.h"

namespace pliant {
namespace {

struct SessionTask {
  std::string name;
  int specimen = 1;
  const VirtualSession* options = nullptr;
};

std::vector<SessionTask> tasks_of(const VirtualLab& lab) {
  std::vector<SessionTask> tasks;
  for (const LabExperiment& experiment : lab.experiments) {
    if (experiment.type != "session") continue;
    int specimen = 0;
    for (const std::string& name : session_names(lab, experiment)) {
      tasks.push_back({name, ++specimen, &experiment.session});
    }
  }
  return tasks;
}

/// Every parameter varies by itself, as those of the other experiments do. A sheet goes through all
/// tests: the sessions of a specimen are of one material.
Material specimen_material(Material material, double variation, RandomStream random) {
  if (variation == 0) return material;
  const auto varied = [&](double value) { return value * std::exp(variation * random.normal()); };
  const auto vary = [&](DahlParameters& dahl) {
    dahl = {varied(dahl.a), varied(dahl.b), varied(dahl.tau)};
  };
  for (auto& [name, component] : material.components) {
    if (!component.stiffness) continue;
    std::vector<double> values = component.stiffness->values();
    for (double& value : values) value = varied(value);
    component.stiffness = component.stiffness->with_values(values.data());
    if (!component.friction) continue;
    vary(component.friction->positive);
    if (component.friction->negative) vary(*component.friction->negative);
  }
  return material;
}

/// What is done by sessions side by side, told by one thread at a time.
class SharedProgress {
 public:
  SharedProgress(Progress& progress, int frames)
      : task_(progress, "virtual sessions", static_cast<double>(frames)) {}

  void add(int frames) {
    const std::lock_guard lock(mutex_);
    done_ += frames;
    task_.advance(done_);
  }

 private:
  ProgressTask task_;
  std::mutex mutex_;
  int done_ = 0;
};

Session measured(const SessionTask& task, const VirtualLab& lab, const RunContext& context,
                 SharedProgress& progress) {
  const RandomStream root(context.seed);
  const Material material = specimen_material(lab.material, lab.specimen_variation,
                                              root.split(fmt::format("sheet {}", task.specimen)));
  RandomStream random = root.split(task.name);
  return make_virtual_session(material, *task.options, random,
                              {task.name, context.stop, [&](int frames) { progress.add(frames); }});
}

}  // namespace

std::vector<std::string> session_names(const VirtualLab& lab, const LabExperiment& experiment) {
  if (lab.specimens == 1) return {experiment.name};
  std::vector<std::string> names;
  for (int specimen = 1; specimen <= lab.specimens; ++specimen) {
    names.push_back(fmt::format("{}-{:02}", experiment.name, specimen));
  }
  return names;
}

std::vector<std::pair<std::string, std::string>> make_sessions(const VirtualLab& lab,
                                                               const RunContext& context) {
  const std::vector<SessionTask> tasks = tasks_of(lab);
  if (tasks.empty()) return {};
  int frames = 0;
  for (const SessionTask& task : tasks) frames += task.options->frames;
  std::vector<Session> sessions(tasks.size());
  {
    SharedProgress progress(context.progress, frames);
    parallel_for(static_cast<int>(tasks.size()), context.threads, [&](int i) {
      const auto task = static_cast<std::size_t>(i);
      sessions[task] = measured(tasks[task], lab, context, progress);
    });
  }
  std::vector<std::pair<std::string, std::string>> files;
  for (std::size_t i = 0; i < tasks.size(); ++i) {
    for (const std::string& warning : sessions[i].warnings) {
      context.progress.message(Level::warning, tasks[i].name + ": " + warning);
    }
    for (auto& [name, content] : session_files(sessions[i])) {
      files.emplace_back(tasks[i].name + "/" + name, std::move(content));
    }
  }
  return files;
}

}  // namespace pliant
