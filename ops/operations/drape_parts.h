// Parts of DRAPE: from an operation and a scene to a problem of core/flex, and back to an object.
#pragma once

#include <variant>

#include "core/flex/drape.h"
#include "core/flex/presets.h"
#include "ops/base/refusal.h"
#include "ops/operations/drape.h"

namespace trivet {

/// Vertices of sheets and cables, at most: memory and hours.
inline constexpr int kMaxFlexVertices = 40000;

/// Cells of a sheet, or segments of a cable, so that levels can halve them.
flex::Grid grid_of(const DrapeOperation& o);
int num_segments_of(const DrapeOperation& o);
double length_of(const std::vector<Vec3>& path);

/// The preset with the operation's own numbers.
flex::FlexMaterial flex_material(const DrapeOperation& o);

std::variant<flex::DrapeProblem, Refusal> drape_problem(const Scene& scene,
                                                        const DrapeOperation& o);

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
