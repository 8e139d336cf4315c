#include "perf/scenes.h"

#include <cmath>
#include <stdexcept>

#include "apps/demo/demo.h"
#include "ops/files/layout/run.h"
#include "ops/operations/perform.h"

namespace trivet::perf {
namespace {

constexpr double kHalf = 0.70710678118654752;

// Point k of n on an edge, with the same bits from either end.
Vec3 on_edge(const Mesh& mesh, Index from, Index to, int k, int n) {
  if (from > to) return on_edge(mesh, to, from, n - k, n);
  if (k == n) return mesh.vertices[to];
  const Vec3 &p = mesh.vertices[from], &q = mesh.vertices[to];
  return p + (q - p) * (static_cast<double>(k) / n);
}

// Grid point i steps towards b and j towards c.
Vec3 grid_point(const Mesh& mesh, const Index3& t, int i, int j, int n) {
  if (j == 0) return on_edge(mesh, t[0], t[1], i, n);
  if (i == 0) return on_edge(mesh, t[0], t[2], j, n);
  if (i + j == n) return on_edge(mesh, t[1], t[2], j, n);
  const Vec3 &a = mesh.vertices[t[0]], &b = mesh.vertices[t[1]], &c = mesh.vertices[t[2]];
  return a + ((b - a) * i + (c - a) * j) / n;
}

Model refined_model(const Model& model, int splits) {
  Model out = model;
  out.mesh = refined(model.mesh, splits);
  out.corner_normals.clear();
  out.face_material.clear();
  for (const Index material : model.face_material)
    out.face_material.insert(out.face_material.end(), static_cast<size_t>(splits * splits),
                             material);
  return out;
}

}  // namespace

const std::array<Vec2, 8> kPushDirections{{{1, 0},
                                           {kHalf, kHalf},
                                           {0, 1},
                                           {-kHalf, kHalf},
                                           {-1, 0},
                                           {-kHalf, -kHalf},
                                           {0, -1},
                                           {kHalf, -kHalf}}};

Mesh refined(const Mesh& mesh, int splits) {
  if (splits == 1) return mesh;
  std::vector<Triangle> out;
  for (const Index3& t : mesh.triangles)
    for (int i = 0; i < splits; ++i)
      for (int j = 0; i + j < splits; ++j) {
        const auto at = [&](int x, int y) { return grid_point(mesh, t, x, y, splits); };
        out.push_back({at(i, j), at(i + 1, j), at(i, j + 1)});
        if (i + j + 1 < splits) out.push_back({at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
      }
  return weld(out);
}

DemoScene make_demo_scene(const std::string& name, int splits) {
  const DemoLayout demo = make_demo(name);
  const ModelSource source = [&](const std::string& file, const Tessellation&) {
    return splits == 1 ? demo.model(file) : refined_model(demo.model(file), splits);
  };
  DemoScene out{make_scene(demo.layout, source, RunOptions{}), {}, 0};
  for (const Operation& operation : demo.layout.operations)
    out.operations.push_back(std::get<PutOperation>(operation));
  for (const LayoutObject& object : demo.layout.objects) {
    const ObjectId id = *out.scene.find(object.name);
    const Shape& shape = *out.scene.at(id).shape;
    shape.bvh();  // not timed
    out.num_triangles += static_cast<std::int64_t>(shape.mesh.triangles.size());
    if (object.pose && !stand(out.scene, id, *object.pose).ok())
      throw std::runtime_error(object.name + " cannot be placed in " + name);
  }
  return out;
}

int splits_for(const DemoScene& demo, std::int64_t num_triangles) {
  const double factor =
      static_cast<double>(num_triangles) / static_cast<double>(demo.num_triangles);
  return static_cast<int>(std::ceil(std::sqrt(std::max(1.0, factor))));
}

Pose random_start(const Pose& start, double jitter, test::Random& random) {
  const double x = random.uniform(-jitter, jitter), y = random.uniform(-jitter, jitter);
  return {random.rotation(), start.translation + Vec3(x, y, 0)};
}

}  // namespace trivet::perf
