#include "core/mesh/part_masses.h"

#include <cmath>
#include <sstream>

#include "core/mesh/moments.h"
#include "core/mesh/solid_faces.h"

namespace trivet {
namespace {

struct PartMoments {
  Moments solid, surface;
};

PartMass part_mass(const Component& part, bool closed, const PartMoments& moments) {
  constexpr double kLeast = 1e-9;  // of area x box diagonal; below, a volume is rounding error
  PartMass out;
  out.num_triangles = part.num_faces;
  out.area = moments.surface.measure;
  const double volume = std::abs(moments.solid.measure);
  // A closed part of almost no volume is a sheet that was folded onto itself.
  const bool solid = closed && volume > kLeast * out.area * part.box.diagonal();
  out.rule = solid ? MassRule::Volume : MassRule::Surface;
  out.centre = part.box.centre();
  if (solid) {
    out.volume = volume;
    out.is_cavity = part.depth % 2 == 1;
    out.is_turned = part.winding < 0;
    out.centre += moments.solid.centre();
  } else if (out.area > 0) {
    out.centre += moments.surface.centre();
  }
  return out;
}

}  // namespace

std::vector<PartMass> part_masses(const Mesh& mesh, const Adjacency& adjacency) {
  const SolidFaces solid = solid_faces(mesh, adjacency);
  std::vector<PartMoments> moments(adjacency.components.size());
  for (Index f = 0; f < static_cast<Index>(mesh.triangles.size()); ++f) {
    const Index part = adjacency.face_component[f];
    // Coordinates about the part's own middle keep its digits.
    const Triangle t = relative_to(adjacency.components[part].box.centre(), mesh.triangle(f));
    moments[part].solid.add(solid.weight(f) * signed_volume(t), t, 4);
    moments[part].surface.add(area_of(t), t, 3);
  }
  std::vector<PartMass> out;
  for (size_t c = 0; c < moments.size(); ++c)
    out.push_back(part_mass(adjacency.components[c], solid.closed[c], moments[c]));
  return out;
}

std::vector<Sentence> mass_notes(const MassProperties& mass) {
  std::vector<Sentence> out;
  const auto note = [&](const Sentence& what, Index count) {
    if (count > 0) out.push_back(say("%1: %2", what, count));
  };
  const InsideFindings& found = mass.findings;
  note("closed parts inside out, or cavities wound as solids, turned round for mass",
       found.num_turned_parts);
  note("faces of closed parts wound the other way than most, turned round for mass",
       found.num_flipped_faces);
  note("copies of faces and walls between parts, left out for mass", found.num_double_faces);
  // All further notes are about open parts.
  if (mass.rule == MassRule::Hull || found.num_open_parts == 0) return out;
  if (mass.rule == MassRule::Volume)
    note("open parts without an inside, which weigh nothing", found.num_open_parts);
  else
    note("open parts without an inside: mass by the surface of all parts", found.num_open_parts);
  if (found.other_centre_distance > 0) {
    out.push_back(say("mass by %1 would have its centre farther away by %2 in units of the file",
                      mass.rule == MassRule::Volume ? "surface" : "volume of the closed parts",
                      figure(found.other_centre_distance, 3)));
  }
  return out;
}

}  // namespace trivet
