#include <algorithm>

#include "core/base/float32.h"
#include "core/base/limits.h"
#include "core/flex/thick_shape.h"
#include "core/io/mesh_model.h"
#include "ops/operations/drape_parts.h"

namespace trivet {
namespace {

// A share of half the thickness: room for the rounding to float32.
constexpr double kInside = 1 - 1e-3;

Vec3 middle_of(const flex::Points& x) {
  Aabb box;
  for (const Vec3& p : x) box.extend(p);
  return as_float32(box.centre());
}

void add_share(const std::string& name, double share, std::vector<FlexSupport>& out) {
  for (FlexSupport& support : out)
    if (support.name == name) {
      support.share += share;
      return;
    }
  out.push_back({name, share});
}

// Pins that nobody holds go by that name.
void add_pins(const std::vector<FlexTie>& ties, const flex::DrapeResult& result,
              std::vector<FlexSupport>& out) {
  for (const FlexTie& tie : ties) add_share(tie.name, result.pin_shares[tie.vertex], out);
  if (ties.empty() && result.pin_share != 0) out.push_back({"pins", result.pin_share});
}

std::vector<FlexSupport> supports_of(const Scene& scene, const DrapeSurroundings& around,
                                     const std::vector<FlexTie>& ties,
                                     const flex::DrapeResult& result) {
  std::vector<FlexSupport> out;
  for (size_t i = 0; i < result.shares.size(); ++i)
    if (result.touches[i]) out.push_back({named(scene, around.owners[i]).name, result.shares[i]});
  add_pins(ties, result, out);
  // The supports are listed by what they carry, the largest share first.
  std::stable_sort(out.begin(), out.end(),
                   [](const FlexSupport& a, const FlexSupport& b) { return a.share > b.share; });
  return out;
}

std::vector<FlexTie> ties_of(const Scene& scene, const DrapeOperation& o,
                             const flex::DrapeProblem& problem, const flex::DrapeResult& result) {
  std::vector<FlexTie> out;
  const std::vector<int> pinned = pinned_vertices(o, problem.start);
  for (size_t i = 0; i < o.held_by.size(); ++i) {
    const Pose& pose = scene.at(*scene.find(o.held_by[i])).pose;
    out.push_back({o.held_by[i], pinned[i],
                   pose.rotation.matrix().transpose() * (result.x[pinned[i]] - pose.translation)});
  }
  return out;
}

std::shared_ptr<const Flexible> flexible_of(const Scene& scene, const DrapeOperation& o,
                                            const flex::DrapeProblem& problem,
                                            const DrapeSurroundings& around,
                                            const flex::DrapeResult& result, const Vec3& centre) {
  auto out = std::make_shared<Flexible>();
  const flex::Body body = body_of(problem);
  out->is_cable = body.is_cable;
  out->material = problem.material;
  out->faces = body.faces;
  out->grid = problem.grid;
  out->length = problem.length;
  if (!problem.faces.empty()) out->rest = problem.start;
  for (size_t v = 0; v < problem.pinned.size(); ++v)
    if (problem.pinned[v]) out->pins.push_back(static_cast<int>(v));
  out->layer = result.layer;
  out->pressure = flex::DrapeOptions{}.pressure;
  // Vertices are kept about the centre, so that float32 files hold them well.
  for (const Vec3& p : result.x) out->vertices.push_back(p - centre);
  out->friction = result.friction;
  out->certificate = result.certificate;
  out->ties = ties_of(scene, o, problem, result);
  out->start = FlexStart{o.path, o.start, o.pins, o.cell};
  out->supports = supports_of(scene, around, out->ties, result);
  return out;
}

Model look_of(flex::ThickShape thick, const Scene& scene, const DrapeOperation& o,
              const flex::FlexMaterial& material) {
  Model model = model_of_mesh(std::move(thick.mesh));
  model.corner_normals = std::move(thick.corner_normals);
  Material& look = model.materials[0];
  look.name = material.name;
  look.roughness = 0.9f;
  if (const auto* const preset = flex::flex_preset(material.name))
    look.base_colour = {preset->colour[0], preset->colour[1], preset->colour[2], 1};
  if (o.of)
    if (const auto& from = scene.at(*scene.find(*o.of)).model) look = from->materials[0];
  return model;
}

PhysicsMaterial solid_material(const flex::FlexMaterial& m, bool is_cable) {
  constexpr double kQuarterPi = 0.78539816339744831;
  PhysicsMaterial out;
  out.friction = std::clamp(m.friction, kMinFriction, kMaxFriction);
  // A solid's density follows from the weight per area, or per length.
  const double depth = is_cable ? kQuarterPi * m.thickness * m.thickness : m.thickness;
  out.density = std::clamp(m.density / depth, kMinDensity, kMaxDensity);
  return out;
}

}  // namespace

Object draped_object(const Scene& scene, const DrapeOperation& o, const flex::DrapeProblem& problem,
                     const DrapeSurroundings& around, const flex::DrapeResult& result) {
  const Vec3 centre = middle_of(result.x);
  Object object;
  object.name = o.object;
  object.flexible = flexible_of(scene, o, problem, around, result, centre);
  const Flexible& flexible = *object.flexible;
  const double radius = kInside * problem.material.thickness / 2;
  flex::ThickShape thick = flexible.is_cable
                               ? flex::thick_cable(flexible.vertices, radius)
                               : flex::thick_sheet(flexible.vertices, flexible.faces, radius);
  object.model =
      std::make_shared<const Model>(look_of(std::move(thick), scene, o, problem.material));
  object.shape = make_shape(object.model->mesh);
  // A draped object is stiff and fixed: only its own operation moves its vertices.
  object.fixed = true;
  object.pose.translation = centre;
  object.material = solid_material(problem.material, flexible.is_cable);
  return object;
}

}  // namespace trivet
