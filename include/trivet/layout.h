// Layout files: which objects there are, and what happens to them.
#pragma once

#include "trivet/scene.h"

TRIVET_BEGIN

struct LayoutRun {
  Scene scene;
  bool done = false;    // nothing was refused, and the check passed
  bool stands = false;  // as a whole
  std::string report;   // as JSON: poses, contacts, results of all operations, the verdict
};
/// Reads models relative to the layout, does its operations in order, and judges the scene.
/// @throws Error (BadInput) naming the file, the place, the value and what is accepted.
[[nodiscard]] TRIVET_API LayoutRun run_layout(const std::string& path, const Rules& rules = {});

/// A layout that gives the scene again: its objects, and the operations done since.
[[nodiscard]] TRIVET_API std::string layout_of(const Scene& scene);

TRIVET_END
