// Models as CGAL and OpenMesh read them: mesh_readers < PATHS. A line of JSON for each path and
// reader: triangles, area, volume and box, or the error. A process for each, as the readers trust
// their files.
#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/Simple_cartesian.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cmath>
#include <functional>
#include <iostream>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#ifdef TRIVET_TEST_OPENMESH
#include <OpenMesh/Core/IO/MeshIO.hh>
#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>
#endif

namespace {

using Point = CGAL::Simple_cartesian<double>::Point_3;
using Vector = CGAL::Simple_cartesian<double>::Vector_3;
using Polygons = std::vector<std::vector<Point>>;
using Json = nlohmann::json;

double largest(const Vector& v) {
  return std::max({std::abs(v.x()), std::abs(v.y()), std::abs(v.z())});
}

/// Measures as reader.py: polygons have their vector area; `bent` counts those without a plane.
class Surface {
 public:
  void add(const std::vector<Point>& corners) {
    if (corners.size() < 3) return;
    Vector total(0, 0, 0);
    for (size_t i = 1; i + 1 < corners.size(); ++i) {
      const Vector n = CGAL::cross_product(corners[i] - corners[0], corners[i + 1] - corners[0]);
      total = total + n;
      m_volume += n * (corners[0] - CGAL::ORIGIN) / 6;
    }
    m_num_triangles += corners.size() - 2;
    const double area = std::sqrt(total.squared_length()) / 2;
    m_area += area;
    extend(corners);
    if (corners.size() > 3) m_num_bent += is_bent(corners, total, area);
  }

  Json json() const {
    return {{"triangles", m_num_triangles}, {"area", m_area},   {"volume", m_volume},
            {"bent", m_num_bent},           {"lower", m_lower}, {"upper", m_upper}};
  }

 private:
  void extend(const std::vector<Point>& corners) {
    for (const Point& p : corners)
      for (int i = 0; i < 3; ++i) {
        const auto k = static_cast<size_t>(i);
        m_lower[k] = std::min(m_lower[k], p[i]);
        m_upper[k] = std::max(m_upper[k], p[i]);
      }
  }

  static bool is_bent(const std::vector<Point>& corners, const Vector& total, double area) {
    double size = 0, off = 0;
    for (const Point& p : corners)
      for (const Point& q : corners) size = std::max(size, largest(p - q));
    for (const Point& p : corners)
      off = std::max(off, std::abs(total * (p - corners[0])) / (2 * area));
    return !(area > 0) || off > 1e-6 * size;
  }

  size_t m_num_triangles = 0, m_num_bent = 0;
  double m_area = 0, m_volume = 0;
  std::vector<double> m_lower{1e300, 1e300, 1e300}, m_upper{-1e300, -1e300, -1e300};
};

bool by_cgal(const std::string& path, Surface& out) {
  std::vector<Point> points;
  std::vector<std::vector<size_t>> faces;
  if (!CGAL::IO::read_polygon_soup(path, points, faces)) return false;
  std::vector<Point> corners;
  for (const auto& face : faces) {
    corners.clear();
    for (const size_t v : face) corners.push_back(points.at(v));
    out.add(corners);
  }
  return true;
}

#ifdef TRIVET_TEST_OPENMESH
struct InDouble : OpenMesh::DefaultTraits {
  using Point = OpenMesh::Vec3d;
};

bool by_openmesh(const std::string& path, Surface& out) {
  OpenMesh::PolyMesh_ArrayKernelT<InDouble> mesh;
  if (!OpenMesh::IO::read_mesh(mesh, path)) return false;
  std::vector<Point> corners;
  for (const auto face : mesh.faces()) {
    corners.clear();
    for (const auto v : mesh.fv_range(face)) {
      const OpenMesh::Vec3d& p = mesh.point(v);
      corners.emplace_back(p[0], p[1], p[2]);
    }
    out.add(corners);
  }
  return true;
}
#endif

using Reader = std::function<bool(const std::string&, Surface&)>;

std::string answer(const Reader& reader, const std::string& path) {
  Surface surface;
  try {
    if (reader(path, surface)) return surface.json().dump();
    return R"({"error":"refused"})";
  } catch (const std::exception& e) {
    return Json{{"error", e.what()}}.dump(-1, ' ', true, Json::error_handler_t::replace);
  }
}

// "" if the reader ends its process.
std::string answer_of_child(const Reader& reader, const std::string& path) {
  int ends[2];
  if (pipe(ends) != 0) return "";
  const pid_t child = fork();
  if (child == 0) {
    alarm(60);
    const int silence = dup(STDERR_FILENO);
    dup2(silence, STDOUT_FILENO);  // readers print
    const std::string line = answer(reader, path);
    const bool whole = write(ends[1], line.data(), line.size()) == ssize_t(line.size());
    _exit(whole ? 0 : 1);
  }
  close(ends[1]);
  std::string out(1 << 16, '\0');
  size_t size = 0;
  for (ssize_t n = 0; (n = read(ends[0], out.data() + size, out.size() - size)) > 0;)
    size += static_cast<size_t>(n);
  close(ends[0]);
  waitpid(child, nullptr, 0);
  out.resize(size);
  return out;
}

}  // namespace

int main() {
  const std::vector<std::pair<std::string, Reader>> readers = {
      {"CGAL", by_cgal},
#ifdef TRIVET_TEST_OPENMESH
      {"OpenMesh", by_openmesh},
#endif
  };
  for (std::string path; std::getline(std::cin, path);)
    for (const auto& [name, reader] : readers) {
      const std::string line = answer_of_child(reader, path);
      Json found = line.empty() ? Json{{"error", "ended its process"}} : Json::parse(line);
      found["reader"] = name;
      found["file"] = path;
      std::cout << found.dump() << std::endl;
    }
}
