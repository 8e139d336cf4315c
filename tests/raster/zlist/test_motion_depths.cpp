// Depth images of a motion contain exact rays, and their doubtful pixels the first contact.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "raster/zlist/depth_picture.h"
#include "support/effort.h"
#include "support/random_queries.h"

namespace trivet {
namespace {

constexpr unsigned kDepthSeed = 5141;
constexpr double kTurn = 2 * std::numbers::pi;

// Depths at which the line of sight through a point of the image meets a face; pixels or radians.
// Of a turn, the line is a circle about the axis.
std::vector<double> depths_on_line(const Triangle& t, const ZListFrame& frame, const Vec2& at) {
  if (frame.kind == Motion::Kind::Translation) {
    const Vec2 a = t[0].head<2>(), e = t[1].head<2>() - a, f = t[2].head<2>() - a, p = at - a;
    const double area = e.x() * f.y() - e.y() * f.x();
    const double l = (p.x() * f.y() - p.y() * f.x()) / area,
                 m = (e.x() * p.y() - e.y() * p.x()) / area;
    if (!(l >= 0 && m >= 0 && l + m <= 1)) return {};
    return {t[0].z() + l * (t[1].z() - t[0].z()) + m * (t[2].z() - t[0].z())};
  }
  std::vector<Vec2> cut;  // the face at this height
  for (int k = 0; k < 3; ++k) {
    const Vec3 &a = t[k], &b = t[(k + 1) % 3];
    if ((a.z() < at.y()) != (b.z() < at.y()))
      cut.push_back((a + (at.y() - a.z()) / (b.z() - a.z()) * (b - a)).head<2>());
  }
  if (cut.size() != 2) return {};
  const Vec2 e = cut[1] - cut[0];
  const double radius = at.x() + frame.first_radius, square = e.squaredNorm(), half = cut[0].dot(e);
  const double root = half * half - square * (cut[0].squaredNorm() - radius * radius);
  if (!(root >= 0) || !(square > 0)) return {};
  std::vector<double> out;
  for (const double sign : {-1.0, 1.0}) {
    const double s = (-half + sign * std::sqrt(root)) / square;
    const Vec2 p = cut[0] + s * e;
    if (s >= 0 && s <= 1) out.push_back(std::atan2(p.y(), p.x()));
  }
  return out;
}

std::vector<double> depths_on_line(std::span<const Body> bodies, std::span<const Index> chosen,
                                   const ZListFrame& frame, const Vec2& at) {
  std::vector<double> out;
  for (const Index b : chosen) {
    const Affine map = frame.pixels_from_object(bodies[b]);
    const Mesh& mesh = bodies[b].shape->mesh;
    for (Index f = 0; f < static_cast<Index>(mesh.triangles.size()); ++f) {
      Triangle t = mesh.triangle(f);
      for (Vec3& corner : t) corner = map.apply(corner);
      for (const double depth : depths_on_line(t, frame, at)) out.push_back(depth);
    }
  }
  return out;
}

struct DepthCounts {
  int moving = 0, fixed = 0, contacts = 0, with_upper = 0, images = 0, incomplete = 0;
  std::int64_t pixels = 0, doubtful = 0;
};

// One line of sight: what it meets lies within the fronts.
void check_line(const FirstContactQuery& query, const MotionDepths& d, const Vec2& at,
                DepthCounts& counts) {
  const ZListFrame& frame = d.frame;
  const size_t pixel = static_cast<size_t>(at.y()) * frame.width + static_cast<size_t>(at.x());
  const bool turns = d.turns();
  // Moving bodies all around the axis: faces across the cut may be drawn a turn earlier or later.
  const bool around = turns && frame.moving_depth > kTurn - 1e-3;
  double lowest = d.has_moving(pixel) ? kInfinity : 0;
  for (double depth : depths_on_line(query.moving, frame.moving, frame, at)) {
    if (turns && depth < 0) depth += kTurn;
    if (turns && !(depth < frame.moving_depth)) continue;  // rounding at the cut
    ASSERT_LE(around && depth > kTurn - 0.6 ? depth - kTurn : depth, d.moving_front[pixel] + 1e-6);
    lowest = std::min(lowest, depth);
    ++counts.moving;
  }
  if (around) return;
  for (double depth : depths_on_line(query.fixed, frame.fixed, frame, at)) {
    if (turns) depth += kTurn * std::ceil((lowest - depth) / kTurn);
    if (!(depth >= lowest) || depth > frame.moving_depth + frame.reach) continue;
    ASSERT_LE(d.fixed_front[pixel], depth + 1e-6);
    ++counts.fixed;
  }
}

// The fronts are those of faces near the pixel.
void check_tight(const FirstContactQuery& query, const MotionDepths& d) {
  const ZListFrame& frame = d.frame;
  const double room = frame.growth + 0.03;
  std::vector<double> farthest(d.size(), -kInfinity);
  for (const Index b : frame.moving) {
    const Affine map = frame.pixels_from_object(query.moving[b]);
    for (Index f = 0; f < static_cast<Index>(query.moving[b].shape->mesh.triangles.size()); ++f) {
      Aabb box;
      for (const Vec3& corner : query.moving[b].shape->mesh.triangle(f))
        box.extend(map.apply(corner));
      for (int y = 0; y < frame.height; ++y)
        for (int x = 0; x < frame.width; ++x)
          if (box.lower.x() - room <= x + 1 && box.upper.x() + room >= x &&
              box.lower.y() - room <= y + 1 && box.upper.y() + room >= y) {
            double& most = farthest[static_cast<size_t>(y) * frame.width + x];
            most = std::max(most, box.upper.z());
          }
    }
  }
  for (size_t i = 0; i < d.size(); ++i)
    if (d.has_moving(i)) {
      ASSERT_LE(d.moving_front[i], farthest[i] + room + 1e-5 * (1 + std::abs(farthest[i])));
    }
}

// The pixel of the first contact, or a neighbour when it lies on their border.
bool is_doubtful_at(const MotionDepths& d, const Vec3& world) {
  for (const double du : {0.0, -1e-6, 1e-6})
    for (const double dv : {0.0, -1e-6, 1e-6}) {
      Vec3 shift = Vec3::Zero();
      if (d.turns()) {
        const Vec3 p = d.frame.image_from_world * (world - d.frame.origin);
        const double r = p.head<2>().norm();
        if (r > 0) shift = Vec3(du * p.x() / r, du * p.y() / r, dv);
      } else {
        shift = Vec3(du, dv, 0);
      }
      const auto pixel =
          d.pixel_of(world + d.frame.pixel * d.frame.image_from_world.transpose() * shift);
      if (pixel && d.doubtful[*pixel]) return true;
    }
  return false;
}

void check(const FirstContactQuery& query, int resolution, test::Random& random,
           DepthCounts& counts) {
  const MotionDepths d = motion_depths(query, query.motion.limit, resolution);
  const FirstContact truth = first_contact_brute_force(query);
  if (d.frame.empty()) {
    ASSERT_EQ(truth.status, FirstContact::Status::Free);
    return;
  }
  ++counts.images;
  for (int y = 0; y < d.frame.height; ++y)
    for (int x = 0; x < d.frame.width; ++x) {
      check_line(query, d, Vec2(x + 0.5, y + 0.5), counts);
      check_line(query, d, Vec2(x + random.uniform(0.001, 0.999), y + random.uniform(0.001, 0.999)),
                 counts);
    }
  if (!d.turns()) check_tight(query, d);
  if (!d.complete) {
    ++counts.incomplete;
    return;
  }
  counts.pixels += d.num_pixels;
  counts.doubtful += d.num_doubtful;
  if (truth.status == FirstContact::Status::Free) {
    ASSERT_EQ(d.upper, kInfinity);
    return;
  }
  const double time = truth.status == FirstContact::Status::Crossing ? 0 : truth.time;
  ASSERT_LE(d.lower, time);
  ASSERT_GE(d.upper, time);
  counts.with_upper += d.upper < kInfinity;
  if (truth.status != FirstContact::Status::Contact) return;
  ++counts.contacts;
  ASSERT_TRUE(is_doubtful_at(d, truth.point)) << test::describe(truth);
}

TEST(MotionDepths, ContainExactRaysAndTheFirstContact) {
  const test::MeshPool pool(kDepthSeed, 12);
  test::Random random(kDepthSeed);
  DepthCounts counts;
  constexpr int kFewest = 1500;  // of fewer, the share of doubtful pixels says little
  const int num = std::max(kFewest, test::with_effort(kFewest));
  for (int i = 0; i < num; ++i) {
    test::RandomQuery q = i % 4 == 3 ? test::random_group_query(pool, kDepthSeed, i)
                                     : test::random_query(pool, kDepthSeed, i);
    q.floor = false;
    const int resolution = random.integer(1, 24);
    q.ask([&](const FirstContactQuery& query) {
      check(query, resolution, random, counts);
      return 0;
    });
    ASSERT_FALSE(HasFatalFailure()) << "query " << i << "\n" << q.describe();
  }
  EXPECT_GT(counts.images, num / 2);
  EXPECT_GT(counts.moving, 20 * num);
  EXPECT_GT(counts.fixed, 10 * num);
  EXPECT_GT(counts.contacts, num / 5);
  EXPECT_GT(counts.with_upper, counts.contacts / 4);
  EXPECT_LT(counts.incomplete, num / 100);
  EXPECT_LT(counts.doubtful, counts.pixels / 2);
  std::printf(
      "%d images, %d and %d depths of lines, %d contacts, %d with an upper bound, %lld of "
      "%lld pixels doubtful\n",
      counts.images, counts.moving, counts.fixed, counts.contacts, counts.with_upper,
      static_cast<long long>(counts.doubtful), static_cast<long long>(counts.pixels));
}

// A cube of 0.2 m falls 0.5 m onto the right half of a slab.
TEST(MotionDepths, AreThoseOfACubeAboveASlab) {
  const auto cube = test::shape_of(test::box_triangles({0.1, 0.1, 0.1}));
  const auto slab = test::shape_of(test::box_triangles({0.5, 0.5, 0.1}));
  const std::vector<Body> moving{{*cube, world_from_object({{}, Vec3(0, 0, 0.7)}, UpAxis::Z, 1)}};
  const std::vector<Body> fixed{{*slab, world_from_object({{}, Vec3(0.5, 0, 0)}, UpAxis::Z, 1)}};
  FirstContactQuery query{moving, fixed, false, Motion::translation(-Vec3::UnitZ(), 2), {}};
  query.clearance.distance = 1e-6;
  const MotionDepths d = motion_depths(query, 2, 40);
  ASSERT_TRUE(d.complete);
  EXPECT_NEAR(d.lower, 0.5, 1e-5);
  EXPECT_NEAR(d.upper, 0.5, 1e-5);
  const DepthPicture picture(d);
  EXPECT_EQ(picture.right(), Vec3::UnitX());
  EXPECT_EQ(picture.up(), Vec3::UnitY());
  // The image is the part of the cube's box over the slab: its right half.
  EXPECT_EQ(picture.height(), 40);
  EXPECT_NEAR(picture.width(), 20, 1);
  int num_doubtful = 0;
  for (int y = 1; y + 1 < picture.height(); ++y)
    for (int x = 1; x + 1 < picture.width(); ++x) {
      EXPECT_NEAR(picture.value(DepthShow::Moving, x, y).value(), 200, 0.1);
      EXPECT_NEAR(picture.value(DepthShow::Fixed, x, y).value(), 700, 0.1);
      EXPECT_NEAR(picture.value(DepthShow::Gap, x, y).value(), 500, 0.1);
      num_doubtful += d.doubtful[picture.pixel(x, y)];
    }
  EXPECT_EQ(num_doubtful, (picture.width() - 2) * (picture.height() - 2));
  const auto corner = picture.seen_at(Vec3(0.0801, 0.0801, 0.1));
  ASSERT_TRUE(corner);
  EXPECT_NEAR((*corner)[0], 16, 1);
  EXPECT_NEAR((*corner)[1], 4, 1);
  EXPECT_FALSE(picture.seen_at(Vec3(0.3, 0, 0.1)));
}

// Every view has the world's z up, and shows the sides as one sees them along the motion.
TEST(DepthPicture, IsSeenAlongTheMotion) {
  const auto box = test::shape_of(test::box_triangles({0.1, 0.2, 0.3}));
  test::Random random(7);
  for (int i = 0; i < 200; ++i) {
    const Vec3 axis = i < 6 ? Vec3((i % 2 ? -1 : 1) * Vec3::Unit(i / 2)) : random.direction();
    const std::vector<Body> moving{{*box, {}}};
    const std::vector<Body> fixed{{*box, world_from_object({{}, axis}, UpAxis::Z, 1)}};
    FirstContactQuery query{moving, fixed, false, Motion::translation(axis, 2), {}};
    query.clearance.distance = 1e-6;
    const MotionDepths d = motion_depths(query, 2, 64);
    ASSERT_FALSE(d.frame.empty());
    const DepthPicture picture(d);
    EXPECT_LT((picture.right().cross(picture.up()) + axis).norm(), 1e-12);
    EXPECT_GE(picture.up().z(), -1e-12);
    EXPECT_GE(picture.up().z(), std::abs(picture.right().z()) - 1e-12);
    // Every pixel of the image once, and points where they are seen.
    std::vector<int> times(d.size());
    for (int y = 0; y < picture.height(); ++y)
      for (int x = 0; x < picture.width(); ++x) ++times[picture.pixel(x, y)];
    EXPECT_EQ(times, std::vector<int>(d.size(), 1));
    // Off the middle, where pixels may meet.
    const Vec3 centre = axis + d.frame.pixel * (0.23 * picture.right() + 0.31 * picture.up());
    const auto a = picture.seen_at(centre),
               b = picture.seen_at(centre + 3 * d.frame.pixel * picture.right()),
               c = picture.seen_at(centre + 3 * d.frame.pixel * picture.up());
    ASSERT_TRUE(a && b && c);
    EXPECT_EQ((*b)[0] - (*a)[0], 3);
    EXPECT_EQ((*c)[1] - (*a)[1], -3);
  }
}

TEST(DepthPicture, PaintsScaleAndOutlines) {
  MotionDepths d;
  d.frame.width = 3, d.frame.height = 1;
  d.frame.pixel = 1e-3;
  d.moving_front = {0, 5, 10};
  d.fixed_front = {12, static_cast<float>(kInfinity), 11};
  d.doubtful = {0, 0, 1};
  const DepthPicture picture(d);
  ASSERT_EQ(picture.width() * picture.height(), 3);
  for (const int magnify : {4, 6}) {
    const auto rgba = picture.paint(DepthShow::Gap, magnify);
    ASSERT_EQ(rgba.size(), 4u * 3 * magnify * magnify);
    int num_clear = 0, num_outline = 0, num_largest = 0, num_inner = 0;
    for (size_t i = 0; i < rgba.size(); i += 4) {
      const Rgb colour{rgba[i], rgba[i + 1], rgba[i + 2]};
      num_clear += rgba[i + 3] == 0;
      num_outline += rgba[i + 3] == 255 && colour == kDoubtfulColour;
      num_largest += rgba[i + 3] == 255 && colour == scale_colour(1);
      num_inner += rgba[i + 3] == 255 && colour == scale_colour(1.0 / 12);
    }
    const int all = magnify * magnify;
    const int beside = magnify == 4 ? magnify : 0;  // of the outline, outside the image above
    EXPECT_EQ(num_clear, all - beside);             // nothing fixed in the middle
    EXPECT_EQ(num_largest, all);                    // a gap of 12 mm
    EXPECT_EQ(num_inner, 4);                        // of the gap of 1 mm, within its outline
    EXPECT_EQ(num_outline, all - num_inner + beside);
  }
  EXPECT_EQ((*picture.range(DepthShow::Gap))[0], 0);
  EXPECT_NEAR((*picture.range(DepthShow::Gap))[1], 12, 1e-9);
  EXPECT_FALSE(DepthPicture(MotionDepths{}).range(DepthShow::Fixed));
  EXPECT_TRUE(DepthPicture(MotionDepths{}).paint(DepthShow::Fixed, 2).empty());
}

// Pixels next to each other are outlined as one, and no line crosses them.
TEST(DepthPicture, OutlinesRegionsAsOne) {
  MotionDepths d;
  d.frame.width = 4, d.frame.height = 3;
  d.frame.pixel = 1e-3;
  d.moving_front.assign(12, 0);
  d.fixed_front.assign(12, 5);
  d.doubtful.assign(12, 0);
  d.doubtful[5] = d.doubtful[6] = 1;
  constexpr int kMagnify = 3;
  const auto rgba = DepthPicture(d).paint(DepthShow::Gap, kMagnify);
  int num_outline = 0;
  for (size_t i = 0; i < rgba.size(); i += 4)
    num_outline += Rgb{rgba[i], rgba[i + 1], rgba[i + 2]} == kDoubtfulColour;
  EXPECT_EQ(num_outline, 5 * 8 - 1 * 4);  // a pixel beyond and one within 3 x 6
}

}  // namespace
}  // namespace trivet
