// Mass of a mesh by parts, for display.
#pragma once

#include <string>
#include <vector>

#include "core/base/sentence.h"
#include "core/mesh/mass.h"

namespace trivet {

/// A component of a mesh. Object frame, file units.
struct PartMass {
  Index num_triangles = 0;
  MassRule rule = MassRule::Volume;  // Volume: closed; Surface: open, or without a volume
  bool is_cavity = false;            // of the part around it
  bool is_turned = false;            // its faces are wound the other way than its inside demands
  Vec3 centre = Vec3::Zero();        // of its solid or its surface; of its box without area
  double volume = 0;                 // 0 with MassRule::Surface
  double area = 0;
};

/// In the order of the components.   Cost O(#F).
std::vector<PartMass> part_masses(const Mesh& mesh, const Adjacency& adjacency);

/// Assumptions of the rule of the mass, in words; empty for a well-made solid.
std::vector<Sentence> mass_notes(const MassProperties& mass);

}  // namespace trivet
