// Parts of DRAPE: from an operation and a scene to a problem of core/flex, and back to an object.
#pragma once

#include <variant>

#include "core/flex/drape.h"
#include "core/flex/presets.h"
#include "ops/base/refusal.h"
#include "ops/operations/cable_path.h"
#include "ops/operations/drape.h"

namespace trivet {

/// Vertices of sheets and cables, at most: memory and hours.
inline constexpr int kMaxFlexVertices = 40000;

/// Cells of a sheet, or segments of a cable, so that levels can halve them.
flex::Grid grid_of(const DrapeOperation& o);
int num_segments_of(const DrapeOperation& o);

/// Metres: vertices of narrower cells would touch the neighbours of their neighbours.
inline double least_cell(double thickness) { return 2 * thickness; }

/// The preset with the operation's own numbers.
flex::FlexMaterial flex_material(const DrapeOperation& o);

std::variant<flex::DrapeProblem, Refusal> drape_problem(const Scene& scene,
                                                        const DrapeOperation& o);

/// A drape once more, with its ends where their holders are now.
struct DrapedAgain {
  DrapeOperation operation;
  flex::DrapeProblem problem;
};
std::variant<DrapedAgain, Refusal> problem_again(const Scene& scene, ObjectId draped);
/// The sheet flat at its start.
void place_sheet(const DrapeOperation& o, flex::DrapeProblem& out);
void pin(const DrapeOperation& o, flex::DrapeProblem& out);
/// Position of a pin at its holder's pose of now, world.
Vec3 pin_at(const Object& holder, const FlexTie& tie);
/// The vertices that are nearest to the operation's pins, one for each.
std::vector<int> pinned_vertices(const DrapeOperation& o, const flex::Points& start);

/// Things that may be in its way: by owners, in the scene's order, and the floor.
struct DrapeSurroundings {
  flex::Obstacles obstacles;
  std::vector<Support> owners;
};
/// @param start  from which it comes down. @param length  of a cable, else 0.
/// @param among  only these count; null: all.
DrapeSurroundings drape_surroundings(const Scene& scene, const flex::Points& start, double length,
                                     const std::vector<FlexSupport>* among = nullptr);
bool is_among(const std::vector<FlexSupport>& supports, const std::string& name);

/// The object that a result is: fixed, out of the scene.
Object draped_object(const Scene& scene, const DrapeOperation& o, const flex::DrapeProblem& problem,
                     const DrapeSurroundings& around, const flex::DrapeResult& result);

}  // namespace trivet
