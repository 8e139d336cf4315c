// A bin, what falls into it, and plans and refusals of tries.
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "ops/operations/arrangements.h"
#include "ops/operations/perform.h"
#include "ops/operations/stage.h"
#include "ops/operations/tries.h"

namespace trivet::test {

/// A box open above: inner edges of `edge`, walls of `wall`; its floor is as thick.
inline Triangles bin(double edge, double height, double wall) {
  const double in = edge / 2, out = in + wall;
  Triangles all = box_between({-out, -out, 0}, {out, out, wall});
  for (const auto& [lower, upper] : {std::pair{Vec3(-out, -out, wall), Vec3(out, -in, height)},
                                     {Vec3(-out, in, wall), Vec3(out, out, height)},
                                     {Vec3(-out, -in, wall), Vec3(-in, in, height)},
                                     {Vec3(in, -in, wall), Vec3(out, in, height)}})
    all = joined(all, box_between(lower, upper));
  return all;
}

inline ObjectId add_at(Scene& scene, const std::string& name, const Triangles& triangles,
                       const Vec3& at, bool fixed) {
  const ObjectId id = scene.add(object_of(name, triangles, fixed));
  EXPECT_TRUE(stand(scene, id, {{}, at}).ok());
  return id;
}

/// Balls let go over a bin, at 0.1 of its edge from the middle.
/// @param detector  null: BVHs.
inline int num_in_bin(int num, int tries, std::string& poses, Detector* detector = nullptr) {
  Scene scene;
  add_at(scene, "bin", bin(0.3, 0.3, 0.01), {0, 0, 1e-4}, true);
  int done = 0;
  for (int i = 0; i < num; ++i) {
    const std::string name = "ball " + std::to_string(i);
    const ObjectId id = scene.add(object_of(name, ball(0.045, 8, 12)));
    const Vec3 at(0.03 * (i % 3 - 1), 0.03 * (i / 3 % 3 - 1), 0.4 + 0.01 * i);
    PutOperation put{{name}, {{}, at}};
    put.tries = tries;
    RunContext context;
    context.detector = detector;
    const OperationResult result = perform(scene, put, {}, context);
    done += result.ok();
    EXPECT_TRUE(!result.tried || (2 <= result.tried->number && result.tried->number <= tries));
    if (!result.ok()) continue;
    EXPECT_LT(scene.at(id).centre_of_mass().head<2>().cwiseAbs().maxCoeff(), 0.15) << name;
  }
  poses = snapshot(scene);
  return done;
}

/// A plan that ends where it starts.
inline MovePlan plan_at_start(const Scene&, const PutOperation& put, OperationRun&) {
  MovePlan plan;
  plan.result.steps = {{SettleStep::Kind::Fall, put.start, 0}};
  return plan;
}

inline OperationResult topples() {
  return refused({Refusal::Cause::Topples, {}, {{"friction", 0.5}}});
}
inline OperationResult wedged() { return refused({Refusal::Cause::Wedged}); }
inline OperationResult blocked() {
  Refusal why{Refusal::Cause::Crossing};
  why.at = Refusal::At::Start;
  return refused(why);
}

}  // namespace trivet::test
