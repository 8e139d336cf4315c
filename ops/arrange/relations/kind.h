// Answers of a kind of relation. Each is a struct of its own file and hides here what it knows
// better; the variant in relation.h names them all.
//
// Terms: `a` and `b` are objects; seen from above, from in front of b, as one who faces b's front
// sees it; a gap is between outlines.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/base/sentence.h"
#include "ops/arrange/convex_region.h"
#include "ops/arrange/outline.h"

namespace trivet {

enum class Side { Front, Back, Left, Right };
const char* to_string(Side side);

namespace relations {

/// Data that relations of all kinds have.
struct Terms {
  std::string a, b;         // b: may be "floor" of On; empty where there is a point or a region
  double tolerance = 1e-3;  // metres or degrees: a cost of 1
  std::optional<double> weight;  // soft; nullopt: the cost may not be more than 1
  size_t entry = 0;              // of the list that it is from

  bool is_hard() const { return !weight; }
};

struct Gap {
  double lower = 0, upper = kInfinity;  // metres
};

/// The outlines of both objects, of which one is being placed.
struct Placed {
  const Outline& moving;  // at position zero
  const Outline* other;   // where it stands; null where there is none
  bool moves_a;           // `moving` is the relation's a, else its b

  const Outline& a() const { return moves_a ? moving : *other; }
  const Outline& b() const { return moves_a ? *other : moving; }
  double sign() const { return moves_a ? 1 : -1; }  // of its position in a - b
};

/// Sizes of both objects, by which distances of outlines are bounded.
struct Sizes {
  double a = 0, b = 0;
  double touching = 0;  // of outlines, one of which carries the other
};

/// True if a key was given.
using IsGiven = std::function<bool(const char* key)>;

/// Keys that an entry has together, and those that it has not then.
struct Way {
  std::vector<const char*> needed, never;
};

/// Need of a relation for another object.
enum class Other { Needed, Optional, None };

/// Answers of a kind that has none of its own.
struct AnyKind {
  static constexpr double kUsualTolerance = 1e-3;   // in problems
  static constexpr double kUsualUpper = kInfinity;  // of a gap in problems
  static constexpr const char* kAlias = nullptr;    // another name, whose keys are all optional
  static constexpr const char* kAliasHelp = "";
  static constexpr const char* kText = nullptr;  // the sentence; null: a, the kind's name and b
  static constexpr Other kOther = Other::Needed;
  static constexpr bool kTakesFloor = false;  // as b
  static constexpr bool kCarries = false;     // b carries a
  static constexpr bool kIsOfSight = false;   // decided by rays in the scene, not by outlines
  static constexpr bool kIsInDegrees = false;
  static constexpr bool kFaces = false;       // a is turned to something where it stands
  static constexpr bool kTurns = false;       // decided by turns about z alone
  static constexpr bool kTurnsOnlyA = false;  // b, too, has turns that are asked for otherwise
  static constexpr bool kIsBeside = false;    // keeps outlines apart, if its gap is not below 0
  /// The sentence without another object.
  static constexpr const char* kAlone = TRIVET_SENTENCE("%1 at its point");

  /// In tolerances: 0 where it holds exactly, 1 at its tolerance.
  double cost(const Terms&, const Outline&, const Outline*) const { return 0; }
  /// See half_planes() in relations.h.
  std::vector<HalfPlane> half_planes(const Terms&, const Placed&, double) const { return {}; }
  bool is_decided_by_planes() const { return false; }
  /// From b, in which a lies; zero: it says nothing of that.
  Vec2 direction(const Outline&, const Outline&) const { return Vec2::Zero(); }
  /// Between the outlines; null: it has none.
  const Gap* gap() const { return nullptr; }
  /// Turns about z that bring the front of a, or of b, to where it asks for it.
  std::vector<Rotation> turns(const Outline&, const Outline&) const { return {}; }
  /// Unit, to what a faces, or from which it looks away; zero: it does not.
  Vec2 front(const Outline&, const Outline*) const { return Vec2::Zero(); }
  /// Metres between the outlines at most.
  double most_apart(const Terms&, const Sizes&) const { return kInfinity; }
  /// Places and lengths that it names: objects are looked for that far.
  void extend(Aabb&) const {}
  double length() const { return 0; }
  /// An object that stands already, to whose middle plane it refers; null: none.
  const std::string* about() const { return nullptr; }
  void set_about(const Outline&) {}
  /// Ways of which an entry has one; none: its keys do not depend on each other.
  static std::vector<Way> ways() { return {}; }
  /// Fault of an entry, by keys that go with each other; null: nothing is wrong.
  const char* wrong(const Terms&, const IsGiven&) const { return nullptr; }
};

double outside(double value, double lower, double upper);

/// lower <= (sign p + known) . d <= upper, of the position p.
void add_interval(const Vec2& d, double sign, double known, double lower, double upper,
                  std::vector<HalfPlane>& out);
/// The position less than this from there, along x and along y.
std::vector<HalfPlane> planes_about(const Vec2& at, double slack);
/// Outlines no farther apart than this.
std::vector<HalfPlane> planes_near(const Outline& moving, const Outline& other, double upper);

/// Outwards from a side of b.
Vec2 direction_of_side(const Outline& b, Side side);

/// The turn about z from one unit direction to another.
Rotation turn_between(const Vec2& from, const Vec2& to);
/// To this front, and each so many quarter turns from it.
std::vector<Rotation> turns_to(const Outline& moving, Vec2 front, int step);

}  // namespace relations

}  // namespace trivet
