#pragma once

#include "pliant/experiment/template_files.h"

namespace pliant {

/// What a test before one camera begins with: its protocol, a dic/1 file, a rig/1 file to calibrate
/// the lens, the head of a log, and prints of labels and of a board with their documents.
TestFiles capture_template();

}  // namespace pliant
