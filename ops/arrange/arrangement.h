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
#include "ops/arrange/relation.h"

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
  Sentence text() const;       // grid of 12 objects on "tray"
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

/// Firmness asked of each of these, alone, where it comes to rest.
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
