#include "core/flex/judge.h"

#include "core/flex/drape.h"
#include "core/flex/elasticity.h"
#include "core/flex/self_crossings.h"

namespace trivet::flex {
namespace {

// As it was before it came down; its start does not matter but for a mesh's rest shape.
DrapeProblem problem_of(const Flexible& flexible) {
  DrapeProblem out;
  out.material = flexible.material;
  out.grid = flexible.grid;
  if (flexible.is_cable) out.num_segments = static_cast<int>(flexible.faces.size());
  out.length = flexible.length;
  out.faces = flexible.faces;
  out.start = flexible.rest;
  out.pinned.assign(flexible.vertices.size(), false);
  for (const int v : flexible.pins) out.pinned[v] = true;
  return out;
}

// True if what it is made of has as many vertices as it has.
bool fits(const Flexible& flexible) {
  const size_t count = flexible.vertices.size();
  if (flexible.is_cable) return flexible.faces.size() + 1 == count;
  if (!flexible.grid) return flexible.rest.size() == count;
  return static_cast<size_t>(flexible.grid->num_vertices()) == count;
}

}  // namespace

Points moved(const Points& x, const Affine& by) {
  Points out;
  out.reserve(x.size());
  for (const Vec3& p : x) out.push_back(by.apply(p));
  return out;
}

Judgement judge(const Flexible& flexible, const Affine& world_from_object,
                const Obstacles& obstacles) {
  Judgement out;
  State state;
  // The state is judged in the world, where gravity and the obstacles are.
  state.x = moved(flexible.vertices, world_from_object);
  if (!flexible.is_cable) {
    out.crosses_itself = self_crossing(state.x, flexible.faces).has_value();
    out.crosses_itself_in_float32 =
        self_crossing(rounded_to_float32(flexible.vertices), flexible.faces).has_value();
  }
  // A file may claim anything: shape and vertices have to fit before anything is computed.
  if (!fits(flexible) || out.crosses_itself) {
    out.is_clear = false;
    return out;
  }
  const Body body = body_of(problem_of(flexible));
  Surroundings surroundings(body, obstacles);
  EnergyModel model(body, surroundings, {flexible.layer, flexible.pressure}, DrapeOptions{}.slip);
  out.is_clear = model.evaluate(state);
  if (!out.is_clear) return out;
  // Stored friction takes the place of anchors; the net force is what is left.
  for (size_t v = 0; v < state.x.size(); ++v)
    state.gradient[v] -= world_from_object.apply_direction(flexible.friction[v]);
  out.net_force = model.residual(state.gradient);
  return out;
}

}  // namespace trivet::flex
