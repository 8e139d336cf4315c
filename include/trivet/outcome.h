// Outcome of an operation: its end and its consequences, or why it was refused.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "trivet/base.h"

TRIVET_BEGIN

/// Why nothing was done. The scene is as it was, to the bit.
struct Refusal {
  std::string cause;    // "crossing", "topples", "no_free_place", ...: see docs/reference/refusals
  std::string message;  // one sentence for people
  std::vector<std::string> objects;                     // names of those involved; "floor"
  std::vector<std::pair<std::string, double>> numbers;  // by name: "friction", "missing", ...
};

/// An object that moved though it was not asked to: it gave way to a load.
struct GaveWay {
  std::string object;
  double moved = 0;  // metres, of its centre of mass
  double turned_deg = 0;
};

struct [[nodiscard]] Result {
  enum class Status { Done, Refused, Cancelled, OutOfTime };
  enum class End {
    Done,     // no motion: an edit
    AtRest,   // it settled
    Reached,  // as far as was asked for
    Blocked,  // by `blocked_by` at `blocked_at`
    Step,     // by a step that is too high
    Edge,     // before an edge that is too deep
    Limit,    // at the limit of a joint
  };

  Status status = Status::Done;
  std::optional<Refusal> refusal;  // unless it is done
  End end = End::Done;
  std::string blocked_by;  // a name, "floor", or empty
  Vec3 blocked_at;         // world
  double moved = 0;        // metres from where its position was
  double turned_deg = 0;
  int motions = 0;
  double milliseconds = 0;
  std::vector<std::string> carried;          // loads that moved along
  std::vector<std::string> unsupported;      // free objects that nothing holds any more
  std::vector<std::string> settled;          // released objects, in order
  std::vector<std::string> interpenetrates;  // after a free move
  std::vector<GaveWay> gave_way;

  [[nodiscard]] bool ok() const { return status == Status::Done; }
  /// The refusal's sentence; empty when there is none.
  [[nodiscard]] std::string reason() const { return refusal ? refusal->message : std::string(); }
};

TRIVET_END
