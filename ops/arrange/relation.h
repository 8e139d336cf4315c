// A relation between objects, of one of the kinds in relations/.
#pragma once

#include <variant>

#include "ops/arrange/relations/against.h"
#include "ops/arrange/relations/aligned.h"
#include "ops/arrange/relations/at.h"
#include "ops/arrange/relations/at_edge.h"
#include "ops/arrange/relations/beside.h"
#include "ops/arrange/relations/centred.h"
#include "ops/arrange/relations/facing.h"
#include "ops/arrange/relations/in.h"
#include "ops/arrange/relations/near.h"
#include "ops/arrange/relations/on.h"
#include "ops/arrange/relations/reach.h"
#include "ops/arrange/relations/symmetric.h"
#include "ops/arrange/relations/under.h"
#include "ops/arrange/relations/view.h"
#include "ops/arrange/relations/within.h"

namespace trivet {

namespace relations {

using Kind = std::variant<On, In, Against, Near, LeftOf, RightOf, InFrontOf, Behind, Facing, Away,
                          Aligned, Parallel, Perpendicular, Same, Centred, Within, At, Symmetric,
                          AtEdge, Under, View, Reach>;

}  // namespace relations

struct Relation : relations::Terms {
  relations::Kind kind;

  /// Null: it is of another kind.
  template <class K>
  const K* as() const {
    return std::get_if<K>(&kind);
  }
  template <class K>
  K* as() {
    return std::get_if<K>(&kind);
  }

  bool is_support() const {
    return std::visit([](const auto& k) { return k.kCarries; }, kind);
  }
  /// Decided by rays in the scene, not by outlines from above.
  bool is_of_sight() const {
    return std::visit([](const auto& k) { return k.kIsOfSight; }, kind);
  }
  /// Its tolerance is one of angles.
  bool is_in_degrees() const {
    return std::visit([](const auto& k) { return k.kIsInDegrees; }, kind);
  }
  /// a is turned to something where it stands.
  bool faces() const {
    return std::visit([](const auto& k) { return k.kFaces; }, kind);
  }
  /// Decided by turns about z alone.
  bool is_of_turn() const {
    return std::visit([](const auto& k) { return k.kTurns; }, kind);
  }
  /// An object that stands already, to whose middle plane it refers; null: none.
  const std::string* about() const {
    return std::visit([](const auto& k) { return k.about(); }, kind);
  }
  /// "cup" right_of "plate".
  Sentence text() const;
};

}  // namespace trivet
