// A film of operations: what moves when, recorded while they are done, as an animated .glb.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/scene/scene.h"
#include "ops/base/outcome.h"
#include "ops/operations/operations.h"

namespace trivet {

/// The object of an operation goes the way that was executed, motion by motion; its loads go with
/// it; then whatever else moved (loads that settled, what gave way) goes to where it is now, all at
/// once. A motion takes as long as a fall of its length. Objects are hidden while they are out of
/// the scene.
class MotionFilm {
 public:
  explicit MotionFilm(const Scene& start);

  /// An operation was done. @param result  with its steps; one that was refused changes nothing.
  void add(const Scene& after, const Operation& operation, const OperationResult& result);
  /// The scene changed in another way.
  void add(const Scene& after);

  double seconds() const { return m_time; }
  /// An object in the scene at some time.
  struct Seen {
    std::shared_ptr<const Model> model;  // never null
    Affine world_from_object;
  };
  /// @param time  seconds; before the first key the start, after the last one the end.
  std::vector<Seen> at(double time) const;
  /// @throws Error (BadInput) as animated_glb().
  std::string glb() const;

 private:
  using Key = std::pair<double, std::optional<Pose>>;  // time; no pose: out of the scene
  struct Actor {
    std::string name;
    std::shared_ptr<const Model> model;
    std::shared_ptr<const Shape> shape;
    UpAxis up = UpAxis::Z;
    double scale = 1, radius = 0;  // metres; half its diagonal
    std::vector<Key> keys;         // one at least, times ascending

    const std::optional<Pose>& pose() const { return keys.back().second; }
    void set(double time, const std::optional<Pose>& pose);
    void hold(double time) { set(time, pose()); }
  };
  using ActorId = std::pair<std::uint32_t, std::uint32_t>;
  static ActorId id_of(ObjectId id) { return {id.index, id.generation}; }

  void meet(const Scene& scene);
  void follow(Actor& actor, const Pose& start, const Scene& after, const Object& object,
              const OperationResult& result);
  bool arrive(const Scene& after);

  std::map<ActorId, Actor> m_actors;
  std::map<const Shape*, std::shared_ptr<const Model>> m_models;  // of objects without one
  Aabb m_box;
  double m_time = 0;
};

}  // namespace trivet
