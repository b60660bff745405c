#pragma once

#include <vector>

#include "pliant/capture/bundle_adjustment.h"
#include "pliant/capture/rig_file.h"
#include "pliant/capture/rig_pictures.h"

namespace pliant {

/// A first estimate of a rig: each camera by its own pictures, then where the cameras are to each
/// other by boards that two of them saw at once. What a pair's pictures say of that is compared:
/// those that contradict most others were not taken at the same time, and are left out.
/// @param pictures  those that are left out get their reason
/// @throws InputError where cameras share no boards, or their pictures contradict each other
/// @throws SolverError, Interrupted
Bundle start_of_rig(const RigFile& rig, std::vector<RigPicture>& pictures,
                    const BundleOptions& options);

}  // namespace pliant
