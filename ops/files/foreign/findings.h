// Findings: what is wrong with a scene, for people and programs.
#pragma once

#include <string>
#include <vector>

#include "ops/check/pair_classes.h"
#include "ops/files/foreign/open_scene.h"
#include "ops/files/layout/run.h"

namespace trivet {

struct SceneFinding {
  enum class Kind {
    PassesThrough,  // two interpenetrate: more than contact
    Floats,         // nothing holds it from below
    NotAtRest,      // what it touches does not hold it
    Unstable,       // at rest by itself, but the scene as a whole would move it
  } kind;
  std::string object, other;  // other: what it passes through, or would fall onto; may be empty
  double metres = 0;          // depth, or height above `other`; infinity over nothing
  Vec3 point = Vec3::Zero();  // PassesThrough: where, in the file's frame
  std::string way;            // NotAtRest, Unstable: "tips towards (1.00, 0.00)"; may be empty
};
const char* to_string(SceneFinding::Kind kind);  // "passes through", "floats", ...

struct SceneVerdict {
  std::string path, format, key;
  size_t num_objects = 0, num_free = 0, num_joints = 0;
  PairClasses pairs;                   // those that only touch are no findings
  double clearance = 0;                // metres
  std::vector<SceneFinding> findings;  // the deepest first, then the others by name
  std::vector<Sentence> notes, unread;
  double milliseconds = 0;
  Sentence error;  // it could not be read; then all above is meaningless

  bool ok() const { return findings.empty() && error.empty(); }
  bool whole() const { return unread.empty() && error.empty(); }
  size_t count(SceneFinding::Kind kind) const;
  size_t num_flush() const;  // pairs that touch, and are in each other by rounding
};

/// Reads and judges a scene. Pairs of fixed objects are not judged.
/// @param run  receives the scene and its check if not null.
SceneVerdict judge(OpenedScene& opened, const RunOptions& options, LayoutRun* run = nullptr);

/// The same of a scene that was checked already. @param lift  as JudgedScene has it.
SceneVerdict verdict_of(const LayoutRun& run, double lift);

/// Adds what the joints bear as they are: notes of those that their contents would move, and pieces
/// that stand free and tip over as Unstable. @param run  a run of the opened scene, finished.
void add_what_joints_bear(const OpenedScene& opened, const std::vector<SceneJoint>& joints,
                          const RunOptions& options, const LayoutRun& run, SceneVerdict& out);

/// "pairs: 1 passes through, 8 touch or are closer than 3.8 um, 27 are apart".
std::string pairs_text(const PairClasses& pairs, double clearance);
/// "\"cup\" and \"table\", 1.9 um apart", or flush, or so deep in each other.
std::string touching_text(const TouchingPair& pair);
/// One finding: "\"cup\" and \"table\" interpenetrate, 2 mm deep at ...".
std::string finding_text(const SceneFinding& finding);
/// Some lines for one scene, the last the verdict.
std::string verdict_text(const SceneVerdict& verdict);
/// A table of many scenes and their sum.
std::string verdict_table(const std::vector<SceneVerdict>& verdicts);
/// One line of JSON.
std::string verdict_json(const SceneVerdict& verdict);

}  // namespace trivet
