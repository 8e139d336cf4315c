// A scene judged from its poses alone: nothing that was computed before is trusted.
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "trivet/scene.h"

TRIVET_BEGIN

struct Check {
  struct Pair {
    std::string a, b;  // names; "floor"
    std::int64_t count = 0;
  };
  std::vector<Pair> crossings;                                    // pairs of faces, on the doubles
  std::vector<Pair> float32_crossings;                            // on the values that a file has
  std::vector<Pair> contained;                                    // components of a inside b
  std::vector<std::string> not_at_rest;                           // free objects that nothing holds
  double smallest_gap = std::numeric_limits<double>::infinity();  // metres, over all contacts
  [[nodiscard]] bool ok() const {
    return crossings.empty() && float32_crossings.empty() && contained.empty() &&
           not_at_rest.empty();
  }
};
/// Exact interpenetration, in double and in float32, and rest of each object.
[[nodiscard]] TRIVET_API Check check(const Scene& scene);

struct ContactForce {
  std::string on, from;  // names; "floor"
  Vec3 point, force;     // world; newtons
};

struct Stability {
  enum class Status {
    Stable,    // forces within the friction cones balance all weights
    Marginal,  // the same, but a little less friction or a small shift would not do
    Unstable,  // proved by a motion that nothing stops
    Unknown,   // too large a connected part; see `why_unknown`
  };
  Status status = Status::Stable;
  std::string why_unknown;
  double margin = 0;  // metres by which all weights may shift sideways; infinity: no free object
  std::vector<std::string> topples, marginal;
  std::vector<ContactForce> forces;  // complete only when it stands
  [[nodiscard]] bool stands() const {
    return status == Status::Stable || status == Status::Marginal;
  }
};
/// Judges whether the scene stands as a whole. @param friction  of all contacts; nullopt: of the
/// materials.
[[nodiscard]] TRIVET_API Stability stability(const Scene& scene,
                                             std::optional<double> friction = {});

TRIVET_END
