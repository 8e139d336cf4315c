#include <algorithm>

#include "ops/simulation/simulate.h"
#include "ops/stability/stability.h"

namespace trivet {
namespace {

class ReasonFinder {
 public:
  ReasonFinder(const SimulatedScene& simulated, const SimulationExport& done, const Scene& scene,
               const std::optional<double>& friction)
      : m_simulated(simulated), m_done(done), m_scene(scene) {
    for (const SimulatedObject& o : simulated.objects)
      if (o.moved > kTold) m_moved.insert(o.name);
    if (m_moved.empty()) return;
    StabilityOptions options;
    options.friction = friction;
    for (const ObjectStability& o : stability(scene, options).objects)
      if (o.topples || o.marginal || o.margin < kTold) m_weak.push_back(o);
  }

  std::vector<Sentence> of(const std::string& name) const {
    std::vector<Sentence> out;
    if (!m_moved.contains(name)) return out;
    const std::optional<ObjectId> id = m_scene.find(name);
    add_overlaps(name, out);
    if (!id) return out;
    add_missed(*id, out);
    add_weak(*id, out);
    add_moved_neighbours(*id, out);
    return out;
  }

 private:
  void add_overlaps(const std::string& name, std::vector<Sentence>& out) const {
    for (const PartOverlap& o : m_done.overlaps)
      if (o.a == name || o.b == name)
        out.push_back(say("its convex parts overlap those of \"%1\" by %2 metres",
                          o.a == name ? o.b : o.a, figure(o.depth, 2)));
  }

  // Contacts that the simulator does not find, though they close within its first steps.
  void add_missed(ObjectId id, std::vector<Sentence>& out) const {
    if (!m_simulated.touched) return;
    const std::string& name = m_scene.at(id).name;
    for (const ObjectContact& contact : m_scene.at(id).contacts) {
      const std::string other = name_of(contact.with);
      if (!m_simulated.touched->contains({name, other}) &&
          !m_simulated.touched->contains({other, name}))
        out.push_back(say("the simulator finds no contact with \"%1\"", other));
    }
  }

  void add_weak(ObjectId id, std::vector<Sentence>& out) const {
    const auto it = std::find_if(m_weak.begin(), m_weak.end(),
                                 [&](const ObjectStability& o) { return o.object == id; });
    if (it == m_weak.end()) return;
    out.push_back(it->topples
                      ? Sentence("it does not stand")
                      : say("it stands, but only just: margin %1 metres", figure(it->margin, 2)));
  }

  void add_moved_neighbours(ObjectId id, std::vector<Sentence>& out) const {
    for (const ObjectContact& contact : m_scene.at(id).contacts)
      if (const std::string other = name_of(contact.with);
          !contact.with.is_floor() && m_moved.contains(other))
        out.push_back(say("it touches \"%1\", which moved, too", other));
  }

  std::string name_of(const Support& with) const {
    return with.is_floor() ? "floor" : m_scene.at(with.object()).name;
  }

  const SimulatedScene& m_simulated;
  const SimulationExport& m_done;
  const Scene& m_scene;
  std::set<std::string> m_moved;
  std::vector<ObjectStability> m_weak;  // what topples, or stands only just
};

}  // namespace

void add_reasons(SimulatedScene& simulated, const SimulationExport& done, const Scene& scene,
                 const std::optional<double>& friction) {
  const ReasonFinder finder(simulated, done, scene, friction);
  for (SimulatedObject& o : simulated.objects) o.why = finder.of(o.name);
}

}  // namespace trivet
