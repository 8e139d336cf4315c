#include "core/picture/camera_dome.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/base/bad_input.h"
#include "core/base/limits.h"
#include "core/picture/frame.h"

namespace trivet {
namespace {

/// Numbers that depend on seed and index alone. @see [Steele 2014]
class DomeNumbers {
 public:
  explicit DomeNumbers(std::uint64_t seed) : m_state(seed) {}
  double between(double lower, double upper) {
    m_state += 0x9e3779b97f4a7c15u;
    std::uint64_t z = m_state;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    z ^= z >> 31;
    return lower + (upper - lower) * (double(z >> 11) * 0x1p-53);
  }

 private:
  std::uint64_t m_state;
};

double sine(double deg) {  // -90 to 90, without the mathematical library
  const double t = tan_of_half_deg(deg < 0 ? -deg : deg);
  const double s = 2 * t / (1 + t * t);
  return deg < 0 ? -s : s;
}

void check_range(const Sentence& what, double value, double lowest, double highest) {
  if (!(value >= lowest && value <= highest))
    bad_input("a dome's %1 of %2; accepted: %3 to %4", what, std::to_string(value),
              std::to_string(lowest), std::to_string(highest));
}

void check_dome(const DomeOptions& options) {
  check_range("number of cameras", options.count, 1, 1'000'000);
  check_range("radius", options.radius, 0, kMaxLength);
  check_range("field of view", options.fov_deg, 1, 170);
  check_range("lowest elevation", options.lowest_deg, -90, 90);
  check_range("highest elevation", options.highest_deg, options.lowest_deg, 90);
}

}  // namespace

std::vector<Camera> camera_dome(const PictureScene& scene, double aspect,
                                const DomeOptions& options) {
  check_dome(options);
  const PictureFrame frame = make_picture_frame(scene);
  Camera camera;
  camera.target = frame.world_box.centre();
  camera.fov_deg = options.fov_deg;
  const double t = tan_of_half_deg(options.fov_deg) * std::min(1.0, aspect);  // the narrower way
  const double whole = 0.5 * frame.world_box.diagonal() * std::sqrt(1 + t * t) / t;
  const double radius = options.radius > 0 ? options.radius : whole;
  const double lowest = sine(options.lowest_deg), highest = sine(options.highest_deg);
  DomeNumbers random(options.seed);
  std::vector<Camera> cameras;
  cameras.reserve(static_cast<std::size_t>(options.count));
  while (int(cameras.size()) < options.count) {
    // A point of the unit circle, by way of the disc; the height is even by area.
    const double x = random.between(-1, 1), y = random.between(-1, 1);
    const double squared = x * x + y * y;
    if (squared > 1 || squared < 1e-6) continue;
    const double z = random.between(lowest, highest);
    const double r = std::sqrt((1 - z * z) / squared);
    camera.eye = camera.target + radius * Vec3(x * r, y * r, z);
    cameras.push_back(camera);
  }
  return cameras;
}

}  // namespace trivet
