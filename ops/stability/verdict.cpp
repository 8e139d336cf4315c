#include "ops/stability/verdict.h"

#include <algorithm>
#include <map>
#include <utility>

#include "core/base/tunables.h"
#include "core/scene/joint.h"
#include "ops/placement/clearance.h"
#include "ops/stability/carried.h"
#include "ops/stability/certificate.h"
#include "ops/stability/contact_forces.h"
#include "ops/stability/interior_point.h"
#include "ops/stability/part.h"

namespace trivet {
namespace {

class StabilityCheck {
 public:
  StabilityCheck(const Scene& scene, const StabilityOptions& options, FreeBodies bodies,
                 Wanted wanted)
      : m_scene(scene),
        m_options(options),
        m_wanted(wanted),
        m_clearance(checked_clearance(scene, options)),
        m_all(std::move(bodies)) {
    for (size_t i = 0; i < m_all.bodies.size(); ++i)
      m_index_of[m_all.bodies[i].id.index] = static_cast<Index>(i);
  }

  Stability run() {
    m_out.friction = m_options.friction;
    if (const Object* invalid = first_invalid()) return not_judged(*invalid);
    // The cheap proof goes first: vertical forces from the top down. The second one has a little
    // less friction in reserve.
    const Certificate certificate = vertical_certificate(m_all);
    const Certificate reserve = vertical_certificate(m_all, kMarginalFriction);
    const std::vector<Index> part_of = connected_parts(m_all);
    const Index num_parts =
        part_of.empty() ? 0 : 1 + *std::max_element(part_of.begin(), part_of.end());
    std::vector<char> failed(num_parts, 0), no_reserve(num_parts, 0);
    m_ids_of_part.resize(num_parts);
    for (size_t i = 0; i < part_of.size(); ++i) {
      m_ids_of_part[part_of[i]].push_back(m_all.bodies[i].id);
      m_out.objects.push_back({m_all.bodies[i].id, m_all.bodies[i].weight});
      if (!certificate.bodies[i].certified) failed[part_of[i]] = 1;
      if (!reserve.bodies[i].certified) no_reserve[part_of[i]] = 1;
    }
    // A part with a body that is not certified needs the linear program.
    std::vector<char> solved(num_parts, 0);
    for (Index p = 0; p < num_parts; ++p)
      if (failed[p] && touches_nothing(p)) solved[p] = 1, let_fall(p);
    for (Index p = 0; p < num_parts; ++p)
      if (failed[p] && !solved[p]) solve_part(p, part_of, solved);
    take_certified(certificate, part_of, solved);
    for (Index p = 0; p < num_parts; ++p)
      if (no_reserve[p] && !solved[p] && m_wanted == Wanted::Verdict) judge_reserve(near(p));
    finish();
    return std::move(m_out);
  }

 private:
  // Contacts of what interpenetrates mean nothing.
  const Object* first_invalid() const {
    for (const ObjectId id : m_scene.invalid_objects())
      if (m_scene.at(id).placed) return &m_scene.at(id);
    return nullptr;
  }
  Stability not_judged(const Object& invalid) {
    for (const FreeBody& body : m_all.bodies) m_out.objects.push_back({body.id, body.weight});
    worsen("\"" + invalid.name + "\" interpenetrates something");
    m_out.margin = 0;
    return std::move(m_out);
  }

  void take_certified(const Certificate& certificate, const std::vector<Index>& part_of,
                      const std::vector<char>& solved) {
    for (size_t i = 0; i < part_of.size(); ++i)
      if (!solved[part_of[i]]) set_margin(i, certificate.bodies[i].margin);
    for (size_t i = 0; i < m_all.touches.size(); ++i) {
      const BodyContact& t = m_all.touches[i];
      if (!solved[part_of[t.on]]) add_force(m_all, t, Vec3(0, 0, certificate.forces[i]));
    }
  }

  // Sets the margin of a body that does not topple.
  void set_margin(size_t i, double margin) {
    m_out.objects[i].margin = margin;
    m_out.objects[i].marginal = margin < kMarginalShift * m_all.bodies[i].size;
  }

  void add_force(const FreeBodies& bodies, const BodyContact& t, const Vec3& force) {
    if (force.isZero(0)) return;
    const ObjectId on = bodies.bodies[t.on].id;
    m_out.forces.push_back({on, t.partner, t.contact.point, force});
    if (t.from != BodyContact::kGround)
      m_out.forces.push_back({bodies.bodies[t.from].id, on, t.contact.point, -force});
  }

  // The bodies of one part, with all contacts that settling would count on, and what these join.
  FreeBodies near(Index p) const {
    return near_part(m_scene, m_ids_of_part[p], m_clearance, is_fixed, {m_options.friction});
  }

  // Indices in m_all of a part's bodies.
  std::vector<Index> members_of(const FreeBodies& part) const {
    std::vector<Index> out;
    for (const FreeBody& body : part.bodies) out.push_back(m_index_of.at(body.id.index));
    return out;
  }

  bool is_small(const FreeBodies& part) const {
    return static_cast<int>(part.bodies.size()) <= m_options.max_program_objects;
  }

  // Judges a part that holds with a little less friction, too.
  void judge_reserve(FreeBodies part) {
    if (is_small(part) && !is_time_over(m_options.is_over)) {
      // The dual simplex usually answers at once for few; the slower way lets more contacts join.
      if (part.bodies.size() <= kManyBodies &&
          quickly_balanced(part, m_clearance, kMarginalFriction))
        return;
      const PartForces found = quickest_forces(part, m_clearance, kMarginalFriction);
      if (found.solved && found.balanced()) return;
    }
    for (const Index i : members_of(part)) m_out.objects[i].marginal = true;
  }

  // However near something is: rest needs contacts within their tolerance.
  bool touches_nothing(Index p) const {
    const std::vector<ObjectId>& ids = m_ids_of_part[p];
    return ids.size() == 1 && m_scene.at(ids[0]).contacts.empty();
  }

  void let_fall(Index p) {
    ObjectStability& object = m_out.objects[m_index_of.at(m_ids_of_part[p][0].index)];
    object.topples = true;
    object.motion.velocity = -Vec3::UnitZ();
    m_out.status = Stability::Status::Unstable;
    m_out.residual = std::max(m_out.residual, 1.0);
  }

  // With the parts that it takes along: these are solved, too.
  void solve_part(Index p, const std::vector<Index>& part_of, std::vector<char>& solved) {
    FreeBodies part = near(p);
    const std::vector<Index> members = members_of(part);
    m_out.method = Stability::Method::LinearProgram;
    for (const Index i : members) solved[part_of[i]] = 1;
    if (!is_small(part))
      return worsen("a part of " + std::to_string(members.size()) +
                    " objects is too large for a proof");
    if (is_time_over(m_options.is_over)) return worsen("the time is over");
    const PartForces found = forces_of(part);
    if (!found.solved) return worsen("the linear program was not solved");
    m_out.residual = std::max(m_out.residual, found.residual);
    // Forces that balance everything are the proof; without them gravity moves these bodies.
    const bool balanced = found.balanced();
    if (!balanced) m_out.status = Stability::Status::Unstable;
    const bool is_rated = balanced && m_wanted == Wanted::Verdict;
    const double margin = is_rated ? margin_of(part) : 0.0;
    for (size_t k = 0; k < members.size(); ++k) {
      ObjectStability& object = m_out.objects[members[k]];
      if (object.topples) continue;  // it touches nothing
      object.topples = !balanced && found.moves[k];
      if (object.topples) object.motion = found.motions[k];
      if (balanced) set_margin(members[k], margin);
    }
    if (is_rated) judge_reserve(part);
    if (m_wanted == Wanted::Findings) return;
    const bool is_told = balanced && !is_time_over(m_options.is_over);
    const std::vector<Vec3> forces = is_told ? told_forces(part) : std::vector<Vec3>{};
    // Forces that the scene's links explain are preferred to others that balance as well.
    for (size_t k = 0; k < part.touches.size(); ++k)
      add_force(part, part.touches[k], forces.empty() ? found.forces[k] : forces[k]);
  }

  double margin_of(const FreeBodies& part) const {
    if (is_time_over(m_options.is_over)) return 0;
    return std::max(0.0, shift_margin(part, m_clearance));
  }

  // Many bodies mostly stand, without further contacts; else those that matter join.
  PartForces forces_of(FreeBodies& part) const {
    // Forces of the simplex method are those of few contacts; who topples, both tell.
    if (m_wanted == Wanted::Findings) return quickest_forces(part, m_clearance);
    if (part.bodies.size() > kManyBodies) {
      FreeBodies first = part;
      first.more.clear();
      PartForces out = forces_by_interior_point(first, m_clearance);
      if (out.solved && out.balanced()) return out;
    }
    return contact_forces(part, m_clearance);
  }

  // Forces of the supports that the scene's links name, where these suffice.
  std::vector<Vec3> told_forces(const FreeBodies& part) const {
    std::vector<MayCarry> may;
    for (const BodyContact& t : part.touches) {
      const auto& links = m_scene.at(part.bodies[t.on].id).contacts;
      const auto link = std::find_if(links.begin(), links.end(), [&](const ObjectContact& entry) {
        return entry.with == t.partner;
      });
      may.push_back(link == links.end() ? MayCarry{false, false}
                                        : MayCarry{holds_up(*link), weighs_on(*link)});
    }
    return forces_of_carriers(part, m_clearance, may);
  }

  void worsen(const std::string& why) {
    if (m_out.status != Stability::Status::Stable) return;
    m_out.status = Stability::Status::Unknown;
    m_out.why_unknown = why;
  }

  void finish() {
    if (m_out.status != Stability::Status::Unknown) m_out.why_unknown.clear();
    for (ObjectStability& o : m_out.objects) {
      m_out.margin = std::min(m_out.margin, o.margin);
      if (!o.topples && is_carried_across_gap(m_scene.at(o.object))) o.marginal = true;
    }
    judge_marginal();
    // Forces come in the order of the bodies they act on, whichever part was solved first.
    std::map<std::uint32_t, size_t> rank;  // of slots
    for (const FreeBody& body : m_all.bodies) rank.emplace(body.id.index, rank.size());
    std::stable_sort(m_out.forces.begin(), m_out.forces.end(),
                     [&](const ContactForce& a, const ContactForce& b) {
                       return rank.at(a.on.index) < rank.at(b.on.index);
                     });
  }

  void judge_marginal() {
    const auto is_marginal = [](const ObjectStability& o) { return o.marginal; };
    if (m_out.status == Stability::Status::Stable &&
        std::any_of(m_out.objects.begin(), m_out.objects.end(), is_marginal))
      m_out.status = Stability::Status::Marginal;
  }

  const Scene& m_scene;
  const StabilityOptions& m_options;
  const Wanted m_wanted;
  const double m_clearance;
  const FreeBodies m_all;
  std::map<std::uint32_t, Index> m_index_of;  // in m_all, by slot
  std::vector<std::vector<ObjectId>> m_ids_of_part;
  Stability m_out;
};

}  // namespace

double checked_clearance(const Scene& scene, const StabilityOptions& options) {
  return options.clearance > 0 ? options.clearance : default_clearance(scene);
}

Stability checked(const Scene& scene, const StabilityOptions& options, FreeBodies bodies,
                  Wanted wanted) {
  return StabilityCheck(scene, options, std::move(bodies), wanted).run();
}

}  // namespace trivet
