// A client program: puts a box on the floor and prints its height.
#include <cstdio>

#include "trivet.h"

namespace {

/// A closed box of 12 triangles about the origin.
trivet::Mesh box_mesh(const trivet::Vec3& half) {
  const auto corner = [&](int i) {
    return trivet::Vec3(i & 1 ? half.x() : -half.x(), i & 2 ? half.y() : -half.y(),
                        i & 4 ? half.z() : -half.z());
  };
  constexpr int kSides[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  std::vector<trivet::Triangle> triangles;
  for (const auto& [a, b, c, d] : kSides) {
    triangles.push_back({corner(a), corner(b), corner(c)});
    triangles.push_back({corner(a), corner(c), corner(d)});
  }
  return trivet::weld(triangles);
}

}  // namespace

int main() {
  auto model = std::make_shared<trivet::Model>();
  model->mesh = box_mesh({0.3, 0.2, 0.1});
  trivet::Object object;
  object.name = "box";
  object.shape = trivet::make_shape(model->mesh);
  object.model = model;

  trivet::Scene scene;
  const trivet::ObjectId box = scene.add(object);
  trivet::Pose start;
  start.translation.z() = 0.5;
  const trivet::OperationResult result = trivet::put(scene, box, start);
  if (!result.ok()) {
    std::fprintf(stderr, "refused: %s\n", result.reason().c_str());
    return 1;
  }
  const double height = scene.at(box).pose.translation.z();
  std::printf("The centre of the box is %.9f m above the floor.\n", height);
  return height > 0.1 && height < 0.100001 ? 0 : 1;
}
