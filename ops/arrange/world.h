// An arrangement on its scene: things with their poses and outlines, what stands, where things may
// land. The scene changes through one transaction.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "core/base/sentence.h"
#include "core/scene/transaction.h"
#include "ops/arrange/arrangement.h"
#include "ops/arrange/outline.h"
#include "ops/arrange/place_field.h"
#include "ops/arrange/shape_facts.h"
#include "ops/base/context.h"
#include "ops/base/interrupt.h"
#include "ops/base/options.h"
#include "ops/base/outcome.h"
#include "ops/operations/operations.h"

namespace trivet {

/// Parts that an arrangement is made with.
struct ArrangeSetting {
  SettleOptions settle;
  RunContext context;
  Interrupt* interrupt = nullptr;  // of the whole arrangement; nullptr: it goes on to its end
  ShapeFacts* facts = nullptr;     // that attempts share; nullptr: the world's own
};

/// Thrown by World::check_interrupt(), and caught where an arrangement is given up.
struct ArrangeStopped {};

/// A pose that a thing may have, before it is turned about z.
struct Rest {
  Rotation rotation;
  Outline outline;        // at the origin
  std::vector<Vec3> rim;  // rim_of() it
};

/// A thing with what does not depend on places.
struct ThingModel {
  const Thing* thing = nullptr;
  ObjectId id;
  std::vector<Rest> rests;
  std::vector<Vec3> points;       // hull_points()
  Vec3 front;                     // in the model's frame after its up axis
  std::vector<size_t> relations;  // that name it
  double area = 0;                // of its outline in the first pose, square metres
};

class World {
 public:
  /// Things that stand already are taken out of the scene.
  /// @throws Error (BadInput): unknown or fixed things, no support, cycles of supports, poses that
  ///   there are not, and so on.
  World(Transaction& transaction, const Arrangement& arrangement, const ArrangeSetting& setting);

  /// Changes that are taken back unless they are committed; nests.
  class Trial {
   public:
    explicit Trial(World& world)
        : m_world(world), m_before(world.m_transaction), m_transaction(*m_before) {
      m_world.m_transaction = &m_transaction;
    }
    ~Trial() { m_world.m_transaction = m_before; }
    Trial(const Trial&) = delete;
    Trial& operator=(const Trial&) = delete;
    void commit() { m_transaction.commit(); }

   private:
    World& m_world;
    Transaction* m_before;
    Transaction m_transaction;
  };

  const Scene& scene() const { return m_transaction->scene(); }
  OperationResult perform(const Operation& operation);
  const Arrangement& arrangement() const { return m_arrangement; }
  const ArrangeSetting& setting() const { return m_setting; }
  /// For loops that take long. @throws ArrangeStopped.
  void check_interrupt() const {
    if (m_setting.interrupt && m_setting.interrupt->reason()) throw ArrangeStopped{};
  }
  const std::vector<ThingModel>& things() const { return m_things; }
  /// Index of a thing; -1: it is none.
  int thing_of(const std::string& name) const;
  const Object& object(const ThingModel& thing) const { return scene().at(thing.id); }

  bool stands(const std::string& name) const;
  /// Outline of an object in the scene.
  Outline outline(const std::string& name) const;
  Outline outline(const ThingModel& thing, const Pose& pose) const;
  /// Outline of a thing at the origin, turned about z.
  Outline outline(const ThingModel& thing, const Rest& rest, const Rotation& turn) const;
  /// In the scene, in the scene's order.
  std::vector<ObjectId> standing() const;

  /// The relation that says what carries a thing; nullptr: the floor does.
  const Relation* support_of(const ThingModel& thing) const;
  /// Ways down for a thing of this height. None: `why_none` says why.
  std::vector<Landing> landings(const ThingModel& thing, double height, Sentence& why_none) const;
  /// Surfaces of an object in the scene.
  const std::vector<SupportSurface>& surfaces(const std::string& name) const;
  /// Number of levels of an object that stands, or of a thing that has one pose alone; nullopt: it
  /// is not known before the thing stands.
  std::optional<size_t> num_levels(const std::string& name) const;

  /// The box of a zone of the arrangement, for poses of its object; in no scene.
  const Object& zone(size_t index) const { return m_zones[index]; }

  /// Metres that these two have to keep; 0: nothing is asked for.
  double keep(const std::string& a, const std::string& b) const;
  double clearance(const ThingModel& thing) const;

 private:
  ShapeFacts& facts() const { return m_setting.facts ? *m_setting.facts : *m_own_facts; }
  std::vector<Rotation> rests_of(const Thing& thing) const;
  ThingModel model_of(const Thing& thing) const;
  void check_names() const;
  void check_cycles() const;
  void check_zones() const;
  void find_hulls();
  void find_planes();
  void unplace_things();

  Transaction* m_transaction;  // the innermost
  Arrangement m_arrangement;   // with the planes of Symmetric
  ArrangeSetting m_setting;
  std::unique_ptr<ShapeFacts> m_own_facts = std::make_unique<ShapeFacts>();
  std::vector<Object> m_zones;
  std::vector<ThingModel> m_things;
  std::map<std::string, int> m_thing_of;
  std::map<std::string, std::vector<Vec3>> m_hulls;  // of what relations name and is no thing
};

/// A surface of a support as a landing for a thing of this height; nullopt: no head room.
/// @param surfaces  all of the support: a thing is not to fall to a lower one.
std::optional<Landing> landing_on(const Scene& scene, ObjectId support,
                                  const std::vector<SupportSurface>& surfaces,
                                  const SupportSurface& surface, double height, double clearance);
/// True if there is this level among so many, from below or, negative, from above; and the
/// sentence when there is not.
bool is_level(size_t count, int level);
Sentence no_such_level(const std::string& support, size_t count, int level);
/// The surface of this level, from below or, negative, from above; nullptr: there is none.
const SupportSurface* surface_at(const std::vector<SupportSurface>& surfaces, int level);

}  // namespace trivet
