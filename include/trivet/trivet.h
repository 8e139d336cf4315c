// Trivet lays out 3D objects so that they never pass through each other and always lie at rest.
//
//   trivet::Scene scene;
//   const auto cup = scene.add("cup", trivet::load_model("cup.obj"));
//   const auto result = trivet::put(scene, cup, {.position = {0, 0, 1}});
//   if (!result.ok()) std::cerr << result.reason() << "\n";
//   trivet::save_scene(scene, "scene.glb");
#pragma once

#include "trivet/arrange.h"
#include "trivet/check.h"
#include "trivet/export.h"
#include "trivet/geometry.h"
#include "trivet/layout.h"
#include "trivet/model.h"
#include "trivet/operations.h"
#include "trivet/outcome.h"
#include "trivet/render.h"
#include "trivet/scene.h"
#include "trivet/session.h"
#include "trivet/zlist.h"
