// A cabinet with a drawer, as a layout and as a session on it.
#pragma once

#include <gtest/gtest.h>

#include "core/scene/joint.h"
#include "ops/check/check.h"
#include "ops/files/json/text.h"
#include "ops/files/layout/boxes.h"
#include "ops/files/layout/run.h"
#include "ops/session/restore.h"
#include "ops/session/session.h"

namespace trivet::test {

inline constexpr double kClearance = 2e-6;

/// Half extents about a centre.
struct Box {
  Vec3 centre, half;
};

inline Model model_of(const std::vector<Box>& boxes) {
  std::vector<Triangle> triangles;
  for (const Box& box : boxes) {
    const Mesh mesh = box_model(box.half.x(), box.half.y(), box.half.z()).mesh;
    for (Index f = 0; f < static_cast<Index>(mesh.triangles.size()); ++f) {
      Triangle t = mesh.triangle(f);
      for (Vec3& p : t) p += box.centre;
      triangles.push_back(t);
    }
  }
  Model out;
  out.format = "made";
  out.mesh = weld(triangles);
  return out;
}

/// Sides, bottom, top and back of a cabinet of 0.4 m, open in front, towards -y.
inline Model cabinet_model() {
  return model_of({{{-0.19, 0, 0.2}, {0.01, 0.2, 0.2}},
                   {{0.19, 0, 0.2}, {0.01, 0.2, 0.2}},
                   {{0, 0, 0.01}, {0.18, 0.2, 0.01}},
                   {{0, 0, 0.39}, {0.18, 0.2, 0.01}},
                   {{0, 0.19, 0.2}, {0.18, 0.01, 0.18}}});
}

/// A tray whose front stands 5 mm deep in the sides of the cabinet, as those of real assets do.
inline Model drawer_model() {
  return model_of({{{0, 0, 0.1}, {0.17, 0.17, 0.005}},
                   {{0, -0.18, 0.15}, {0.185, 0.01, 0.055}},
                   {{0, 0.165, 0.135}, {0.17, 0.005, 0.03}},
                   {{-0.165, 0, 0.135}, {0.005, 0.16, 0.03}},
                   {{0.165, 0, 0.135}, {0.005, 0.16, 0.03}}});
}

inline Model made(const std::string& name, const Tessellation&) {
  if (name == "cabinet.obj") return cabinet_model();
  if (name == "drawer.obj") return drawer_model();
  if (name == "lid.obj") return model_of({{{0, -0.1, 0.01}, {0.1, 0.1, 0.01}}});
  if (name == "flap.obj") return model_of({{{0, -0.01, 0.04}, {0.1, 0.004, 0.04}}});
  if (name == "tall.obj") return box_model(0.03, 0.03, 0.1375);
  return box_model(0.03, 0.03, 0.03);
}

inline std::string text_of(const std::string& cabinet, const std::string& drawer,
                           const std::string& more, const std::string& operations) {
  return R"({"trivet": 1, "objects": [
    {"name": "cabinet", "model": "cabinet.obj", "position": [0, 0, 0.000003])" +
         cabinet + R"(},
    {"name": "drawer", "model": "drawer.obj", "position": [0, 0, 0.000003])" +
         drawer +
         R"(, "joint": {"in": "cabinet", "slide": [0, -2, 0], "lower": 0, "upper": 0.3}})" + more +
         R"(, {"name": "cube", "model": "cube.obj"}, {"name": "tall", "model": "tall.obj"}],
    "operations": [)" +
         operations + "]}";
}

inline const std::string kOpen = R"({"op": "move_joint", "object": "drawer", "until": "upper"})";
inline const std::string kPutCube =
    R"(, {"op": "put", "object": "cube", "position": [0.02, -0.3, 0.3]})";

inline RunOptions options_of_test() {
  RunOptions options;
  options.settle.clearance = kClearance;
  return options;
}

/// A session on a layout, which has to be true at every step.
class Furnished {
 public:
  explicit Furnished(const std::string& text)
      : m_layout(parse_layout(text, "kitchen.json")),
        m_run(run_layout(m_layout, made, options_of_test())),
        m_session(m_run.scene, m_layout, made) {
    for (const OperationRecord& record : m_run.operations)
      EXPECT_TRUE(record.result.ok()) << record.result.reason();
    EXPECT_TRUE(m_run.check.ok());
  }

  Session& session() { return m_session; }
  const Scene& scene() const { return m_session.scene(); }
  const Object& at(const std::string& name) const { return scene().at(*scene().find(name)); }
  double value(const std::string& name) const { return at(name).joint->value; }

  OperationResult move(const std::string& link, std::optional<double> to,
                       std::optional<double> by = {}) {
    MoveJointOperation o;
    o.object = link, o.to = to, o.by = by;
    return done(o);
  }
  OperationResult done(const Operation& operation) {
    OperationResult result = m_session.perform(operation, options_of_test().settle);
    EXPECT_TRUE(check_scene(scene(), 1, kClearance).ok());
    return result;
  }

 private:
  Layout m_layout;
  LayoutRun m_run;
  Session m_session;
};

inline std::string fixed_kitchen(const std::string& operations = kOpen + kPutCube) {
  return text_of(R"(, "fixed": true)", "", "", operations);
}

}  // namespace trivet::test
