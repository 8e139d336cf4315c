// A run of a layout that tells of each operation.
#pragma once

#include <functional>

#include "ops/files/layout/run.h"

namespace trivet {

struct RunWatch {
  std::function<void(const Scene&)> standing;  // before the first operation
  std::function<void(const Scene& after, const Operation&, const OperationResult&)> done;
};

/// run_layout(), with the same result.
LayoutRun run_layout(const Layout& layout, const ModelSource& models, const RunOptions& options,
                     const RunWatch& watch);

/// The layout without the operations that were refused: it makes the same scene.
/// @param run  of this layout.
Layout without_refused(Layout layout, const LayoutRun& run);

}  // namespace trivet
