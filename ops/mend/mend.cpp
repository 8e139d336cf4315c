#include "ops/mend/mend.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <string>

#include "core/io/foreign/scene.h"
#include "core/motion/compose.h"
#include "ops/mend/attitudes.h"
#include "ops/mend/close_gaps.h"
#include "ops/mend/in_place.h"
#include "ops/mend/landing.h"
#include "ops/mend/neighbours.h"
#include "ops/mend/rearrange.h"
#include "ops/mend/rows.h"
#include "ops/mend/starts.h"
#include "ops/placement/clearance.h"
#include "ops/placement/depth.h"
#include "ops/stability/stability.h"

namespace trivet {
namespace {

// Parts of an object's size: a lost support, attitude or height, and a support too many.
constexpr double kLostSupport = 1, kLostAttitude = 1, kLostTier = 0.7, kExtraSupport = 0.15;
constexpr int kAims = 3;           // tries to hit the place, from where it came to rest
constexpr double kMayBeNoise = 2;  // times the tilt that is taken for level
constexpr double kAttitudeDeg = 8, kLeaningDeg = 30;

class Mender {
 public:
  Mender(Scene& scene, const MendOptions& options)
      : m_scene(scene),
        m_options(options),
        m_meant(infer_intent(
            scene, options.tolerance > 0 ? std::optional(options.tolerance) : std::nullopt)) {}

  MendedScene run() {
    // Objects without findings stay; only the others leave the scene, and come back.
    m_moving = unsettled_objects(m_scene, m_options);
    add_loads_meant();
    note_whom_they_lean_on();
    const std::vector<ObjectId> order = in_order(m_moving);
    std::map<std::uint32_t, Pose> given;
    for (const ObjectId id : m_scene.ids())
      if (m_scene.at(id).placed) given[id.index] = m_scene.at(id).pose;
    SettledScene settled = is_heap(m_meant, m_moving) ? as_heap(order) : bottom_up(order);
    MendedScene out;
    static_cast<SettledScene&>(out) = std::move(settled);
    out.moved = moved_since(given, m_scene);  // what was moved twice is told once
    out.tolerance = m_meant.tolerance;
    for (const ObjectId id : m_moving) compare_relations(m_scene, *m_meant.find(id), out);
    return out;
  }

 private:
  // A load may touch what is meant to carry it from the side only, or not at all.
  void add_loads_meant() {
    std::set<std::uint32_t> moving;
    for (const ObjectId id : m_moving) moving.insert(id.index);
    const std::set<std::string> only(m_options.only.begin(), m_options.only.end());
    // Supports come before their loads, so that loads of loads are found, too.
    for (const ObjectIntent& o : m_meant.objects) {
      const Object& object = m_scene.at(o.id);
      if (!object.placed || (!only.empty() && !only.count(object.name))) continue;
      const bool is_load = std::any_of(o.on.begin(), o.on.end(), [&](const IntendedSupport& s) {
        return s.on.is_object() && moving.count(s.on.object().index) > 0;
      });
      if (is_load && moving.insert(o.id.index).second) m_moving.push_back(o.id);
    }
  }

  // They lean on each other as given; that is gone when they are taken out.
  void note_whom_they_lean_on() {
    for (const ObjectId id : m_moving)
      if (const ObjectIntent& o = *m_meant.find(id); !o.is_level)
        for (const ObjectId on : intended_neighbours(m_scene, m_meant, o).leans_on)
          m_leaning.insert({id.index, on.index});
  }

  // Supports come before what they carry, so that each object sees where its support is now.
  SettledScene bottom_up(const std::vector<ObjectId>& order) {
    Rearrangement rearrangement(m_scene, m_options, order);
    m_nominal_given.clear(), m_in_row.clear();  // those of an earlier try
    for (const ObjectId id : order) {
      m_object = m_meant.find(id);
      place(rearrangement, id);
    }
    SettledScene out = rearrangement.finish();
    name_what_does_not_rest(out);
    return out;
  }

  // A whole without a gap may still not stand; then it is not called mended.
  void name_what_does_not_rest(SettledScene& out) const {
    if (!out.unable.empty()) return;
    for (const ObjectId id : not_at_rest(m_scene, m_options, m_moving))
      out.unable.push_back({id, m_scene.at(id).name, Sentence("no place near is free")});
  }

  // In place, and what then has no place bottom up; or all bottom up, if that leaves less.
  SettledScene as_heap(const std::vector<ObjectId>& order) {
    MendOptions half = m_options;
    half.seconds /= 2;
    const Scene before = m_scene;
    SettledScene out = mend_in_place(m_scene, half, m_meant, order);
    if (!out.unable.empty()) place_rest(out);
    name_what_does_not_rest(out);
    if (out.unable.empty()) return out;
    Scene heap = std::move(m_scene);
    m_scene = before;
    SettledScene other = bottom_up(order);
    if (other.unable.size() < out.unable.size()) return other;
    m_scene = std::move(heap);
    return out;
  }

  // Once more, as what one needs may have been placed behind it.
  void place_rest(SettledScene& out) {
    for (int round = 0; round < 2; ++round) {
      std::vector<ObjectId> left;
      for (const UnsettledObject& o : out.unable) left.push_back(o.id);
      SettledScene rest = bottom_up(left);
      out.unable = std::move(rest.unable);
    }
  }

  // Objects that stand level on one thing are moved apart together, when the first of them comes
  // back: a row has no order in which each finds room for itself.
  void spread_row_of(const Rearrangement& scene, const ObjectIntent& first) {
    if (!first.is_level || first.on.empty() || m_in_row.count(first.id.index)) return;
    std::vector<Placement> row;
    for (const ObjectId id : m_moving) {
      ObjectIntent meant = *m_meant.find(id);
      if (meant.on.empty() || meant.on[0].on != first.on[0].on || m_scene.at(id).placed) continue;
      // The row keeps room for one that leans by little more than noise: see stand_in_row().
      if (!meant.is_level && meant.tilt_deg > kMayBeNoise * m_meant.most_tilt_deg) continue;
      if (!meant.is_level) meant.level = levelled(m_scene.at(id), downs_of(m_scene.at(id)));
      meant.is_level = true;
      row.push_back({id, pose_meant(scene, meant)});
    }
    for (const Placement& p : spread_row(m_scene, std::move(row), first.on[0].on, m_meant.tolerance,
                                         m_meant.most_tilt_deg))
      m_in_row[p.id.index] = p.pose;
  }

  std::vector<ObjectId> in_order(const std::vector<ObjectId>& ids) const {
    std::vector<ObjectId> out;
    for (const ObjectIntent& o : m_meant.objects)
      if (std::find(ids.begin(), ids.end(), o.id) != ids.end()) out.push_back(o.id);
    return out;
  }

  void place(Rearrangement& scene, ObjectId id) {
    // An object that stands well where it is, on supports that did not move, stays; but not where
    // its row needs room.
    spread_row_of(scene, *m_object);
    const bool gives_way = m_object->is_level && m_in_row.count(id.index) &&
                           !is_same_pose(m_in_row.at(id.index), pose_meant(scene, *m_object));
    if (!gives_way && !support_moved(scene) && scene.keep(id)) return;
    if (scene.is_out_of_time()) return scene.give_up(id, Sentence("the time is over"));
    const Pose nominal = nominal_pose(scene, id);
    // Let go from there, a thin one may tip by what rounding leaves.
    const auto as_meant = [&](const Object& there) {
      return judged(id, there, nominal, nominal).as_meant;
    };
    if (m_object->is_level && scene.stand_still(id, nominal, as_meant)) return;
    const std::optional<Pose> rest = lies_on_several() ? rest_as_given(scene) : std::nullopt;
    const auto stands = [&](const Object& there) { return as_meant(there) && stands_as_whole(); };
    if (rest && scene.stand_still(id, *rest, stands)) return;
    Sentence why = "no place near is free";
    std::vector<Start> starts =
        starts_around(m_scene, *m_object, scene.given(id), nominal, m_meant.tolerance);
    if (rest) starts.insert(starts.begin(), {0, *rest});
    // PUT's own starts are far from each other and turned: they count where all others fail.
    Landing best = cheapest(scene, id, nominal, starts, 1, why);
    if (best.cost == kInfinity) best = cheapest(scene, id, nominal, starts, kTriesOfPut, why);
    if (!best.as_meant && !m_object->is_level && stand_in_row(scene, id)) return;
    aim_again(scene, id, nominal, best);
    if (best.cost == kInfinity || !scene.put(id, best.start, best.tries).ok())
      scene.give_up(id, why);
  }

  // The place of least cost among those to which it falls from these starts.
  Landing cheapest(Rearrangement& scene, ObjectId id, const Pose& nominal,
                   const std::vector<Start>& starts, int tries_of_put, Sentence& why) {
    LandingSearch search(kAimed * m_meant.tolerance, m_options.most_tries);
    for (const Start& start : starts) {
      if (search.ends_before(start) || scene.is_out_of_time()) break;
      // A start that interpenetrates would be refused by PUT, which costs more.
      if (search.is_known(start) || refuse_interpenetration(m_scene, id, start.pose, false))
        continue;
      search.note_try(start);
      // Each start is tried in a transaction that is taken back; the best is put at the end.
      const auto judge = [&](const Object& there) {
        search.note(judged(id, there, nominal, start.pose));
      };
      const OperationResult result = scene.try_put(id, start.pose, judge, tries_of_put);
      if (result.refusal) why = sentence_of(*result.refusal);
    }
    Landing best = search.best();
    best.tries = tries_of_put;
    return best;
  }

  // It leans, or lies between others: then the given attitude says more than a stable one.
  bool lies_on_several() const { return !m_object->is_level || m_object->on.size() > 1; }

  // The pose nearest to the given one at which contacts hold it as it lies.
  std::optional<Pose> rest_as_given(const Rearrangement& scene) {
    ObjectIntent meant = *m_object;
    meant.level = scene.given(meant.id);
    const Pose given = at_gap(scene, meant, 0);
    const PlacedBox here{meant.id, body_of(m_scene.at(meant.id), given).world_box};
    return rest_near(m_scene, {meant.id, given}, m_meant.tolerance,
                     clearance_near(m_scene, m_options.settle, here.box, {&here, 1}),
                     [&scene] { return scene.is_out_of_time(); });
  }

  // The object that it leans on may give way to its push.
  bool stands_as_whole() const {
    if (!keeps_whole_at_rest(m_options.settle)) return true;
    StabilityOptions by;
    by.clearance = m_options.settle.clearance;
    const std::vector<ObjectStability> all = stability(m_scene, by).objects;
    return std::none_of(all.begin(), all.end(), [](const auto& o) { return o.topples; });
  }

  // One that seems to lean, and finds no place so, may have been tilted by noise.
  bool stand_in_row(Rearrangement& scene, ObjectId id) const {
    const auto in_row = m_in_row.find(id.index);
    return in_row != m_in_row.end() &&
           scene.stand_still(id, in_row->second,
                             [&](const Object& there) { return carried_as_meant(there); });
  }

  // A start from as far on the other side of the nominal place as it came to rest from that.
  void aim_again(Rearrangement& scene, ObjectId id, const Pose& nominal, Landing& best) {
    const int tries = best.tries;
    for (int k = 0; k < kAims && best.off.norm() > kAimed * m_meant.tolerance; ++k) {
      const Pose start = shifted(best.start, -best.off.x(), -best.off.y(), 0);
      if (scene.is_out_of_time() || refuse_interpenetration(m_scene, id, start, false)) return;
      Landing landing;
      const auto judge = [&](const Object& there) { landing = judged(id, there, nominal, start); };
      scene.try_put(id, start, judge, tries);
      if (landing.cost >= best.cost) return;
      best = landing;
      best.tries = tries;
    }
  }

  bool support_moved(const Rearrangement& scene) const {
    // A support that has been moved takes along what it carries.
    return std::any_of(m_object->on.begin(), m_object->on.end(), [&](const IntendedSupport& s) {
      return s.on.is_object() && was_moved(scene, s.on.object());
    });
  }
  bool was_moved(const Rearrangement& scene, ObjectId id) const {
    const ObjectIntent* const o = m_meant.find(id);
    return o && m_scene.at(id).placed && m_nominal_given.count(id.index) &&
           !is_same_pose(scene.given(id), m_scene.at(id).pose);
  }

  Pose nominal_pose(const Rearrangement& scene, ObjectId id) {
    m_nominal_given.insert(id.index);
    const auto in_row = m_in_row.find(id.index);
    const bool stands = m_object->is_level && in_row != m_in_row.end();
    return stands ? in_row->second : pose_meant(scene, *m_object);
  }

  // Level, in contact with its supports, and along with its main one.
  Pose pose_meant(const Rearrangement& scene, const ObjectIntent& meant) const {
    const Pose pose = at_gap(scene, meant, meant.gap);
    // The object itself counts: with all taken out nothing else gives a clearance.
    const PlacedBox here{meant.id, body_of(m_scene.at(meant.id), pose).world_box};
    return in_contact(m_scene, meant, pose, m_meant.tolerance,
                      clearance_near(m_scene, m_options.settle, here.box, {&here, 1}));
  }

  Pose at_gap(const Rearrangement& scene, const ObjectIntent& meant, double gap) const {
    Pose pose = meant.level;
    pose.translation.z() -= gap;
    if (meant.on.empty() || !meant.on[0].on.is_object()) return pose;
    const ObjectId support = meant.on[0].on.object();
    const ObjectIntent* const below = m_meant.find(support);
    if (!below || !was_moved(scene, support)) return pose;
    const Pose now = m_scene.at(support).pose;
    const Pose from = below->level;
    // A level object is shifted; a turn of its support about the vertical does not concern it.
    if (meant.is_level) {
      pose.translation += middle_of(support, now) - middle_of(support, from);
      return pose;
    }
    return carried_along(from, now, pose);
  }

  Vec3 middle_of(ObjectId id, const Pose& pose) const {
    return middle_of_box(m_scene.at(id), pose);
  }

  Landing judged(ObjectId id, const Object& there, const Pose& nominal, const Pose& start) const {
    const double size = size_of(there), tol = m_meant.tolerance;
    const Vec3 off = middle_of(id, there.pose) - middle_of(id, nominal);
    const double turn = turn_between_deg(nominal.rotation, there.pose.rotation);
    // The cost is the way that its points have gone; lost relations cost sizes of the object.
    double penalty = 0;
    if (!carried_as_meant(there)) penalty += kLostSupport;
    penalty += kExtraSupport * extra_supports(there);
    const bool tipped =
        turn > (m_object->is_level ? std::max(kAttitudeDeg, m_meant.most_tilt_deg) : kLeaningDeg);
    if (tipped)
      penalty += kLostAttitude;
    else if (std::abs(there.pose.translation.z() - nominal.translation.z()) > 2 * tol + 0.01)
      penalty += kLostTier;
    Landing out;
    out.off = off.head<2>();
    out.cost = off.norm() + 0.5 * size * turn * (3.14159265358979323846 / 180) +
               penalty * std::max(size, 2 * tol);
    out.start = start;
    out.as_meant = penalty == 0;
    out.nearly = penalty < kLostTier;
    return out;
  }

  bool carried_as_meant(const Object& there) const {
    if (m_object->on.empty()) return true;
    const std::vector<Support> supports = carriers_of(there);
    return std::find(supports.begin(), supports.end(), m_object->on[0].on) != supports.end();
  }

  bool leans_on(const Support& s) const {
    return s.is_object() && m_leaning.count({m_object->id.index, s.object().index}) > 0;
  }

  int extra_supports(const Object& there) const {
    int out = 0;
    for (const Support& s : carriers_of(there))
      out += std::none_of(m_object->on.begin(), m_object->on.end(),
                          [&](const IntendedSupport& meant) { return meant.on == s; }) &&
             !leans_on(s);
    return out;
  }

  Scene& m_scene;
  const MendOptions& m_options;
  Intent m_meant;
  const ObjectIntent* m_object = nullptr;  // that is being placed
  std::vector<ObjectId> m_moving;
  std::set<std::pair<std::uint32_t, std::uint32_t>> m_leaning;  // slots: one on the other
  std::map<std::uint32_t, Pose> m_in_row;   // nominal poses of objects in rows, by slot
  std::set<std::uint32_t> m_nominal_given;  // slots of what was placed anew
};

}  // namespace

MendedScene mend_scene(Scene& scene, const MendOptions& options) {
  return Mender(scene, options).run();
}

}  // namespace trivet
