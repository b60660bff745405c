#pragma once

#include <filesystem>
#include <optional>

#include "pliant/exchange/u3m_file.h"
#include "pliant/study/imported_study.h"

namespace pliant {

struct ImportOptions {
  std::optional<double> width_m = {};  ///< of every strip, in place of the file's
  bool without_pauses = false;  ///< half cycles follow each other at once: stretch rows get times,
                                ///< by the file's sampling rate
};

/// The study in a U3M file (see `read_u3m_file` for what is accepted): stretch tests along warp,
/// weft and bias as tensile-cycles, bends as buckling-bend, one CSV file each. The stretch at 2 cm
/// is for validation where there is one at 8 cm: it may be the same strip, stretched before; the
/// bend at 8 cm where there is one at 2 cm: its weight hides its stiffness. Without mass per area
/// bends are left out.
/// @throws InputError when the file cannot be read, holds no measurements or tells no strip width
///         and none is given
ImportedStudy import_u3m(const std::filesystem::path& file, const ImportOptions& options = {});

/// The same for documents that were read.
ImportedStudy import_u3m(const U3mFile& file, const ImportOptions& options = {});

}  // namespace pliant
