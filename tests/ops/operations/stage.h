// A scene for operations, and invariants checked after each of them.
#pragma once

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <utility>

#include "core/scene/transaction.h"
#include "ops/check/check.h"
#include "ops/files/json/operations.h"
#include "ops/operations/perform.h"
#include "ops/placement/clearance.h"
#include "support/settle_options.h"
#include "support/solids.h"

namespace trivet::test {

/// Poses, states and contacts of all objects, bit for bit.
inline std::string snapshot(const Scene& scene) {
  std::string out;
  const auto add = [&](const auto& value) { out += nlohmann::json(value).dump() + " "; };
  for (const ObjectId id : scene.ids()) {
    const Object& o = scene.at(id);
    const Vec3& t = o.pose.translation;
    const Rotation& r = o.pose.rotation;
    out += "\n" + o.name + " " + to_string(o.state) + " ";
    for (const double x : {t.x(), t.y(), t.z(), r.w, r.x, r.y, r.z, o.stability_margin}) add(x);
    for (const ObjectContact& entry : o.contacts) {
      out += named(scene, entry.with).name + " ";
      for (const ContactPoint& p : entry.contact.points)
        for (const double x : {p.point.x(), p.point.y(), p.point.z(), p.normal.z(), p.gap}) add(x);
    }
  }
  return out;
}

/// Load-support list as text.
inline std::string loads_text(const Scene& scene) {
  std::string out;
  for (const LoadSupport::Entry& e : load_support(scene).entries) {
    out += scene.at(e.object).name + (e.on_floor ? " on floor" : "");
    for (const ObjectId id : e.supports) out += " on " + scene.at(id).name;
    for (const ObjectId id : e.loads) out += " under " + scene.at(id).name;
    out += "; ";
  }
  return out;
}

class Stage {
 public:
  Scene scene;
  SettleOptions options;  // of put() and run()

  /// Adds a fixed object at this position.
  ObjectId fix(const std::string& name, const Triangles& triangles, const Vec3& at = Vec3::Zero()) {
    const ObjectId id = scene.add(object_of(name, triangles, true));
    const OperationResult result = stand(scene, id, {{}, at});
    EXPECT_TRUE(result.ok()) << result.reason();
    return id;
  }

  ObjectId put(const std::string& name, const Triangles& triangles, const Vec3& from,
               const Rotation& rotation = {}) {
    const ObjectId id = scene.add(object_of(name, triangles));
    const OperationResult result = trivet::put(scene, id, {rotation, from}, options);
    EXPECT_TRUE(result.ok()) << result.reason();
    return id;
  }

  const Object& at(const std::string& name) const { return scene.at(*scene.find(name)); }
  template <class Change>
  void edit(const std::string& name, const Change& change) {
    edit_object(scene, *scene.find(name), change);
  }
  Vec3 position(const std::string& name) const { return at(name).pose.translation; }
  double clearance() const { return default_clearance(scene); }

  /// Performs the operation and checks the invariants: if refused, no change; if done, no
  /// interpenetration, objects not at rest are reported so, and the contacts equal those computed
  /// afresh.
  OperationResult run(const Operation& operation) {
    const std::string before = snapshot(scene);
    OperationResult result = perform(scene, operation, options);
    if (!result.ok()) {
      EXPECT_NE(result.reason(), "");
      EXPECT_EQ(snapshot(scene), before);
      return result;
    }
    check(result);
    return result;
  }

  OperationResult refused(const Operation& operation, const std::string& reason) {
    OperationResult result = run(operation);
    EXPECT_FALSE(result.ok());
    EXPECT_NE(result.reason().find(reason), std::string::npos) << result.reason();
    return result;
  }

 private:
  void check(const OperationResult& result) const {
    const SceneCheck found = check_scene(scene, 1, 0, options);
    if (result.interpenetrates.empty()) {
      EXPECT_EQ(found.interpenetrating_pairs(), 0);
      EXPECT_TRUE(found.float32_crossings.empty() && found.contained.empty());
    }
    for (const ObjectId id : scene.ids()) {
      const Object& o = scene.at(id);
      const bool rests = std::find(found.not_at_rest.begin(), found.not_at_rest.end(), o.name) ==
                         found.not_at_rest.end();
      if (!o.placed || o.fixed) continue;
      if (o.state == ObjectState::Stable) {
        EXPECT_TRUE(rests) << o.name;
      }
      if (o.state == ObjectState::Unsupported || o.state == ObjectState::Held) {
        EXPECT_FALSE(rests) << o.name;
      }
    }
    if (!result.interpenetrates.empty()) return;
    Scene anew = scene;
    update_contacts(anew, 0, options);
    EXPECT_EQ(loads_text(scene), loads_text(anew));
  }
};

}  // namespace trivet::test
