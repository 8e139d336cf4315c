#include <tbb/global_control.h>

#include <filesystem>
#include <random>

#include "core/base/error.h"
#include "core/io/export.h"
#include "core/io/read_model.h"
#include "perf/result_hash.h"
#include "perf/rows.h"
#include "perf/sweeps.h"

namespace trivet::perf {
namespace {

namespace fs = std::filesystem;

template <class T>
size_t bytes(const std::vector<T>& v) {
  return v.capacity() * sizeof(T);
}
template <class T>
size_t bytes(const Rows<T>& rows) {
  return bytes(rows.offsets) + bytes(rows.items);
}

struct ShapeBytes {
  size_t mesh, adjacency, bvh;

  explicit ShapeBytes(const Shape& s)
      : mesh(bytes(s.mesh.vertices) + bytes(s.mesh.triangles)),
        adjacency(bytes(s.adjacency.edge_vertices) + bytes(s.adjacency.face_edges) +
                  bytes(s.adjacency.edge_faces) + bytes(s.adjacency.vertex_faces) +
                  bytes(s.adjacency.vertex_edges) + bytes(s.adjacency.face_component) +
                  bytes(s.adjacency.components)),
        bvh(bytes(s.bvh().nodes) + bytes(s.bvh().faces)) {}
};

int repetitions(int num_triangles) { return num_triangles >= 1'000'000 ? 5 : 30; }

template <class Work>
Samples repeated(int num_triangles, Work&& work) {
  Samples samples;
  for (int i = 0; i < repetitions(num_triangles); ++i) samples.add(timed_warm(work));
  return samples;
}

void build_rows(int n, const Mesh& mesh, Report& report) {
  const std::string size = short_count(n);
  const auto build = [&] { build_bvh(mesh); };
  report.add({"BVH, " + size + ", all cores", repeated(n, build), 0, 0,
              "CPU time is the calling thread's"});
  {
    const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    report.add({"BVH, " + size + ", one core", repeated(n, build), 0, 0, ""});
  }
  std::shared_ptr<const Shape> shape;
  Samples whole = repeated(n, [&] { shape = make_shape(mesh), shape->bvh(); });
  const ShapeBytes b(*shape);
  const auto per = [&](size_t total) { return static_cast<double>(total) / n; };
  report.add({"whole shape, " + size + ", all cores", std::move(whole), 0, 0,
              text("%.0f bytes per triangle: mesh %.0f, adjacency %.0f, BVH %.0f",
                   per(b.mesh + b.adjacency + b.bvh), per(b.mesh), per(b.adjacency), per(b.bvh))});
}

/// A temporary folder, deleted on destruction.
class TemporaryFolder {
 public:
  TemporaryFolder()
      : m_path(fs::temp_directory_path() /
               ("trivet_perf_" + std::to_string(std::random_device()()))) {
    fs::create_directories(m_path);
  }
  ~TemporaryFolder() {
    std::error_code ignored;
    fs::remove_all(m_path, ignored);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  std::string file(const std::string& name) const { return (m_path / name).string(); }

 private:
  fs::path m_path;
};

void import_rows(int n, const Mesh& mesh, Report& report) {
  auto model = std::make_shared<Model>();
  model->mesh = mesh;
  model->materials.emplace_back();
  model->face_material.assign(mesh.triangles.size(), 0);
  ExportScene scene;
  scene.objects.push_back({"sphere", model, Affine{}, ""});
  const TemporaryFolder folder;
  for (const char* extension : {"glb", "ply", "stl", "obj"}) {
    const std::string file = folder.file(std::string("sphere.") + extension);
    write_scene(scene, file);
    Model read;
    Samples samples = repeated(n, [&] { read = read_model(file); });
    report.add({"import of " + short_count(n) + " from ." + extension, std::move(samples), 0, 0,
                text("%.1f MB, %zu triangles, %zu vertices",
                     static_cast<double>(fs::file_size(file)) * 1e-6, read.mesh.triangles.size(),
                     read.mesh.vertices.size())});
  }
}

}  // namespace

void shape_rows(Report& report) {
  report.section("A model, once: index, memory, import");
  for (const int n : {10'000, 100'000, 1'000'000}) {
    const Mesh mesh = make_sphere_mesh(n, 1);
    build_rows(n, mesh, report);
    if (n == 100'000) import_rows(n, mesh, report);
  }
}

}  // namespace trivet::perf
