// Published resting poses of scanned objects: remaining fall of the top object.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>

#include "core/contact/first_contact.h"
#include "core/io/read_model.h"
#include "core/model/model.h"
#include "support/shared_data.h"

namespace trivet {
namespace {

const std::string kFolder = "scenes/ycb_settled/";

struct GapCase {
  std::string world, top, bottom;
  std::array<double, 6> pose_top, pose_bottom;  // x y z roll pitch yaw
  double gap;                                   // metres
};

std::vector<GapCase> read_cases() {
  std::ifstream in(test::shared_data(kFolder + "pairs.csv"));
  std::string line, cell;
  std::getline(in, line);  // the header
  std::vector<GapCase> out;
  while (std::getline(in, line)) {
    std::istringstream cells(line);
    GapCase c;
    std::getline(cells, c.world, ',');
    std::getline(cells, c.top, ',');
    std::getline(cells, c.bottom, ',');
    const auto number = [&] { return std::getline(cells, cell, ','), std::stod(cell); };
    for (double& x : c.pose_top) x = number();
    for (double& x : c.pose_bottom) x = number();
    c.gap = 1e-3 * number();
    out.push_back(c);
  }
  return out;
}

Mat3 turn(int axis, double angle) {
  Mat3 m = Mat3::Identity();
  const int i = (axis + 1) % 3, j = (axis + 2) % 3;
  m(i, i) = m(j, j) = std::cos(angle);
  m(j, i) = std::sin(angle);
  m(i, j) = -m(j, i);
  return m;
}

class YcbShapes {
 public:
  YcbShapes() {
    std::ifstream in(test::shared_data(kFolder + "mesh_offsets.json"));
    m_offsets = nlohmann::json::parse(in);
  }

  // The offset belongs to the mesh: applied before the pose.
  Body body(const std::string& name, const std::array<double, 6>& pose) {
    auto& shape = m_shapes[name];
    if (!shape) shape = make_shape(read_model(test::shared_data(kFolder + name + ".obj")).mesh);
    Affine world;
    world.linear = turn(2, pose[5]) * turn(1, pose[4]) * turn(0, pose[3]);
    world.translation = world.linear * offset(name) + Vec3(pose[0], pose[1], pose[2]);
    return {*shape, world};
  }

 private:
  Vec3 offset(const std::string& name) const {
    if (!m_offsets.contains(name)) return Vec3::Zero();
    const auto& o = m_offsets.at(name);
    return {o.at(0).get<double>(), o.at(1).get<double>(), o.at(2).get<double>()};
  }

  nlohmann::json m_offsets;
  std::map<std::string, std::shared_ptr<const Shape>> m_shapes;
};

TEST(YcbSettled, DropsByPublishedGap) {
  TRIVET_NEEDS_DATA(kFolder);
  constexpr double kClearance =
      1e-8;  // far below the tolerance, as it is measured along the normal
  YcbShapes shapes;
  const std::vector<GapCase> cases = read_cases();
  EXPECT_EQ(cases.size(), 71u);
  double worst = 0;
  for (const GapCase& c : cases) {
    SCOPED_TRACE(c.world + ": " + c.top + " on " + c.bottom);
    const Body top = shapes.body(c.top, c.pose_top), bottom = shapes.body(c.bottom, c.pose_bottom);
    FirstContactQuery q{{&top, 1}, {&bottom, 1}, false, {}, {kClearance}};
    q.motion = Motion::translation(-Vec3::UnitZ(), 1);
    const FirstContact found = first_contact(q);
    ASSERT_EQ(found.status, FirstContact::Status::Contact);
    EXPECT_FALSE(found.stalled);
    EXPECT_NEAR(found.time + kClearance, c.gap, 1e-6);
    worst = std::max(worst, std::abs(found.time + kClearance - c.gap));
  }
  std::printf("worst error of %zu gaps: %.3g m (they are given to 5e-7 m)\n", cases.size(), worst);
}

}  // namespace
}  // namespace trivet
