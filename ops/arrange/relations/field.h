// Keys of relations in problems, by which they are read; their schema is made of them, too.
#pragma once

#include <variant>
#include <vector>

#include "core/base/limits.h"
#include "ops/arrange/relations/kind.h"

namespace trivet::relations {

/// Axes of b: its right, its back.
struct Axes {
  bool x = true, y = true;
};

/// Forms in which a key gives the gap of its kind.
enum class GapForm {
  Both,    // [least, most]
  Most,    // a number
  Either,  // one or the other
};

/// A member that is made a unit vector.
template <class K>
struct Direction {
  Vec2 K::*member;
};

template <class K>
struct Field {
  const char* key;
  std::variant<double K::*, std::optional<int> K::*, std::optional<Side> K::*, Vec2 K::*,
               std::optional<Vec2> K::*, std::optional<Vec3> K::*, std::vector<Vec2> K::*,
               std::string K::*, Axes K::*, Direction<K>, GapForm>
      member;
  const char* help = "";  // a sentence
  bool is_required = false;
  double least = 0, most = 1;  // of a number
};

/// Fields of a kind, in their order.
template <class K>
const std::vector<Field<K>>& fields_of() {
  static const std::vector<Field<K>> all = [] {
    if constexpr (requires { K::fields(); }) return K::fields();
    return std::vector<Field<K>>();
  }();
  return all;
}

}  // namespace trivet::relations
