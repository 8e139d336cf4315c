#include "ops/files/animation/motion_film.h"

#include <algorithm>
#include <cmath>

#include "core/io/animation.h"
#include "core/io/mesh_model.h"
#include "core/motion/pose_interpolation.h"
#include "core/scene/joint_load.h"
#include "ops/operations/put_parts.h"

namespace trivet {
namespace {

constexpr double kPause = 0.25;          // seconds between operations
constexpr double kFrame = 1.0 / 30;      // seconds between keys of a long motion
constexpr double kShortest = 1e-3;       // seconds, of a motion
constexpr double kFramesPerTurn = 72;    // between keys things go straight: arcs need more of them
constexpr double kMostFrames = 600;      // of a motion
constexpr double kLeastLength = 1e-300;  // metres: below, nothing moves

double fall_time(double length) { return std::max(kShortest, std::sqrt(2 * length / kGravity)); }

double turn_between(const Pose& from, const Pose& to) {  // radians
  return path_length(from, to, 1) - path_length(from, to, 0);
}

int num_frames(double seconds, double turn) {
  const double frames = std::max(seconds / kFrame, kFramesPerTurn * turn / (2 * M_PI));
  return static_cast<int>(std::clamp(std::ceil(frames), 1.0, kMostFrames));
}

bool is_same(const std::optional<Pose>& a, const std::optional<Pose>& b) {
  if (!a || !b) return !a && !b;
  return a->translation == b->translation && a->rotation.w == b->rotation.w &&
         a->rotation.x == b->rotation.x && a->rotation.y == b->rotation.y &&
         a->rotation.z == b->rotation.z;
}

std::optional<Pose> pose_in(const Scene& scene, ObjectId id) {
  const Object& object = scene.at(id);
  return object.placed ? std::optional(object.pose) : std::nullopt;
}

}  // namespace

void MotionFilm::Actor::set(double time, const std::optional<Pose>& pose) {
  if (!keys.empty() && keys.back().first >= time)
    keys.back().second = pose;
  else
    keys.emplace_back(time, pose);
}

MotionFilm::MotionFilm(const Scene& start) {
  meet(start);
  for (const ObjectId id : start.ids()) m_actors.at(id_of(id)).set(0, pose_in(start, id));
  m_time = kPause;
}

void MotionFilm::meet(const Scene& scene) {
  m_box.extend(scene.box());
  for (const ObjectId id : scene.ids()) {
    const Object& object = scene.at(id);
    const auto [it, is_new] = m_actors.try_emplace(id_of(id));
    if (!is_new) {
      it->second.name = object.name;  // it may have another one now
      continue;
    }
    const double radius = 0.5 * object.scale * object.shape->box.diagonal();
    std::shared_ptr<const Model> model = object.model;
    if (!model) {
      std::shared_ptr<const Model>& made = m_models[object.shape.get()];
      if (!made) made = std::make_shared<const Model>(model_of_mesh(object.shape->mesh));
      model = made;
    }
    it->second = {object.name, model, object.shape, object.up, object.scale, radius, {}};
    it->second.set(0, std::nullopt);
  }
}

void MotionFilm::add(const Scene& after, const Operation& operation,
                     const OperationResult& result) {
  if (!result.ok()) return;
  meet(after);
  const double begin = m_time;
  const auto id = after.find(object_name(operation));
  if (id && after.at(*id).placed && !result.steps.empty()) {
    Actor& actor = m_actors.at(id_of(*id));
    std::optional<Pose> start = start_of_put(operation, result, result.steps);
    if (!start) start = actor.pose();
    if (start) follow(actor, *start, after, after.at(*id), result);
  }
  if (arrive(after) || m_time > begin) m_time += kPause;
}

void MotionFilm::add(const Scene& after) {
  meet(after);
  if (arrive(after)) m_time += kPause;
}

void MotionFilm::follow(Actor& actor, const Pose& start, const Scene& after, const Object& object,
                        const OperationResult& result) {
  std::vector<std::pair<Actor*, Pose>> loads;
  for (const std::string& name : result.carried)
    if (const auto id = after.find(name)) {
      Actor& load = m_actors.at(id_of(*id));
      load.hold(m_time);
      if (load.pose()) loads.emplace_back(&load, *load.pose());
    }
  actor.hold(m_time);
  if (actor.pose() && !is_same(actor.pose(), start)) m_time += kFrame;  // taken into the hand
  actor.set(m_time, start);
  Pose from = start;
  const auto go = [&](const Pose& to, bool falls) {
    const double length = path_length(from, to, actor.radius);
    if (!(length > kLeastLength)) return;
    const double seconds = fall_time(length);
    const int frames = num_frames(seconds, turn_between(from, to));
    for (int k = 1; k <= frames; ++k) {
      const double part = double(k) / frames;
      const Pose now = k == frames ? to : interpolate_pose(from, to, falls ? part * part : part);
      actor.set(m_time + part * seconds, now);
      for (const auto& [load, load_start] : loads)
        load->set(m_time + part * seconds, carried_pose(now, start, load_start));
    }
    m_time += seconds;
    from = to;
  };
  for (const SettleStep& step : result.steps)
    go(step.pose_after, step.kind == SettleStep::Kind::Fall);
  go(object.pose, false);
}

bool MotionFilm::arrive(const Scene& after) {
  std::vector<std::pair<Actor*, Pose>> moving;
  double seconds = 0, turn = 0;
  bool changed = false;
  std::map<ActorId, std::optional<Pose>> poses;
  for (const ObjectId id : after.ids()) poses[id_of(id)] = pose_in(after, id);
  for (auto& [id, actor] : m_actors) {
    const auto found = poses.find(id);
    const std::optional<Pose> pose = found == poses.end() ? std::nullopt : found->second;
    if (is_same(pose, actor.pose())) continue;
    changed = true;
    if (!pose || !actor.pose()) {
      actor.set(m_time, pose);
      continue;
    }
    moving.emplace_back(&actor, *pose);
    seconds = std::max(seconds, fall_time(path_length(*actor.pose(), *pose, actor.radius)));
    turn = std::max(turn, turn_between(*actor.pose(), *pose));
  }
  const int frames = num_frames(seconds, turn);
  for (auto& [actor, to] : moving) {
    actor->hold(m_time);
    const Pose from = *actor->pose();
    for (int k = 1; k <= frames; ++k)
      actor->set(m_time + seconds * k / frames,
                 k == frames ? to : interpolate_pose(from, to, double(k) / frames));
  }
  m_time += seconds;
  return changed;
}

std::vector<MotionFilm::Seen> MotionFilm::at(double time) const {
  std::vector<Seen> out;
  out.reserve(m_actors.size());
  for (const auto& [id, actor] : m_actors) {
    const auto later = std::upper_bound(actor.keys.begin(), actor.keys.end(), time,
                                        [](double t, const Key& key) { return t < key.first; });
    const Key& now = later == actor.keys.begin() ? *later : *(later - 1);
    if (!now.second) continue;
    Pose pose = *now.second;
    if (later != actor.keys.end() && later->second && time > now.first)
      pose = interpolate_straight(pose, *later->second,
                                  (time - now.first) / (later->first - now.first));
    out.push_back({actor.model, world_from_object(pose, actor.up, actor.scale)});
  }
  return out;
}

std::string MotionFilm::glb() const {
  AnimatedScene scene;
  scene.origin = export_origin(m_box);
  for (const auto& [id, actor] : m_actors) {
    AnimatedObject object{{actor.name, actor.model, {}, {}}, {}};
    bool is_seen = false;
    object.keys.reserve(actor.keys.size());
    for (const auto& [time, pose] : actor.keys) {
      AnimationKey key{time, !pose, {}};
      if (pose) key.world_from_file = world_from_object(*pose, actor.up, actor.scale);
      if (pose && !is_seen) object.object.world_from_object = key.world_from_file;
      is_seen |= pose.has_value();
      object.keys.push_back(key);
    }
    if (is_seen) scene.objects.push_back(std::move(object));
  }
  return animated_glb(scene);
}

}  // namespace trivet
