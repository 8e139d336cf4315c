// Margins that are worth a warning.
#pragma once

#include "apps/edit/document/scene_verdict.h"
#include "apps/edit/document/snapshot.h"

namespace trivet::edit {

/// True if an object stands by less than a five-thousandth of its size. Round things that rest do
/// not: they roll a little before they fall.
bool is_barely(const Object& object, const ObjectStability& verdict);
/// The same of any object of the scene.
bool is_barely(const SceneSnapshot& scene, const SceneVerdict& verdict);

}  // namespace trivet::edit
