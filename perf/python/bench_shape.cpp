// The C++ half of bench.py: a torus as arrays, welded and made a Shape; CPU milliseconds, a line
// for each of these, the least of some runs.
//   trivet_python_bench VERTICES FACES RUNS     files of float64 and int32, three each
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <vector>

#include "core/index/shape.h"
#include "core/mesh/weld_arrays.h"

namespace {

template <class T>
std::vector<T> read_all(const char* path) {
  std::ifstream file(path, std::ios::binary | std::ios::ate);
  std::vector<T> out(static_cast<size_t>(file.tellg()) / sizeof(T));
  file.seekg(0);
  file.read(reinterpret_cast<char*>(out.data()), static_cast<long>(out.size() * sizeof(T)));
  return out;
}

// CPU time of the process.
double milliseconds_since(std::clock_t start) {
  return 1e3 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 4) return 2;
  const auto vertices = read_all<trivet::Vec3>(argv[1]);
  const auto faces = read_all<trivet::Index3>(argv[2]);
  double weld_ms = 1e300, shape_ms = 1e300;
  for (int run = 0; run < std::atoi(argv[3]); ++run) {
    const auto start = std::clock();
    trivet::WeldedMesh welded = trivet::weld(vertices, faces);
    weld_ms = std::min(weld_ms, milliseconds_since(start));
    const auto shape = trivet::make_shape(std::move(welded.mesh));
    shape_ms = std::min(shape_ms, milliseconds_since(start));
    if (shape->mesh.triangles.size() != faces.size()) return 1;
  }
  std::printf("%.3f\n%.3f\n", weld_ms, shape_ms);
}
