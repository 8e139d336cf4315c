// Runs a layout: loads its models, stands objects where it says, then does its operations.
#pragma once

#include <string>
#include <vector>

#include "ops/base/context.h"
#include "ops/base/options.h"
#include "ops/base/outcome.h"
#include "ops/check/check.h"
#include "ops/files/layout/layout.h"
#include "ops/files/layout/load.h"
#include "ops/stability/stability.h"

namespace trivet {

struct RunOptions {
  SettleOptions settle;    // where neither `rules` nor the file state a rule
  SettleRules rules = {};  // before those that a layout or scene file states
  RunContext context;
  StabilityOptions stability;    // of the scene as a whole, at the end
  bool topples_alone = false;    // of that: who topples, without margins and forces
  double verdict_seconds = 0;    // for the check and the stability at the end; 0: unlimited
  int num_threads = 0;           // 0: all cores; results do not depend on it
  bool stop_at_refusal = false;  // else a refusal is recorded, and the next operation done
  ProgressCallback progress;     // may be empty
  std::string layout_file;       // for messages
};

/// Result of one operation. An object that cannot stand where the layout says is recorded as a
/// refused operation "stand", ahead of the others.
struct OperationRecord {
  std::string op, object;
  OperationResult result;
};

struct LayoutRun {
  Scene scene;
  SettleOptions settle;          // of the operations; its clearance: of the judgement, too
  double largest_clearance = 0;  // metres, that operations may have used; 0: not known
  std::vector<OperationRecord> operations;
  SceneCheck check;
  Stability stability;

  bool ok() const;  // no refusal, and the check passed; it says nothing of the stability
};

/// Objects of the layout, all of them out of the scene yet; one Model and one Shape per model.
/// @throws Error (BadInput) for a model that cannot be read and for an object that reaches beyond
///   kMaxLength, with its place in the layout; what `models` throws.
Scene make_scene(const Layout& layout, const ModelSource& models, const RunOptions& options);

/// Options with the rules that hold: `options.rules`, else the file's, else `options.settle`.
SettleOptions settle_options(const RunOptions& options, const SettleRules& of_file);

/// True if its objects start as it has them, whether they may or not: it begins with MEND or
/// SETTLE.
bool stands_as_given(const Layout& layout);

/// Does the operations of the layout on a scene that has its objects; by `options.settle`.
void run_operations(const Layout& layout, const RunOptions& options, LayoutRun& run);

/// Brings contacts and states up to date with the poses, checks the scene and judges its stability.
/// An operation counts the box of what it moves, so that its clearance may have been larger than
/// the scene's at the end: where that leaves something without its rest, the largest is tried, and
/// kept as the settling's if all rests with it. What is not judged within options.verdict_seconds
/// is named in the check, or makes the stability Unknown.
void finish_run(const RunOptions& options, LayoutRun& run);

/// Stands objects in the order of the layout, or as they are given, then does the operations, by
/// the rules that hold, then checks the scene.
LayoutRun run_layout(const Layout& layout, const ModelSource& models, const RunOptions& options);

/// The objects that stand from the start, exactly as the layout has them, whether they may or not:
/// for a check that names all pairs that interpenetrate. No operation is done.
LayoutRun run_start_only(const Layout& layout, const ModelSource& models,
                         const RunOptions& options);

}  // namespace trivet
