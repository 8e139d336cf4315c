// Problems of arranging, as data: things, relations between them, patterns. Metres, degrees.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/base/sentence.h"
#include "core/base/types.h"

namespace trivet {

/// Poses that a thing may have; see stable_poses.h.
struct PoseChoice {
  enum class Kind {
    Upright,     // the stable pose nearest to the model's own up
    AsModelled,  // exactly as in the model's file
    Free,        // let go as in the model's file; it may come to rest otherwise
    Stable,      // any stable pose, the likely ones first
    Side,        // of these, those on its side: the model's own up is level to 30 degrees
    Number,      // one of the stable poses, as `trivet info --poses` numbers them
  };
  Kind kind = Kind::Upright;
  int number = 0;
};

/// An object that is to be placed.
struct Thing {
  std::string object;
  PoseChoice pose = {};
  std::vector<double> yaws_deg = {};  // turns about z to choose from; empty: as relations ask for,
                                      // else every 45 degrees
  bool any_yaw = false;               // else every 22.5 degrees, from an angle of the seed on
};

/// Terms: `a` and `b` are objects; seen from above, from in front of b, as one who faces b's front
/// sees it; a gap is between outlines.
enum class RelationKind {
  On,       // b, or the floor, alone carries a
  In,       // b and what lies in it carry a, its centre over b
  Against,  // a's `side` is at `gap` from b
  Near,     // the distance of a from b is in `gap`
  LeftOf,   // a is beside b, at `gap`, with so much `overlap` along the side
  RightOf,
  InFrontOf,
  Behind,
  Facing,         // a's front points to b's centre, or to `point`
  Away,           // a's back does
  Aligned,        // a's front is b's, or a quarter turn or more of it
  Parallel,       // or half a turn of it
  Perpendicular,  // a quarter turn of it, to either side
  Same,           // a's front is b's
  Centred,        // a's centre is b's plus `offset`, along b's `along`
  Within,         // a's outline is in `region`
  At,             // a's centre is at `point`
  Symmetric,      // a stands where the mirror image of b does, at the vertical plane `axis`
  AtEdge,         // a's outline is inside b's, at `gap` from its `side`, or from the nearest one
  Under,          // b is above `overlap` of a's outline
  View,           // so much of a, `overlap`, is seen from b or `eye`
  Reach,          // a is no farther than the gap's upper end from there, the way to it free
};
const char* to_string(RelationKind kind);  // "on", "left_of", ...

enum class Side { Front, Back, Left, Right };
const char* to_string(Side side);

struct Relation {
  RelationKind kind = RelationKind::On;
  std::string a, b;          // b: may be "floor" of On; empty where there is a point or a region
  std::optional<int> level;  // On: the support surface, from below; negative: from above; nullopt:
                             // any
  double lower = 0, upper = kInfinity;  // metres, of the gap
  double overlap = 0.5;                 // of the narrower of both; Against: of a's side;
                                        // Under: of a's outline; View: of what is seen of a
  std::optional<Side> side;             // of Against: a's, default back; of AtEdge: b's
  bool along_x = true, along_y = true;  // of Centred: b's right, b's back
  Vec2 offset = Vec2::Zero();
  std::optional<Vec2> point;
  std::vector<Vec2> region;      // convex, counter-clockwise
  std::optional<Vec3> eye;       // of View and Reach; nullopt: over b's centre ...
  double eye_height = 1.2;       // ... so high over its lowest point
  std::string about;             // of Symmetric: stands already; its middle plane, left to right
  Vec2 axis = Vec2::UnitY();     // of Symmetric: unit, along the plane, which goes through `point`
  double tolerance = 1e-3;       // metres or degrees: a cost of 1
  std::optional<double> weight;  // soft; nullopt: the cost may not be more than 1
  size_t entry = 0;              // of the list that it is from

  bool is_hard() const { return !weight; }
  bool is_support() const { return kind == RelationKind::On || kind == RelationKind::In; }
  /// Decided by rays in the scene, not by outlines from above.
  bool is_of_sight() const {
    return kind == RelationKind::Under || kind == RelationKind::View || kind == RelationKind::Reach;
  }
  /// "cup" right_of "plate".
  Sentence text() const;
};

/// Things side by side on one surface, placed together without a search.
struct Pattern {
  enum class Kind {
    Row,
    Grid,
    Circle,   // about a point, fronts to it or away from it
    Facings,  // as in shops: blocks side by side, `wide` things in front, the others behind them
    Along,    // at equal distances along a polyline, centres on it
  };
  enum class Align { Left, Centre, Right, Spread };
  Kind kind = Kind::Row;
  std::vector<std::string> things;
  std::string on;                   // an object or "floor"
  std::optional<int> level;         // as of Relation; nullopt: the highest
  double gap = 1e-3;                // metres between things, and to walls; at least 8 clearances
  Align align = Align::Centre;      // along b's right
  Align across = Align::Centre;     // Left: at b's front, Right: at its back
  double inset = 0;                 // metres from the edge to which `across` moves it
  bool shuffled = false;            // in an order of the seed
  int columns = 0;                  // of a grid; 0: as many as there is room for
  double radius = 0;                // of a circle, metres, to the things' centres
  double start_deg = 0;             // of the first of a circle, from b's right, counter-clockwise
  bool outwards = false;            // of a circle: fronts away from its middle
  std::optional<Vec2> middle = {};  // of a circle; nullopt: of the surface
  struct Block {
    size_t count = 0;  // the next so many of `things`
    int wide = 1;
  };
  std::vector<Block> blocks = {};  // of facings
  std::vector<Vec2> line = {};     // of Along: corners
  double spacing = 0;              // of Along: metres along it; 0: from its beginning to its end
  enum class Front { Right, Left, Onwards, Back };
  Front front = Front::Right;  // of Along: of the things, seen along the line
  Sentence text() const;       // grid of 12 things on "tray"
};

/// Space beside an object that all others keep out of, but for what carries it: before a drawer,
/// over a seat. Zones may overlap zones.
struct Zone {
  std::string object, name;
  Vec3 lower = Vec3::Zero(), upper = Vec3::Zero();  // metres, in the model's frame after its up
                                                    // axis
  Sentence text() const;                            // zone "drawers" of "desk"
};

/// A distance to keep of each of these from all that is no support of it.
struct KeepApart {
  std::vector<std::string> things;
  double distance = 0;
  std::vector<std::pair<std::string, std::string>> except;  // either way round; sorted pairs
};

/// How well each of these has to stand, alone, where it comes to rest.
struct Steadiness {
  std::vector<std::string> things;
  double margin = 0;            // metres of its centre of mass to where it tips, at least
  double friction = kInfinity;  // Coulomb's coefficient that it needs, at most
};

struct Arrangement {
  std::uint64_t seed = 0;
  std::vector<Thing> things;
  std::vector<Relation> relations;
  std::vector<Pattern> patterns;
  std::vector<KeepApart> keeps;
  std::vector<Zone> zones;
  std::vector<Steadiness> steadiness;
  std::map<std::string, Vec3> fronts;  // of objects, in the model's frame after its up axis;
                                       // others: -y

  /// Bounds of the search.
  int max_evictions = 60;
  int max_attempts = 4;
  int max_improvements = 12;  // things that are moved for the soft relations, once all stand
};

}  // namespace trivet
