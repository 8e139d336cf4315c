// Private. One entry of "relations": a relation, a pattern or a distance to keep.
#pragma once

#include "ops/arrange/arrangement.h"
#include "ops/files/arrange/problem_names.h"

namespace trivet {

/// Appends it to what it is of.
/// @throws Error (BadInput) with the place, the value and what is accepted.
void read_relation(const JsonPlace& place, const ProblemNames& names, Arrangement& out);

/// An entry of patterns; false: it is none.
bool read_pattern(const JsonPlace& place, const std::string& is, const ProblemNames& names,
                  Arrangement& out);

/// [x, y] in metres.
Vec2 read_point(const JsonPlace& place);
/// "top", "bottom", a number, or a name.
/// @param support  whose surfaces may have names.
int read_level(const JsonPlace& place, const ProblemNames& names, const std::string& support);
/// "top", "bottom" or a number.
int read_level_number(const JsonPlace& place);
/// As a problem has it that gives nothing but its objects.
template <class K>
Relation usual() {
  K kind;
  if constexpr (requires { kind.upper; }) kind.upper = K::kUsualUpper;
  Relation out;
  out.tolerance = K::kUsualTolerance;
  out.kind = std::move(kind);
  return out;
}

inline constexpr double kMinTolerance = 1e-5;

/// A whole number at a key that may be missing.
void read_count(const JsonPlace& place, const char* key, int lower, int upper, int& out);

}  // namespace trivet
