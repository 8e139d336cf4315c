// Teapot and milk jug: surfaces of revolution with handle, spout and lip.
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "apps/demo/shapes/assemble.h"
#include "apps/demo/shapes/models.h"
#include "apps/demo/shapes/palette.h"
#include "apps/demo/shapes/parts.h"

namespace trivet::shapes {
namespace {

constexpr Index kPotGlaze = 0, kPotBand = 1, kPotFill = 2;
constexpr double kPotSink = 0.0008;  // how deep handles and spouts go into the wall

// Rings that close the open end of a tube with a hollow: the mouth of a spout.
void add_mouth(std::vector<Ring>* tube, double wall, double depth, Index inside) {
  const Ring end = tube->back();
  const size_t n = end.points.size();
  Vec3 middle = Vec3::Zero();
  for (const Vec3& p : end.points) middle += p / static_cast<double>(n);
  const Vec3 axis = (end.points[n / 4] - middle).cross(end.points[0] - middle).normalized();
  for (const double down : {0.0, depth}) {
    Ring ring{{}, down > 0 ? inside : kPotGlaze};
    for (const Vec3& p : end.points)
      ring.points.push_back(p + wall * (middle - p).normalized() - down * axis);
    tube->push_back(std::move(ring));
  }
}

std::vector<CurveSample> teapot_profile() {
  // The lid lies in the same surface, behind a narrow groove.
  return flatten(
      {corner({0, 0}), corner({0.0450, 0}), smooth({0.0465, 0.0040}), smooth({0.0610, 0.0200}),
       smooth({0.0725, 0.0480}), smooth({0.0700, 0.0760}), smooth({0.0560, 0.0990}, kPotBand),
       smooth({0.0455, 0.1065}, kPotBand), corner({0.0420, 0.1085}, kPotBand),
       corner({0.0400, 0.1070}, kPotBand), corner({0.0385, 0.1090}), smooth({0.0300, 0.1165}),
       smooth({0.0150, 0.1225}), smooth({0.0075, 0.1250}), smooth({0.0060, 0.1290}, kPotBand),
       smooth({0.0110, 0.1350}, kPotBand), smooth({0.0118, 0.1410}, kPotBand),
       smooth({0.0075, 0.1470}, kPotBand), pole(0.1490, kPotBand)},
      0.0008);
}

Part teapot_spout(const std::vector<CurveSample>& body) {
  const auto path = flatten(
      {smooth({-0.0680, 0.0400, 0.0165, 0.0150}), smooth({-0.0800, 0.0470, 0.0145, 0.0130}),
       smooth({-0.0960, 0.0640, 0.0112, 0.0102}), smooth({-0.1080, 0.0870, 0.0088, 0.0086}),
       smooth({-0.1200, 0.1020, 0.0078, 0.0080}), smooth({-0.1290, 0.1070, 0.0076, 0.0082})},
      0.0009);
  std::vector<Ring> tube = sweep(path, 16);
  sink_into(body, kPotSink, &tube.front());
  add_mouth(&tube, 0.0022, 0.0080, kPotFill);
  return {skin(tube)};
}

}  // namespace

Model make_teapot() {
  const auto profile = teapot_profile();
  const Part body{skin(revolve(profile, {40, 20, 0.0160}))};
  const auto loop =
      flatten({smooth({0.0595, 0.0920, 0.0062, 0.0085}), smooth({0.0720, 0.0985, 0.0050, 0.0070}),
               smooth({0.0930, 0.1010, 0.0045, 0.0070}), smooth({0.1120, 0.0900, 0.0045, 0.0072}),
               smooth({0.1140, 0.0680, 0.0045, 0.0072}), smooth({0.1000, 0.0450, 0.0045, 0.0068}),
               smooth({0.0840, 0.0350, 0.0048, 0.0066}), smooth({0.0680, 0.0325, 0.0060, 0.0078})},
              0.0009);
  return assemble("teapot", {body, teapot_spout(profile), handle(loop, 12, profile, kPotSink)},
                  {stoneware(), stoneware_rim(), tea()});
}

Model make_jug() {
  // The third number says how far the lip is drawn out there, towards -x.
  const auto profile = flatten(
      {corner({0, 0}), corner({0.0300, 0}), smooth({0.0315, 0.0040}), smooth({0.0400, 0.0200}),
       smooth({0.0425, 0.0400}), smooth({0.0360, 0.0640}), smooth({0.0312, 0.0800, 0.0003}),
       smooth({0.0330, 0.0940, 0.0060}, kPotBand), smooth({0.0358, 0.1020, 0.0130}, kPotBand),
       smooth({0.0352, 0.1032, 0.0138}, kPotBand), smooth({0.0338, 0.1020, 0.0132}),
       smooth({0.0308, 0.0930, 0.0058}), smooth({0.0288, 0.0810, 0.0004}),
       corner({0.0310, 0.0720}, kPotFill), corner({0, 0.0720})},
      0.0007);
  std::vector<Ring> rings = revolve(profile, {30, 30, 0});
  for (size_t i = 0; i < rings.size(); ++i) {
    for (Vec3& p : rings[i].points) {
      const double radius = std::hypot(p.x(), p.y());
      const double towards = std::max(0.0, radius > 0 ? -p.x() / radius : 0.0);
      const double pull = profile[i][2] * std::pow(towards, 6);
      p = Vec3(p.x() - pull, p.y() * (1 - 8 * profile[i][2] * towards), p.z() + 0.25 * pull);
    }
  }
  const auto loop =
      flatten({smooth({0.0313, 0.0885, 0.0040, 0.0058}), smooth({0.0420, 0.0920, 0.0032, 0.0050}),
               smooth({0.0580, 0.0870, 0.0030, 0.0050}), smooth({0.0660, 0.0690, 0.0030, 0.0050}),
               smooth({0.0600, 0.0480, 0.0030, 0.0050}), smooth({0.0500, 0.0370, 0.0032, 0.0048}),
               smooth({0.0405, 0.0320, 0.0040, 0.0056})},
              0.0007);
  return assemble("jug", {{skin(rings)}, handle(loop, 10, profile, kPotSink)},
                  {porcelain(), cobalt(), milk()});
}

}  // namespace trivet::shapes
