// Bodies and the rest that the reader of USD collects before joints connect them. Private.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/io/foreign/mass_sum.h"
#include "core/io/foreign/scene.h"
#include "core/io/foreign/usd/usda_frames.h"

namespace trivet {

/// Units of a stage, and the frame of its root in the world: metres, z up.
struct UsdaUnits {
  double metres = 0.01, kilograms = 1;
  Vec3 up = Vec3::UnitY();  // as the file has it
  UsdaFrame root;
};

struct UsdaBodies {
  UsdaStage stage;
  UsdaUnits units;
  std::map<std::string_view, const UsdaPrim*> prim_of_path;
  std::map<std::string, size_t> body_of_path;  // root prims of bodies
  std::vector<std::vector<UsdaPlace>> places;  // by body
  std::vector<const UsdaPrim*> joints, groups, filters;

  /// Null: there is none.
  const UsdaPrim* prim_at(const std::string& path) const;
  UsdaFrame frame_at(const std::string& path) const;
  /// The body that the prim is part of; else all bodies below it.
  std::vector<size_t> bodies_at(const std::string& path) const;
};

/// The prim's name for people: Trivet's own, the one to be displayed, or that of its path.
std::string usda_name(const UsdaPrim& prim);

/// Walks over the prims: bodies and colliders into the scene, the rest into `out`.
void collect_usda_bodies(const ForeignOptions& options, UsdaBodies& out, ForeignScene& scene);

/// Connects bodies by joints and keeps pairs apart. @param all  as collected.
void connect_usda_bodies(UsdaBodies& all, ForeignScene& scene);

}  // namespace trivet
