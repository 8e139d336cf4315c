#include "ops/mend/mend.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <string>

#include "core/contact/contact_memory.h"
#include "core/io/foreign/scene.h"
#include "core/motion/compose.h"
#include "ops/mend/attitudes.h"
#include "ops/mend/in_place.h"
#include "ops/mend/landing.h"
#include "ops/mend/neighbours.h"
#include "ops/mend/rearrange.h"
#include "ops/mend/rest_near.h"
#include "ops/mend/rows.h"
#include "ops/mend/starts.h"
#include "ops/placement/clearance.h"
#include "ops/placement/depth.h"
#include "ops/settle/program_memory.h"
#include "ops/stability/part.h"

namespace trivet {
namespace {

// Tolerances: a place near enough, and one that is far for a level object.
constexpr double kNearEnough = 1, kFarForLevel = 1.5;
constexpr int kAims = 3;           // tries to hit the place, from where it came to rest
constexpr double kMayBeNoise = 2;  // times the tilt that is taken for level
constexpr int kMaxProgramObjects = 200;
constexpr double kTimeInPlace = 0.5;  // share of the time for a heap, before what has no place then

class Mender {
 public:
  /// @param options  their `is_over` is the deadline's.
  Mender(Scene& scene, const MendOptions& options, const Deadline& deadline)
      : m_scene(scene),
        m_options(options),
        m_deadline(deadline),
        m_meant(infer_intent(
            scene, options.tolerance > 0 ? std::optional(options.tolerance) : std::nullopt, m_facts,
            options.is_over)) {}

  MendedScene run() {
    // Objects without findings stay; only the others leave the scene, and come back.
    m_moving = unsettled_objects(m_scene, m_options);
    if (m_deadline.is_over()) return nothing_in_time();
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
  // The intent may be known in part alone.
  MendedScene nothing_in_time() const {
    MendedScene out;
    static_cast<SettledScene&>(out) = left_as_they_are(m_scene, m_moving);
    return out;
  }

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
          m_leaning[id.index].insert(on.index);
  }

  // Supports come before what they carry, so that each object sees where its support is now.
  SettledScene bottom_up(const std::vector<ObjectId>& order) {
    Rearrangement rearrangement(m_scene, m_options, m_deadline, order);
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
    if (!out.unable.empty() || m_deadline.is_over()) return;
    for (const ObjectId id : not_at_rest(m_scene, m_options, m_moving))
      out.unable.push_back({id, m_scene.at(id).name, Sentence("no place near is free")});
  }

  // In place, and what then has no place bottom up; or all bottom up, if that leaves less.
  SettledScene as_heap(const std::vector<ObjectId>& order) {
    const Deadline half = m_deadline.of_rest(kTimeInPlace);
    MendOptions in_half = m_options;
    in_half.is_over = half.function();
    const Scene before = m_scene;
    SettledScene out = mend_in_place(m_scene, in_half, half, m_meant, order);
    if (!out.unable.empty()) place_rest(out);
    name_what_does_not_rest(out);
    if (out.unable.empty() || m_deadline.is_over()) return out;
    Scene heap = std::move(m_scene);
    m_scene = before;
    SettledScene other = bottom_up(order);
    if (other.unable.size() < out.unable.size()) return other;
    m_scene = std::move(heap);
    return out;
  }

  // Once more, as what one needs may have been placed behind it.
  void place_rest(SettledScene& out) {
    for (int round = 0; round < 2 && !m_deadline.is_over(); ++round) {
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
      if (!meant.is_level) meant.level = meant.upright;
      meant.is_level = true;
      row.push_back({id, pose_meant(scene, meant)});
    }
    for (const Placement& p : spread_row(m_scene, std::move(row), first.on[0].on, m_meant.tolerance,
                                         m_meant.most_tilt_deg, m_facts))
      m_in_row[p.id.index] = p.pose;
  }

  std::vector<ObjectId> in_order(const std::vector<ObjectId>& ids) const {
    std::vector<ObjectId> out;
    for (const ObjectIntent& o : m_meant.objects)
      if (std::find(ids.begin(), ids.end(), o.id) != ids.end()) out.push_back(o.id);
    return out;
  }

  void place(Rearrangement& scene, ObjectId id) {
    if (scene.is_out_of_time()) return scene.give_up(id, time_is_over());
    // An object that stands well where it is, on supports that did not move, stays; but not where
    // its row needs room.
    spread_row_of(scene, *m_object);
    const bool gives_way = m_object->is_level && m_in_row.count(id.index) &&
                           !is_same_pose(m_in_row.at(id.index), pose_meant(scene, *m_object));
    if (!gives_way && !support_moved(scene) && scene.keep(id)) return;
    if (scene.is_out_of_time()) return scene.give_up(id, time_is_over());
    const Pose nominal = nominal_pose(scene, id);
    // Let go from there, a thin one may tip by what rounding leaves.
    const auto as_meant = [&](const Object& there) {
      return judged(id, there, nominal, nominal).as_meant;
    };
    if (m_object->is_level && scene.stand_still(id, nominal, as_meant)) return;
    const double near = kNearEnough * m_meant.tolerance;
    Search search{nominal,
                  starts_around(m_scene, *m_object, scene.given(id), nominal, m_meant.tolerance),
                  LandingSearch(near, m_options.most_tries)};
    // An object that slides or rolls a little from its level attitude needs no other start.
    if (m_object->is_level && try_starts(scene, search, {.most = 1}))
      return put_best(scene, search);
    if (stand_as_given(scene, search)) return;
    try_starts(scene, search, {});
    // PUT's own starts are far from each other and turned: they count where all others fail.
    if (search.landings.best().cost == kInfinity) {
      search.landings = LandingSearch(near, m_options.most_tries);
      try_starts(scene, search, {.of_put = kTriesOfPut});
    }
    if (!search.landings.best().as_meant && !m_object->is_level && stand_in_row(scene, id)) return;
    put_best(scene, search);
  }

  /// Starts of the object that is being placed, and where it came to rest from these.
  struct Search {
    Pose nominal;
    std::vector<Start> starts;
    LandingSearch landings;
    Sentence why = "no place near is free";
  };
  struct Tries {
    int of_put = 1;
    int most = std::numeric_limits<int>::max();
  };

  // At the pose nearest to the given one at which contacts hold it; else that is a start.
  bool stand_as_given(Rearrangement& scene, Search& search) {
    const ObjectId id = m_object->id;
    // An object goes aside, as in a row, if something is in the way of its level attitude.
    const bool is_free = !refuse_interpenetration(m_scene, id, search.nominal, false);
    if (!lies_on_several() && !is_free) return false;
    const std::optional<Pose> rest = rest_as_given(scene);
    if (!rest) return false;
    // Places without a support that it gains here are farther, if there are any.
    const auto accept = [&](const Object& there) {
      const Landing landing = judged(id, there, search.nominal, *rest);
      // A level object may find its place nearer if it goes aside.
      if (landing.as_meant && m_object->is_level && landing.cost > kFarForLevel * m_meant.tolerance)
        return false;
      return landing.nearly && stands_as_whole();
    };
    if (scene.stand_still(id, *rest, accept)) return true;
    search.starts.insert(search.starts.begin(), {0, *rest});
    return false;
  }

  // Looks for the place of least cost among those to which it falls from the starts.
  // @return true: it is near enough.
  bool try_starts(Rearrangement& scene, Search& search, Tries tries) {
    const ObjectId id = m_object->id;
    for (const Start& start : search.starts) {
      if (search.landings.ends_before(start) || scene.is_out_of_time() || tries.most == 0) break;
      // A start that interpenetrates would be refused by PUT, which costs more.
      if (search.landings.is_known(start) ||
          refuse_interpenetration(m_scene, id, start.pose, false))
        continue;
      search.landings.note_try(start);
      --tries.most;
      const Landing landing = landing_from(scene, start.pose, search.nominal, tries.of_put);
      search.landings.note(landing);
      if (landing.trial.result.refusal) search.why = sentence_of(*landing.trial.result.refusal);
    }
    return search.landings.is_near_enough();
  }

  // It is let go from there, and what that changes is taken back.
  Landing landing_from(Rearrangement& scene, const Pose& start, const Pose& nominal, int tries) {
    const ObjectId id = m_object->id;
    Landing out;
    const auto judge = [&](const Object& there) { out = judged(id, there, nominal, start); };
    out.trial = scene.try_put(id, start, judge, tries);
    out.tries = tries;
    return out;
  }

  void put_best(Rearrangement& scene, const Search& search) {
    Landing best = search.landings.best();
    aim_again(scene, search.nominal, best);
    if (best.cost == kInfinity) return scene.give_up(m_object->id, search.why);
    scene.redo(best.trial);
  }

  // It leans, or lies between others: then the given attitude says more than a stable one.
  bool lies_on_several() const { return !m_object->is_level || m_object->on.size() > 1; }

  // The pose nearest to the given one at which contacts hold it as it lies.
  std::optional<Pose> rest_as_given(const Rearrangement& scene) {
    ObjectIntent meant = *m_object;
    meant.level = scene.given(meant.id);
    const Pose given = at_gap(scene, meant, 0);
    return rest_near(m_scene, {meant.id, given}, m_meant.tolerance, clearance_at(meant.id, given),
                     [&scene] { return scene.is_out_of_time(); });
  }

  double clearance_at(ObjectId id, const Pose& pose) const {
    // The object itself counts: with all taken out nothing else gives a clearance.
    const PlacedBox here{id, body_of(m_scene.at(id), pose).world_box};
    return clearance_near(m_scene, m_options.settle, here.box, {&here, 1});
  }
  // The object that it leans on may give way to its push.
  bool stands_as_whole() const {
    if (!keeps_whole_at_rest(m_options.settle)) return true;
    const ObjectId id = m_object->id;
    return judge_parts(m_scene, connected_with(m_scene, {&id, 1}), {&id, 1},
                       clearance_of(m_scene, m_options.settle), kMaxProgramObjects,
                       {std::nullopt, friction_share(m_options.settle)}, Toppling::SomeWillDo)
        .stands;
  }

  // One that seems to lean, and finds no place so, may have been tilted by noise.
  bool stand_in_row(Rearrangement& scene, ObjectId id) const {
    const auto in_row = m_in_row.find(id.index);
    return in_row != m_in_row.end() &&
           scene.stand_still(id, in_row->second, [&](const Object& there) {
             return carried_as_meant(*m_object, there);
           });
  }

  // A start from as far on the other side of the nominal place as it came to rest from that.
  void aim_again(Rearrangement& scene, const Pose& nominal, Landing& best) {
    for (int k = 0; k < kAims && best.off.norm() > kAimed * m_meant.tolerance; ++k) {
      const Pose start = shifted(best.start, -best.off.x(), -best.off.y(), 0);
      if (scene.is_out_of_time() || refuse_interpenetration(m_scene, m_object->id, start, false))
        return;
      const Landing landing = landing_from(scene, start, nominal, best.tries);
      if (landing.cost >= best.cost) return;
      best = landing;
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
    return in_contact(m_scene, meant, pose, m_meant.tolerance, clearance_at(meant.id, pose));
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
    const auto leans_on = m_leaning.find(id.index);
    const MeantPlace meant{
        *m_object, nominal, m_meant.tolerance, m_meant.most_tilt_deg,
        leans_on == m_leaning.end() ? std::set<std::uint32_t>{} : leans_on->second};
    return landing_at(meant, there, start);
  }

  Scene& m_scene;
  const MendOptions& m_options;
  const Deadline& m_deadline;
  ShapeFacts m_facts;
  Intent m_meant;
  const ObjectIntent* m_object = nullptr;  // that is being placed
  std::vector<ObjectId> m_moving;
  std::map<std::uint32_t, std::set<std::uint32_t>> m_leaning;  // slots: on which it leans
  std::map<std::uint32_t, Pose> m_in_row;   // nominal poses of objects in rows, by slot
  std::set<std::uint32_t> m_nominal_given;  // slots of what was placed anew
};

}  // namespace

MendedScene mend_scene(Scene& scene, const MendOptions& options) {
  const ContactMemory contacts;  // what stays where it is, is judged again and again
  const ProgramMemory programs;
  const Deadline deadline = deadline_of(options);
  MendOptions timed = options;
  timed.is_over = deadline.function();
  return Mender(scene, timed, deadline).run();
}

}  // namespace trivet
