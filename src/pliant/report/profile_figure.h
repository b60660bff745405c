#pragma once

#include "pliant/report/figure.h"
#include "pliant/study/results.h"

namespace pliant::report {

/// The same with numbers of a readable size.
Profile in_readable_unit(Profile profile);

/// Profile likelihood of one parameter: how much worse the fit becomes when it is held at another
/// value and all others follow; beside it the parabola that its standard error stands for.
Figure profile_figure(const Profile& profile);

}  // namespace pliant::report
