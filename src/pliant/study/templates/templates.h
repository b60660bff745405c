#pragma once

#include "pliant/study/test_template.h"

namespace pliant {

TestTemplate hanging_weights_template();
TestTemplate tensile_cycles_template();
TestTemplate shear_cycles_template();
TestTemplate pure_bending_template();
TestTemplate cantilever_template();
TestTemplate rolled_strip_template();
TestTemplate bending_length_template();
TestTemplate buckling_bend_template();

}  // namespace pliant
