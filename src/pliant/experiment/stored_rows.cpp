#include "pliant/experiment/stored_rows.h"

namespace pliant {

StoredRows::StoredRows(const Experiment& experiment, Eigen::Index derivatives)
    : frames_(experiment.frames()) {
  rows_.value.resize(experiment.rows());
  if (derivatives > 0) rows_.by.resize(experiment.rows(), derivatives);
}

void StoredRows::take(int frame, const PredictedFrame& rows) {
  const Frame& at = frames_[static_cast<std::size_t>(frame)];
  rows_.value.segment(at.first, at.count) = rows.value;
  if (rows_.by.size() > 0) rows_.by.middleRows(at.first, at.count) = rows.by;
  if (rows.length_gain.size() == 0) return;
  rows_.length_gain.conservativeResize(rows_.value.size());
  rows_.length_gain.segment(at.first, at.count) = rows.length_gain;
}

}  // namespace pliant
