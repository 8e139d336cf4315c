#include "perf/scale.h"

#include <stdexcept>

#include "core/scene/transaction.h"
#include "ops/check/check.h"
#include "ops/operations/perform.h"
#include "tests/support/settle_options.h"

namespace trivet::perf {
namespace {

constexpr int kRepetitions = 31;

}  // namespace

SettleOptions scale_options() {
  SettleOptions out = test::perfect_friction();
  out.clearance = kScaleClearance;
  return out;
}

PushOperation push_of(const std::string& name, double distance) {
  PushOperation push;
  push.object = name;
  push.distance = distance;
  return push;
}

Samples repeated(Scene& scene, const Operation& operation, ResultHash& hash) {
  Samples samples;
  for (int i = 0; i < kRepetitions; ++i) {
    Transaction trial(scene);
    OperationResult result;
    const Took took = timed([&] { result = perform(trial, operation, scale_options()); });
    if (!result.ok()) throw std::runtime_error(result.reason());
    hash.add(scene.at(*scene.find(object_name(operation))).pose);
    trial.rollback();
    samples.add(took);
  }
  return samples;
}

Samples session_steps(Session& session, const std::string& name) {
  Samples samples;
  const PushOperation push = push_of(name, 0.01);
  for (int i = 0; i < kRepetitions; ++i) {
    OperationResult result;
    samples.add(timed([&] { result = session.perform(push, scale_options()); }));
    if (!result.ok()) throw std::runtime_error(result.reason());
    session.undo();
  }
  return samples;
}

Row check_row(const Scene& scene) {
  Samples check;
  SceneCheck found;
  check.add(timed([&] { found = check_scene(scene, 1, kScaleClearance); }));
  const std::string findings =
      text("FALSE: %zu pairs cross, %zu in float32, %zu contained, %zu objects not at rest",
           found.crossings.size(), found.float32_crossings.size(), found.contained.size(),
           found.not_at_rest.size());
  return {"check", check, 0, 0, found.ok() ? "true" : findings};
}

}  // namespace trivet::perf
