// Real models of the shared data that tests lay out; see TRIVET_NEEDS_DATA.
#pragma once

#include "core/motion/pose.h"
#include "core/scene/scene.h"

namespace trivet::test {

struct RealModel {
  const char* file;
  double scale;  // to metres
  UpAxis up;
};
inline constexpr RealModel kRealModels[] = {{"sh3d_by_choppingBoard.obj", 0.00998942, UpAxis::Y},
                                            {"contactdb_bowl.stl", 1, UpAxis::Z},
                                            {"gazebo_plastic_cup.obj", 1, UpAxis::Z},
                                            {"sh3d_by_spoon.obj", 0.00998615, UpAxis::Y},
                                            {"sh3d_s_toaster.obj", 0.00999713, UpAxis::Y},
                                            {"gso_silver_tape.obj", 1, UpAxis::Z},
                                            {"sh3d_s_bandeja.obj", 0.00998825, UpAxis::Y},
                                            {"ripc_nut-big.obj", 0.004, UpAxis::Y},
                                            {"sh3d_c0_bread.obj", 0.00999396, UpAxis::Y},
                                            {"sh3d_s_marteau.obj", 0.0100125, UpAxis::Y}};

}  // namespace trivet::test
