#pragma once

#include <span>
#include <string>

#include "pliant/exchange/tester_file.h"
#include "pliant/study/imported_study.h"

namespace pliant {

/// The lines of a study that make experiments of testers' tables, each field with where it was
/// found or, where it is left blank (blank_fields.h), with what belongs there. Files that differ in
/// nothing but their number are the specimens of one experiment.
std::string experiment_lines(std::span<const TesterFile> files);

/// The study of testers' tables, with copies of them.
/// @throws InputError where two files have one name
ImportedStudy tester_study(std::span<const TesterFile> files);

}  // namespace pliant
