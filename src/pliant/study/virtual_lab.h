#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "pliant/base/run_context.h"
#include "pliant/experiment/virtual_test.h"
#include "pliant/io/document.h"
#include "pliant/material/material.h"
#include "pliant/study/virtual_cameras.h"

namespace pliant {

/// Content of a lab/1 file (docs/formats/lab.md).
struct VirtualLab {
  std::string name;
  Material material;
  int specimens = 1;
  double specimen_variation =
      0;  ///< relative standard deviation of every parameter between specimens
  std::vector<std::shared_ptr<VirtualTest>> experiments;
  std::optional<VirtualCameras> cameras;  ///< that look at its sessions
  std::vector<std::string> validate;      ///< names or patterns that the study keeps out of the fit
};

/// Reads a lab/1 file and the material it names.
/// @throws InputError
VirtualLab read_lab(const std::filesystem::path& path);

/// The lab that a document describes.
VirtualLab lab_of(const Document& document);

/// The folders of the sessions that its measurements have.
std::vector<std::string> session_folders(const VirtualLab& lab);

/// Makes the measurements, side by side: study.yaml and the data of each experiment and specimen,
/// in the formats that `fit` reads. Warnings go to the context's progress.
/// @return names and contents; the same for the same seed
/// @throws InputError when a half cycle would have too few rows to find its reversals again;
/// SolverError when it cannot carry a load
TestFiles make_measurements(const VirtualLab& lab, const RunContext& context);

}  // namespace pliant
