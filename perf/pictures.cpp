// trivet_perf_pictures: pictures of scenes by OpenGL and by rays, processor time against error.
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <optional>
#include <string>

#include "ops/files/report/scene_file.h"
#include "perf/timing.h"
#include "raster/path/picture.h"
#ifdef TRIVET_PERF_GPU
#include "gpu/picture/picture.h"
#endif

namespace trivet::perf {
namespace {

constexpr const char* kUsage =
    "usage: trivet_perf_pictures SCENE.glb [WIDTH HEIGHT [VIEWS PATHS]]\n"
    "A table of processor seconds, of all threads, and of the root mean square difference in "
    "steps\n"
    "of 8-bit sRGB from the same renderer's picture of that many VIEWS (OpenGL) or PATHS (rays).\n";

struct Size {
  int width = 640, height = 360, views = 128, paths = 512;
};

double rmse(const Image& a, const Image& b) {
  double sum = 0;
  std::size_t count = 0;
  for (std::size_t i = 0; i < a.rgba.size(); ++i) {
    if (i % 4 == 3) continue;
    const double d = double(a.rgba[i]) - b.rgba[i];
    sum += d * d, ++count;
  }
  return std::sqrt(sum / double(count));
}

PictureOptions options_of(const Size& size, int samples) {
  PictureOptions options;
  options.width = size.width, options.height = size.height, options.samples = samples;
  return options;
}

void print_row(const std::string& what, const Took& took, std::optional<double> error) {
  std::printf("| %s | %.2f | ", what.c_str(), took.cpu_ms / 1000);
  error ? std::printf("%.2f |\n", *error) : std::printf("|\n");
  std::fflush(stdout);
}

#ifdef TRIVET_PERF_GPU
void opengl_rows(const PictureScene& scene, const Size& size) {
  EglContext context;
  const auto render = [&](int samples) {
    return render_picture(context, scene, std::nullopt, options_of(size, samples));
  };
  render(1);  // shaders are compiled
  const Image converged = render(size.views);
  for (const int samples : {4, 8, 16, 32}) {
    Image image;
    const Took took = timed([&] { image = render(samples); }, CLOCK_PROCESS_CPUTIME_ID);
    print_row("OpenGL (" + context.description() + "), " + std::to_string(samples) + " views", took,
              rmse(image, converged));
  }
}
#endif

void ray_rows(const PictureScene& scene, const Size& size, int bounces) {
  PathOptions path;
  path.bounces = bounces;
  const auto render = [&](int samples, bool filter) {
    path.filter = filter;
    return trace_picture(scene, std::nullopt, options_of(size, samples), path);
  };
  const Image converged = render(size.paths, false);
  const std::string what =
      bounces == 0 ? "rays, shadows and sky" : "rays, " + std::to_string(bounces) + " bounces";
  for (const int samples : {4, 8, 16, 32})
    for (const bool filter : {false, true}) {
      if (samples == 32 && !filter) continue;
      Image image;
      const Took took = timed([&] { image = render(samples, filter); }, CLOCK_PROCESS_CPUTIME_ID);
      print_row(what + ", " + std::to_string(samples) + (filter ? " paths, filter" : " paths"),
                took, rmse(image, converged));
    }
}

int run(int argc, char** argv) {
  if (argc != 2 && argc != 4 && argc != 6) return std::fputs(kUsage, stderr), 2;
  Size size;
  if (argc > 3) size.width = std::atoi(argv[2]), size.height = std::atoi(argv[3]);
  if (argc > 5) size.views = std::atoi(argv[4]), size.paths = std::atoi(argv[5]);
  const SceneFile file = read_scene_file(argv[1]);
  std::map<const Model*, PictureMesh> meshes;
  PictureScene scene;
  std::size_t num_triangles = 0;
  for (const ObjectId id : file.scene.ids()) {
    const Object& object = file.scene.at(id);
    const auto [mesh, is_new] = meshes.try_emplace(object.model.get());
    if (is_new) mesh->second = picture_mesh(*object.model);
    scene.objects.push_back({&mesh->second, object.world_from_object(), std::nullopt});
    num_triangles += object.model->mesh.triangles.size();
  }
  std::printf("| %s: %zu objects, %zu triangles; %d x %d | CPU s | RMSE |\n|---|--:|--:|\n",
              argv[1], scene.objects.size(), num_triangles, size.width, size.height);
#ifdef TRIVET_PERF_GPU
  opengl_rows(scene, size);
#endif
  ray_rows(scene, size, 0);
  ray_rows(scene, size, 3);
  return 0;
}

}  // namespace
}  // namespace trivet::perf

int main(int argc, char** argv) {
  try {
    return trivet::perf::run(argc, argv);
  } catch (const std::exception& e) {
    std::fprintf(stderr, "trivet_perf_pictures: %s\n", e.what());
    return 2;
  }
}
