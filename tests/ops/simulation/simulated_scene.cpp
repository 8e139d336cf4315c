#include "ops/simulation/simulated_scene.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include "apps/demo/shapes/models.h"
#include "core/scene/transaction.h"
#include "ops/check/check.h"
#include "ops/files/layout/boxes.h"
#include "ops/operations/perform.h"
#include "support/solids.h"

namespace trivet::test {
namespace {

class Maker {
 public:
  ObjectId add(const std::string& name, const Model& model) {
    Object object;
    object.name = name;
    object.model = std::make_shared<const Model>(model);
    object.shape = make_shape(model.mesh);
    return m_out.scene.add(std::move(object));
  }

  void stand(const std::string& name, const Model& model, const Vec3& at) {
    const ObjectId id = add(name, model);
    edit_object(m_out.scene, id, [](Object& o) { o.fixed = true; });
    EXPECT_TRUE(trivet::stand(m_out.scene, id, {{}, at}).ok());
  }

  void put(const std::string& name, const Model& model, const Pose& start) {
    const OperationResult result = trivet::put(m_out.scene, add(name, model), start);
    EXPECT_TRUE(result.ok()) << result.reason();
    m_out.starts.push_back({name, start});
  }

  LaidOut take() {
    update_contacts(m_out.scene);
    return std::move(m_out);
  }

 private:
  LaidOut m_out;
};

}  // namespace

Model open_box(double half, double height, double wall) {
  std::vector<Triangle> triangles;
  const auto add_box = [&](const Vec3& size, const Vec3& at) {
    for (const Triangle& t : moved(box_triangles(size), at)) triangles.push_back(t);
  };
  const double out = half + wall;
  add_box(Vec3(out, out, wall / 2), Vec3(0, 0, -wall / 2));
  for (const double side : {-1.0, 1.0}) {
    add_box(Vec3(wall / 2, out, height / 2), Vec3(side * (half + wall / 2), 0, height / 2));
    add_box(Vec3(out, wall / 2, height / 2), Vec3(0, side * (half + wall / 2), height / 2));
  }
  Model model = box_model(1, 1, 1);
  model.mesh = weld(triangles);
  model.face_material.assign(triangles.size(), 0);
  return model;
}

Model hull_model(const Model& model) {
  ConvexPart part;
  solid_hull(model.mesh.vertices, part);
  Model out;
  out.mesh.vertices = part.vertices;
  out.mesh.triangles = part.triangles;
  out.materials = {model.materials.at(0)};
  return out;
}

LaidOut convex_objects() {
  Maker maker;
  maker.stand("table", box_model(0.6, 0.4, 0.02), Vec3(0, 0, 0.5));
  const Rotation turned = Rotation::about_axis(Vec3::UnitZ(), 0.2);
  const Rotation tilted = Rotation::about_axis(Vec3::UnitX(), 0.1) * turned;
  const char* const books[] = {"book_red", "book_blue", "book_green", "book_yellow"};
  double height = 0.7;
  for (const char* book : books) {
    maker.put(book, hull_model(shapes::make_model(book)), {turned, Vec3(-0.35, 0, height)});
    height += 0.4;
  }
  const Model plate = hull_model(shapes::make_plate());
  for (int i = 0; i < 3; ++i)
    maker.put("plate " + std::to_string(i), plate, {{}, Vec3(0.1, 0.02 * i - 0.1, 0.8 + 0.1 * i)});
  for (int i = 0; i < 3; ++i)  // a tower
    maker.put("box " + std::to_string(i), box_model(0.06, 0.05, 0.04),
              {i == 1 ? turned : Rotation{}, Vec3(0.4, 0.15, 0.8 + 0.1 * i)});
  // Leans from the edge of a box down to the table.
  maker.put("leaning", box_model(0.12, 0.03, 0.004), {tilted, Vec3(0.4, 0.05, 0.9)});
  maker.put("on floor", box_model(0.1, 0.2, 0.15), {tilted, Vec3(1, 0, 1)});
  maker.put("on floor, too", box_model(0.1, 0.1, 0.1), {tilted, Vec3(1.02, 0.1, 1)});
  maker.put("plate on floor", plate, {tilted, Vec3(0, 1, 1)});
  return maker.take();
}

}  // namespace trivet::test
