// Contacts, the support graph and the judgement of a scene, as columns of arrays.
#include <pybind11/stl.h>

#include <map>

#include "apps/python/module/arrays.h"
#include "apps/python/module/bindings.h"
#include "core/base/bad_input.h"
#include "core/base/limits.h"
#include "ops/check/check.h"
#include "ops/stability/stability.h"

namespace trivet::python {
namespace {

using namespace py::literals;

// Objects by their place in the scene's order; the floor is -1.
class Numbering {
 public:
  explicit Numbering(const Scene& scene) {
    for (const ObjectId id : scene.ids()) {
      m_number_of[key_of(id)] = static_cast<Index>(m_names.size());
      m_names.push_back(scene.at(id).name);
    }
  }
  Index operator()(ObjectId id) const { return m_number_of.at(key_of(id)); }
  Index operator()(const Support& support) const {
    return support.is_floor() ? -1 : (*this)(support.object());
  }
  py::tuple names() const { return py::tuple(py::cast(m_names)); }

 private:
  std::map<ObjectKey, Index> m_number_of;
  std::vector<std::string> m_names;
};

py::array pairs(const std::vector<Index>& values) {
  return column(values).reshape({static_cast<py::ssize_t>(values.size() / 2), py::ssize_t{2}});
}

// Each contact once, seen from the object that comes later in the scene.
py::dict contacts(SharedScene& shared) {
  const SceneGuard guard(shared);
  const Scene& scene = shared.scene();
  const Numbering number(scene);
  std::vector<Index> objects, contact;
  std::vector<std::uint8_t> type, kind;
  std::vector<Index> features;
  std::vector<Vec3> point, normal;
  std::vector<double> gap;
  Index next = 0;
  for (const ObjectId id : scene.ids())
    for (const ObjectContact& touch : scene.at(id).contacts) {
      const Index self = number(id), other = number(touch.with);
      if (other > self) continue;
      for (const ContactPoint& p : touch.contact.points) {
        objects.insert(objects.end(), {self, other});
        contact.push_back(next);
        type.push_back(static_cast<std::uint8_t>(touch.contact.type));
        kind.push_back(static_cast<std::uint8_t>(p.features));
        features.insert(features.end(), {p.feature_object, p.feature_support});
        point.push_back(p.point);
        normal.push_back(p.normal);
        gap.push_back(p.gap);
      }
      ++next;
    }
  return py::dict("names"_a = number.names(), "objects"_a = pairs(objects),
                  "contact"_a = column(contact), "type"_a = column(type), "kind"_a = column(kind),
                  "features"_a = pairs(features), "point"_a = array_of(point),
                  "normal"_a = array_of(normal), "gap"_a = column(gap));
}

py::dict support_graph(SharedScene& shared) {
  const SceneGuard guard(shared);
  const Numbering number(shared.scene());
  std::vector<Index> edges;
  for (const LoadSupport::Entry& entry : load_support(shared.scene()).entries) {
    if (entry.on_floor) edges.insert(edges.end(), {-1, number(entry.object)});
    for (const ObjectId support : entry.supports)
      edges.insert(edges.end(), {number(support), number(entry.object)});
  }
  return py::dict("names"_a = number.names(), "edges"_a = pairs(edges));
}

py::list findings(const std::vector<SceneCheck::PairFinding>& found) {
  py::list out;
  for (const auto& one : found) out.append(py::make_tuple(one.a, one.b, one.count));
  return out;
}

void add_stability(const Scene& scene, const Stability& stability, py::dict& out) {
  py::list topples, marginal;
  for (const ObjectStability& one : stability.objects) {
    if (one.topples) topples.append(scene.at(one.object).name);
    if (one.marginal) marginal.append(scene.at(one.object).name);
  }
  const Numbering number(scene);
  std::vector<Index> objects;
  std::vector<Vec3> point, force;
  for (const ContactForce& one : stability.forces) {
    objects.insert(objects.end(), {number(one.on), number(one.from)});
    point.push_back(one.point);
    force.push_back(one.force);
  }
  out["names"] = number.names();
  out["stability"] = to_string(stability.status);
  out["stable"] = stability.stable();
  out["why_unknown"] = stability.why_unknown;
  out["margin"] = stability.margin;
  out["topples"] = topples;
  out["marginal"] = marginal;
  out["force_objects"] = pairs(objects);
  out["force_point"] = array_of(point);
  out["force"] = array_of(force);
}

// Checks a copy, with contacts up to date: the scene itself stays as it is.
py::dict check(SharedScene& shared, std::optional<double> friction, int num_threads) {
  if (friction && !(*friction >= kMinFriction && *friction <= kMaxFriction))
    bad_input(
        "friction: %1 is not accepted; accepted: 0.001 to 10, or None for that of the materials",
        py::str(py::float_(*friction)).cast<std::string>());
  Scene scene;
  SettleOptions settle;
  double clearance = 0;
  {
    const SceneGuard guard(shared);
    scene = shared.scene();
    settle = shared.settle;
    clearance = settle.clearance > 0 ? settle.clearance : shared.session().largest_clearance();
  }
  StabilityOptions options;
  options.friction = friction;
  options.clearance = clearance;
  const auto [found, verdict] = without_gil([&] {
    update_contacts(scene, clearance, settle);
    return std::pair(check_scene(scene, num_threads, clearance, settle), stability(scene, options));
  });
  py::dict out("passed"_a = found.ok(), "crossings"_a = findings(found.crossings),
               "float32_crossings"_a = findings(found.float32_crossings),
               "contained"_a = findings(found.contained), "not_at_rest"_a = found.not_at_rest,
               "smallest_gap"_a = found.smallest_gap);
  add_stability(scene, verdict, out);
  return out;
}

}  // namespace

void bind_queries(SceneClass& scene) {
  scene.def("contacts", &contacts)
      .def("support_graph", &support_graph)
      .def("check", &check, "friction"_a, "num_threads"_a);
}

}  // namespace trivet::python
