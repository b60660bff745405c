#pragma once

namespace pliant {

/// Whether an experiment is fitted, or predicted only.
enum class ExperimentRole { fit, validate };

}  // namespace pliant
