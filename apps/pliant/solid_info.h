#pragma once

#include "pliant/material/material.h"
#include "pliant/study/study.h"

#include "apps/pliant/file_info.h"

namespace pliant {

/// Adds what a solid's laws are, whether each energy is convex in its metric over its range, and
/// whether the material is stable at rest.
void add_solid(const Material& material, FileInfo& info);

/// Adds what a study of a solid measured.
void add_solid_experiments(const Study& study, FileInfo& info);

}  // namespace pliant
