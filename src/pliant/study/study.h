#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "pliant/estimation/fit_settings.h"
#include "pliant/estimation/judgement.h"
#include "pliant/experiment/component_experiment.h"
#include "pliant/experiment/experiment_spec.h"
#include "pliant/experiment/registry.h"
#include "pliant/io/document.h"

namespace pliant {

/// A fabric's experiments, and how they are to be fitted.
struct Study : FitSettings {
  std::map<std::string, std::string> info;
  std::map<std::string, std::string> conditions;
  std::vector<ExperimentSpec> experiments;
  std::vector<std::string> validate;
  Acceptance accept;
};

/// Reads a study/1 file.
/// @throws InputError that names file, line and field
Study read_study(const std::filesystem::path& path);

/// The study that a document describes.
Study study_of(const Document& document);

/// An experiment of a study, its data read.
/// @throws InputError for files that cannot be read and for unusable data; AssertionError for a
/// type that is not supported
std::unique_ptr<ComponentExperiment> read_experiment(const ExperimentSpec& spec,
                                                     const Study& study);

/// The study with every default filled in, as a study/1 text that `read_study` reads back.
/// @param directory  the folder that the text will be stored in; data files are named relative to
/// it
std::string resolved_study_text(const Study& study, const std::filesystem::path& directory);

}  // namespace pliant
