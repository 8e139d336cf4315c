// Scenes for simulators, written: what is refused, and which rules there are.
#include <algorithm>
#include <filesystem>
#include <set>

#include "core/base/error.h"
#include "core/base/extension.h"
#include "ops/simulation/simulation.h"

namespace trivet {
namespace {

bool is_mjcf(const std::string& path) {
  const std::string extension = lower_extension(path);
  return extension == ".xml" || extension == ".mjcf";
}

bool is_too_deep(const PartOverlap& overlap) { return overlap.depth > overlap.allowed; }

/// The triangles themselves for what parts cannot follow.
void use_meshes(SimulationExport& done) {
  // Models with a pair that is still too deep collide by their triangles, all of their bodies.
  std::set<size_t> models;
  for (const PartOverlap& o : done.overlaps)
    if (is_too_deep(o))
      for (const size_t body : {o.body_a, o.body_b}) models.insert(done.scene.bodies[body].model);
  for (const size_t i : models) {
    SimulationModel& model = done.scene.models[i];
    model.parts.clear();
    if (!done.stands_out.empty()) done.stands_out[i] = {};
    done.notes.push_back(
        say("\"%1\": its triangles collide, as no convex parts leave room for others",
            model.model->path));
  }
  std::erase_if(done.overlaps, is_too_deep);
}

void refuse_overlaps(const SimulationExport& done, const std::string& path,
                     const SimulationOptions& options) {
  const auto num = std::count_if(done.overlaps.begin(), done.overlaps.end(), is_too_deep);
  if (num == 0) return;
  const PartOverlap& o = *std::find_if(done.overlaps.begin(), done.overlaps.end(), is_too_deep);
  const Sentence more = num > 1
                            ? say("more than %1, and of %2 more pairs", figure(o.allowed), num - 1)
                            : say("more than %1", figure(o.allowed));
  throw Error(
      Error::Kind::BadInput,
      "%1: convex parts of \"%2\" and \"%3\" overlap by %4 metres, %5: a simulator would push "
      "them apart; accepted: %6--max-overlap from %7%8",
      path, o.a, o.b, figure(o.depth), more,
      std::string(options.collision == CollisionRule::Fitted ? "" : "--collision fitted, "),
      figure(done.overlaps.front().depth), std::string(is_mjcf(path) ? "" : ", --collision mesh"));
}

}  // namespace

const std::vector<std::string>& collision_rule_names() {
  static const std::vector<std::string> names = {"fitted", "hull", "components", "decomposition",
                                                 "mesh"};
  return names;
}

const char* to_string(CollisionRule rule) {
  return collision_rule_names()[static_cast<size_t>(rule)].c_str();
}

CollisionRule collision_rule_from_name(const std::string& name) {
  const std::vector<std::string>& names = collision_rule_names();
  const auto it = std::find(names.begin(), names.end(), name);
  if (it == names.end())
    throw Error(Error::Kind::BadInput,
                "\"%1\" is not accepted; accepted: fitted, hull, components, decomposition, mesh",
                name);
  return static_cast<CollisionRule>(it - names.begin());
}

void check_collision_rule(CollisionRule rule, const std::string& path) {
  if (rule == CollisionRule::Mesh && is_mjcf(path))
    throw Error(Error::Kind::BadInput,
                "--collision: \"mesh\" is not accepted for MJCF, as MuJoCo takes the hulls of "
                "meshes; accepted: fitted, hull, components, decomposition");
  if (rule == CollisionRule::Decomposition && !can_decompose())
    throw Error(Error::Kind::BadInput,
                "--collision: \"decomposition\" is not part of this build (Debian: "
                "libbullet-extras-dev); accepted: fitted, hull, components, mesh");
}

SimulationExport export_simulation(const Scene& scene, const std::string& path,
                                   const SimulationOptions& options) {
  check_collision_rule(options.collision, path);
  SimulationExport out = simulation_of(scene, std::filesystem::path(path).stem().string(), options);
  if (options.collision == CollisionRule::Fitted && !is_mjcf(path)) use_meshes(out);
  refuse_overlaps(out, path, options);
  out.files = write_simulation(out.scene, path, options.files);
  return out;
}

}  // namespace trivet
