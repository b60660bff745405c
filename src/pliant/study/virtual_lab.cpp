#include "pliant/study/virtual_lab.h"

#include <mutex>
#include <optional>

#include <fmt/format.h>

#include "pliant/base/parallel.h"
#include "pliant/experiment/test_type.h"
#include "pliant/io/yaml_text.h"
#include "pliant/material/material.h"

namespace pliant {
namespace {

std::string specimen_name(const VirtualLab& lab, const VirtualTest& test, int number) {
  return lab.specimens == 1 ? test.name : fmt::format("{}-{:02}", test.name, number);
}

std::string study_entry(const VirtualTest& test, const std::string& name, const std::string& data) {
  std::string text = fmt::format("  - name: {}\n    type: {}\n    data: {}\n", yaml_text(name),
                                 test.type().name, yaml_text(data));
  for (const auto& [key, value] : test.study_fields()) {
    text += fmt::format("    {}: {}\n", key, value);
  }
  return text;
}

// Sheets are experiments of their own, tables specimens of one.
std::string study_entries(const VirtualLab& lab, const VirtualTest& test) {
  if (!test.type().facts.measures_sheets) {
    return study_entry(test, test.name, test.name + (lab.specimens == 1 ? ".csv" : "-*.csv"));
  }
  std::string text;
  for (int number = 1; number <= lab.specimens; ++number) {
    const std::string name = specimen_name(lab, test, number);
    text += study_entry(test, name, name);
  }
  return text;
}

std::string study_text(const VirtualLab& lab, std::uint64_t seed) {
  const std::string source =
      fmt::format("virtual measurements of the material {}, seed {}", lab.material.name, seed);
  std::string study = fmt::format("pliant: study/1\nname: {}\n", yaml_text(lab.name));
  const bool solid = lab.material.kind == MaterialKind::solid;
  if (lab.material.density > 0) {
    study += fmt::format("density: {} kg/m^{}\n", lab.material.density, solid ? 3 : 2);
  }
  study += fmt::format("info:\n  source: {}\nexperiments:\n", yaml_text(source));
  for (const auto& test : lab.experiments) study += study_entries(lab, *test);
  study += solid ? "model: {kind: solid}\n"
                 : fmt::format("model: {{membrane: {}}}\n", name_of(lab.material.membrane));
  if (!lab.validate.empty()) study += "validate:\n";
  for (const std::string& pattern : lab.validate) study += "  - " + yaml_text(pattern) + "\n";
  return study;
}

/// What is done by specimens side by side, told by one thread at a time; nothing where there is
/// little to do.
class SharedProgress {
 public:
  SharedProgress(Progress& progress, int steps) {
    if (steps > 0) task_.emplace(progress, "virtual sessions", static_cast<double>(steps));
  }

  void add(int steps) {
    const std::lock_guard lock(mutex_);
    done_ += steps;
    if (task_) task_->advance(done_);
  }

 private:
  std::optional<ProgressTask> task_;
  std::mutex mutex_;
  int done_ = 0;
};

struct Task {
  const VirtualTest& test;
  int specimen = 1;
};

std::vector<VirtualData> measured(const VirtualLab& lab, const std::vector<Task>& tasks,
                                  const RunContext& context) {
  int steps = 0;
  for (const Task& task : tasks) steps += task.test.work();
  std::vector<VirtualData> data(tasks.size());
  SharedProgress progress(context.progress, steps);
  const VirtualWork work{context.stop, [&](int done) { progress.add(done); }};
  parallel_for(static_cast<int>(tasks.size()), context.threads, [&](int i) {
    const auto& [test, specimen] = tasks[static_cast<std::size_t>(i)];
    data[static_cast<std::size_t>(i)] =
        test.measure({specimen_name(lab, test, specimen), specimen, lab.material,
                      lab.specimen_variation, RandomStream(context.seed)},
                     work);
  });
  return data;
}

}  // namespace

std::vector<std::string> session_folders(const VirtualLab& lab) {
  std::vector<std::string> folders;
  for (const auto& test : lab.experiments) {
    if (!test->type().facts.measures_sheets) continue;
    for (int specimen = 1; specimen <= lab.specimens; ++specimen) {
      folders.push_back(specimen_name(lab, *test, specimen));
    }
  }
  return folders;
}

TestFiles make_measurements(const VirtualLab& lab, const RunContext& context) {
  std::vector<Task> tasks;
  for (const auto& test : lab.experiments) {
    for (int specimen = 1; specimen <= lab.specimens; ++specimen) {
      tasks.push_back({*test, specimen});
    }
  }
  TestFiles files;
  std::vector<VirtualData> data = measured(lab, tasks, context);
  for (std::size_t i = 0; i < data.size(); ++i) {
    for (const std::string& warning : data[i].warnings) {
      context.progress.message(
          Level::warning, specimen_name(lab, tasks[i].test, tasks[i].specimen) + ": " + warning);
    }
    for (auto& file : data[i].files) files.push_back(std::move(file));
  }
  files.emplace_back("study.yaml", study_text(lab, context.seed));
  return files;
}

}  // namespace pliant
