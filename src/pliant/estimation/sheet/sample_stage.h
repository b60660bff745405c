#pragma once

#include "pliant/estimation/sheet/sheet_fitting.h"

namespace pliant {

/// Lets a fitted sheet differ from place to place ([T] 4.2.4): the components that the model asks
/// for get numbers at each sample, which begin alike and are fitted together with the other curves
/// of the stage. A warning tells where they explain no more than noise would.
void fit_samples(SheetFitting& fitting, const SheetStage& stage);

}  // namespace pliant
