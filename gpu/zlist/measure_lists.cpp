#include "gpu/zlist/measure_lists.h"

#include <algorithm>
#include <array>
#include <chrono>

#include "gpu/zlist/measured_shapes.h"

namespace trivet {
namespace {

constexpr int kListRepeats = 5;  // the least counts, after one that sends meshes
constexpr int kResolution = 128;

/// Milliseconds of a fall or a turn, by what came after the depths.
struct ListSample {
  double num_faces = 0, num_doubtful = 0, bounds_ms = 0, gpu_ms = 0, software_ms = 0;
};

double milliseconds_of(ZListDevice& device, const ZListAsk& ask, ZListWanted wanted,
                       ListSample& sample) {
  const auto start = std::chrono::steady_clock::now();
  const ZListAnswer answer = device.find_candidates({&ask, 1}, wanted).front();
  const auto end = std::chrono::steady_clock::now();
  sample.num_doubtful = static_cast<double>(answer.proposal.work.doubtful_pixels);
  if (wanted != ZListWanted::Bounds && !answer.proposal.usable) return kInfinity;
  return std::chrono::duration<double, std::milli>(end - start).count();
}

double least_ms(ZListDevice& device, const ZListAsk& ask, ZListWanted wanted, ListSample& sample) {
  // The first run compiles and sends; the least of the others is free of interruptions.
  milliseconds_of(device, ask, wanted, sample);
  double out = kInfinity;
  for (int i = 0; i < kListRepeats; ++i)
    out = std::min(out, milliseconds_of(device, ask, wanted, sample));
  return out;
}

/// A body that falls, or turns by half a right angle, onto another one of its shape.
ListSample sample_of(ZListDevice& device, const Shape& shape, bool flat, Motion::Kind kind) {
  // Flat squares touch everywhere and make doubtful pixels; spheres make few.
  const double height = flat ? 1 : 3;
  Motion motion = Motion::translation(-Vec3::UnitZ(), height);
  Pose start{{}, Vec3(flat ? 0.1 : 0.3, 0.2, height)};
  if (kind == Motion::Kind::Rotation) {
    const Vec3 axis_point(flat ? -1.5 : 2.5, 0, flat ? 0 : 1);
    const Vec3 axis = flat ? Vec3::UnitY() : Vec3(-Vec3::UnitY());
    motion = Motion::rotation(axis_point, axis, 1);
    start = flat ? moved_pose({}, Motion::rotation(axis_point, -axis, 1), 0.5)
                 : Pose{{}, Vec3(0.3, 0.2, 3)};
  }
  const Body fixed(shape, world_from_object({}, UpAxis::Z, 1));
  const Body moving(shape, world_from_object(start, UpAxis::Z, flat ? 1 : 0.5));
  const FirstContactQuery query{{&moving, 1}, {&fixed, 1}, false, motion, {1e-6}};
  const ZListAsk ask{&query, motion.limit, make_zlist_frame(query, motion.limit, kResolution)};
  ListSample out;
  out.num_faces = 2 * static_cast<double>(shape.mesh.triangles.size());
  out.bounds_ms = least_ms(device, ask, ZListWanted::Bounds, out);
  out.gpu_ms = least_ms(device, ask, ZListWanted::GpuLists, out);
  out.software_ms = least_ms(device, ask, ZListWanted::SoftwareLists, out);
  return out;
}

/// Cost by the times of software, or the GPU, for a small sphere, a large one and flat squares.
ListCost cost_of(const std::array<ListSample, 3>& samples, double ListSample::*ms) {
  // Lists cost what comes beyond the bounds.
  const auto beyond = [&](const ListSample& s) { return std::max(0.0, s.*ms - s.bounds_ms); };
  const auto& [small, large, flat] = samples;
  ListCost out;
  // A way that failed once is never chosen.
  for (const ListSample& s : samples)
    if (s.*ms == kInfinity) return {kInfinity, 0, 0};  // it cannot
  // Two sizes give the cost of a face and the rest; flat squares give that of a pixel.
  out.ms_per_face =
      std::max(0.0, (beyond(large) - beyond(small)) / (large.num_faces - small.num_faces));
  out.fixed_ms = std::max(0.0, beyond(small) - out.ms_per_face * small.num_faces);
  out.ms_per_doubtful =
      std::max(0.0, beyond(flat) - out.ms(flat.num_faces, 0)) / std::max(1.0, flat.num_doubtful);
  return out;
}

}  // namespace

ListCosts measure_list_costs(ZListDevice& device, Motion::Kind kind) {
  const std::array samples{sample_of(device, *bumpy_sphere(20), false, kind),
                           sample_of(device, *bumpy_sphere(75), false, kind),
                           sample_of(device, *flat_square(24), true, kind)};
  return {cost_of(samples, &ListSample::software_ms), cost_of(samples, &ListSample::gpu_ms)};
}

// Processor time of all threads: spheres of 1K to 960K faces and flat squares at 64 to 256 pixels.
ListCosts list_costs_of_llvmpipe(Motion::Kind kind) {
  return kind == Motion::Kind::Translation
             ? ListCosts{{0.05, 1.1e-5, 2.5e-4}, {0.2, 5.2e-5, 4.5e-4}}
             : ListCosts{{0.05, 2.2e-5, 4e-4}, {0.25, 9.5e-5, 8e-4}};
}

}  // namespace trivet
