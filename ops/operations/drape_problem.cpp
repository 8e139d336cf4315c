#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>

#include "core/exact/interpenetration.h"
#include "ops/operations/drape_parts.h"

namespace trivet {
namespace {

constexpr double kCellsOfSheet = 40, kSegmentsOfCable = 128;  // along the length, by default
constexpr int kLeastCells = 16, kLeastSegments = 32;          // that are not halved again
constexpr int kMostHalvings = 3;

// Rounded up so that it can be halved `halvings` times.
int cells_along(double length, double cell, int halvings) {
  // A little slack keeps a length that is a multiple of the cell from one cell more.
  const double count = std::ceil(length / cell * (1 - 1e-9));
  const int step = 1 << halvings;
  const int whole = std::max(1, static_cast<int>(std::min(count, 1.0 * kMaxFlexVertices)));
  return (whole + step - 1) / step * step;
}

int halvings_of(double count, int least) {
  int halvings = 0;
  while (halvings < kMostHalvings && count / 2 >= least) ++halvings, count /= 2;
  return halvings;
}

double cell_of(const DrapeOperation& o, double length, double by_default) {
  return o.cell > 0 ? o.cell : length / by_default;
}

// Why a mesh is no sheet; empty: it is one.
Sentence no_sheet(const Mesh& mesh) {
  if (mesh.triangles.empty() || mesh.vertices.size() > static_cast<size_t>(kMaxFlexVertices))
    return say("its mesh has %1 vertices; accepted: up to %2", mesh.vertices.size(),
               kMaxFlexVertices);
  // Each directed edge of an oriented surface belongs to one face.
  std::map<std::pair<Index, Index>, int> uses;
  for (const Index3& t : mesh.triangles) {
    const Vec3& a = mesh.vertices[t[0]];
    if ((mesh.vertices[t[1]] - a).cross(mesh.vertices[t[2]] - a).squaredNorm() == 0)
      return "its mesh has triangles without area";
    for (int k = 0; k < 3; ++k)
      if (++uses[{t[k], t[(k + 1) % 3]}] > 1)
        return "its mesh is no surface of one side: an edge has two faces in one direction";
  }
  // An edge without a face on its other side makes the surface open.
  const bool is_closed = std::all_of(uses.begin(), uses.end(), [&](const auto& use) {
    return uses.contains({use.first.second, use.first.first});
  });
  if (is_closed) return "its mesh is closed; accepted: open ones";
  return {};
}

Sentence too_fine(double cell, double thickness) {
  const double least = least_cell(thickness);
  if (cell >= least) return {};
  return say("the cells of its mesh are %1 m wide; accepted: %2 m or more, twice the thickness",
             figure(cell), figure(least));
}

// Width of a square of two triangles, in the mean.
double mean_cell(const flex::Points& x, const std::vector<Index3>& triangles) {
  double area = 0;
  for (const Index3& t : triangles) area += (x[t[1]] - x[t[0]]).cross(x[t[2]] - x[t[0]]).norm() / 2;
  return std::sqrt(2 * area / static_cast<double>(triangles.size()));
}

std::optional<Refusal> place_mesh(const Scene& scene, const DrapeOperation& o,
                                  flex::DrapeProblem& out) {
  const auto id = scene.find(*o.of);
  if (!id) return unknown_object(scene, *o.of);
  const Object& object = scene.at(*id);
  const Mesh& mesh = object.shape->mesh;
  out.start = world_positions(*object.shape, world_from_object(o.start, object.up, object.scale));
  // A sheet is an open surface of one side, with no more vertices than can be draped.
  Sentence why = no_sheet(mesh);
  if (why.empty()) why = too_fine(mean_cell(out.start, mesh.triangles), out.material.thickness);
  if (!why.empty()) {
    Refusal refusal{Refusal::Cause::NoSheet, {named(scene, Support(*id))}};
    refusal.detail = std::move(why);
    return refusal;
  }
  for (const Index3& t : mesh.triangles) out.faces.push_back({t[0], t[1], t[2]});
  return std::nullopt;
}

// All that a body may reach that comes down from its start.
Aabb reach_of(const flex::Points& start, double length) {
  Aabb box;
  for (const Vec3& p : start) box.extend(p);
  flex::grow(box, std::max(length, box.diagonal()));
  box.lower.z() = -kInfinity;
  return box;
}

void add_object(const Object& object, const Aabb& reach, flex::Obstacles& out) {
  const flex::Points x = world_positions(*object.shape, object.world_from_object());
  std::vector<Index3> triangles;
  // Faces out of reach are left out: large scenes have millions.
  for (const Index3& t : object.shape->mesh.triangles) {
    Aabb box;
    for (const Index v : t) box.extend(x[v]);
    if (overlaps(box, reach)) triangles.push_back(t);
  }
  out.add(x, triangles, object.material.friction);
}

// One triangle, whose edges are out of reach: an edge in a plane would push, too, and elsewhere for
// another reach.
void add_floor(double friction, const Aabb& reach, flex::Obstacles& out) {
  const double x = reach.lower.x(), y = reach.lower.y();
  const double size = reach.upper.x() - x + reach.upper.y() - y;
  const flex::Points corners{
      {x - size, y - size, 0}, {x + 4 * size, y - size, 0}, {x - size, y + 4 * size, 0}};
  const std::vector<Index3> triangles{{0, 1, 2}};
  out.add(corners, triangles, friction);
}

}  // namespace

void place_sheet(const DrapeOperation& o, flex::DrapeProblem& out) {
  out.grid = grid_of(o);
  const Affine world = world_from_object(o.start, UpAxis::Z, 1);
  for (int j = 0; j <= out.grid->num_v; ++j)
    for (int i = 0; i <= out.grid->num_u; ++i)
      out.start.push_back(
          world.apply({out.grid->length_u * i / out.grid->num_u - out.grid->length_u / 2,
                       out.grid->length_v * j / out.grid->num_v - out.grid->length_v / 2, 0}));
}

void pin(const DrapeOperation& o, flex::DrapeProblem& out) {
  out.pinned.assign(out.start.size(), false);
  for (const int v : pinned_vertices(o, out.start)) out.pinned[v] = true;
}

std::vector<int> pinned_vertices(const DrapeOperation& o, const flex::Points& start) {
  std::vector<int> out;
  for (const Vec3& point : o.pins) {
    size_t nearest = 0;
    for (size_t v = 1; v < start.size(); ++v)
      if ((start[v] - point).squaredNorm() < (start[nearest] - point).squaredNorm()) nearest = v;
    out.push_back(static_cast<int>(nearest));
  }
  return out;
}

flex::Grid grid_of(const DrapeOperation& o) {
  const double length = o.size->maxCoeff(), cell = cell_of(o, length, kCellsOfSheet);
  // Levels need numbers of cells that can be halved.
  const int halvings = halvings_of(std::ceil(length / cell), kLeastCells);
  return {cells_along(o.size->x(), cell, halvings), cells_along(o.size->y(), cell, halvings),
          o.size->x(), o.size->y()};
}

int num_segments_of(const DrapeOperation& o) {
  const double length = length_of(o.path), cell = cell_of(o, length, kSegmentsOfCable);
  return cells_along(length, cell, halvings_of(std::ceil(length / cell), kLeastSegments));
}

flex::FlexMaterial flex_material(const DrapeOperation& o) {
  const bool is_cable = !o.path.empty();
  const char* const usual = is_cable ? "lead" : "cotton";
  flex::FlexMaterial out = flex::flex_preset(o.material.empty() ? usual : o.material)->material;
  out.thickness = o.thickness.value_or(out.thickness);
  out.density = o.density.value_or(out.density);
  out.bending = o.bending.value_or(out.bending);
  out.friction = o.friction.value_or(out.friction);
  return out;
}

std::variant<flex::DrapeProblem, Refusal> drape_problem(const Scene& scene,
                                                        const DrapeOperation& o) {
  flex::DrapeProblem out;
  out.material = flex_material(o);
  // The three kinds of start exclude each other: a size, a path, or an object's mesh.
  if (o.size) {
    place_sheet(o, out);
  } else if (!o.path.empty()) {
    out.num_segments = num_segments_of(o);
    out.length = length_of(o.path);
    out.start = resampled(o.path, out.num_segments);
  } else if (auto why = place_mesh(scene, o, out)) {
    return *why;
  }
  // Pins come last, as they take vertices of the start.
  pin(o, out);
  return out;
}

bool is_among(const std::vector<FlexSupport>& supports, const std::string& name) {
  return std::any_of(supports.begin(), supports.end(),
                     [&](const FlexSupport& support) { return support.name == name; });
}

DrapeSurroundings drape_surroundings(const Scene& scene, const flex::Points& start, double length,
                                     const std::vector<FlexSupport>* among) {
  DrapeSurroundings out;
  const Aabb reach = reach_of(start, length);
  // Only objects within reach count, or, when it is judged again, those that it touched.
  for (const ObjectId id : scene.near(reach)) {
    if (among && !is_among(*among, scene.at(id).name)) continue;
    add_object(scene.at(id), reach, out.obstacles);
    out.owners.emplace_back(id);
  }
  if (scene.floor && (!among || is_among(*among, "floor"))) {
    add_floor(scene.floor_material.friction, reach, out.obstacles);
    out.owners.push_back(Support::floor());
  }
  out.obstacles.build();
  return out;
}

}  // namespace trivet
