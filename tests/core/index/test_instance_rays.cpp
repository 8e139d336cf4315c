// Rays through instances against every triangle of every instance.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <random>

#include "core/index/instance_rays.h"

namespace trivet {
namespace {

struct Soup {
  std::vector<Vec3f> vertices;
  std::vector<Index3> triangles;
  std::vector<Vec3f> passed;
};

class Numbers {
 public:
  explicit Numbers(unsigned seed) : m_engine(seed) {}
  float between(float a, float b) { return std::uniform_real_distribution<float>(a, b)(m_engine); }
  Vec3f point(float size) {
    const float x = between(-size, size), y = between(-size, size);
    return {x, y, between(-size, size)};
  }

 private:
  std::mt19937 m_engine;
};

// Every third face lets some light through.
Soup random_soup(Numbers& random, int count) {
  Soup out;
  for (int f = 0; f < count; ++f) {
    const Vec3f at = random.point(1);
    for (int c = 0; c < 3; ++c) out.vertices.push_back(at + random.point(0.4f));
    out.triangles.push_back({3 * f, 3 * f + 1, 3 * f + 2});
    out.passed.push_back(f % 3 == 0 ? Vec3f(0.9f, 0.5f, 0.25f) : Vec3f::Zero());
  }
  return out;
}

struct Truth {
  double distance = 1e30, second = 1e30;
  std::uint32_t face = kNoFace, instance = 0;
  Vec3f passed = Vec3f::Ones();
  double margin = 1e30;  // of the nearest edge: rounding decides below
};

using Columns = std::array<Vec3f, 4>;

void try_face(const Triangle& t, const Vec3& from, const Vec3& along, std::uint32_t face,
              std::uint32_t instance, const Vec3f& passed, Truth& truth) {
  const Vec3 e1 = t[1] - t[0], e2 = t[2] - t[0], h = along.cross(e2), s = from - t[0];
  const double det = e1.dot(h);
  const Vec3 q = s.cross(e1);
  const double v = s.dot(h) / det, w = along.dot(q) / det, distance = e2.dot(q) / det;
  const double inside = std::min({v, w, 1 - v - w});
  if (distance > 0) truth.margin = std::min(truth.margin, std::abs(inside));
  if (inside < 0 || distance <= 0) return;
  truth.passed = truth.passed.cwiseProduct(passed);
  if (distance < truth.distance) {
    truth.second = truth.distance;
    truth.distance = distance, truth.face = face, truth.instance = instance;
  } else {
    truth.second = std::min(truth.second, distance);
  }
}

TEST(InstanceRays, FindWhatEveryTriangleGives) {
  Numbers random(5);
  const std::array<Soup, 2> soups = {random_soup(random, 40), random_soup(random, 25)};
  InstanceRays rays;
  for (const Soup& soup : soups) rays.add_mesh(soup.vertices, soup.triangles, soup.passed);
  std::vector<std::pair<int, Columns>> instances;
  for (int i = 0; i < 5; ++i) {
    Columns columns;
    for (Vec3f& c : columns) c = random.point(1);
    instances.emplace_back(i % 2, columns);
    EXPECT_EQ(rays.add_instance(i % 2, columns), static_cast<std::uint32_t>(i));
  }
  rays.commit();
  int num_hits = 0, num_passed = 0, num_sure = 0;
  for (int packet = 0; packet < 200; ++packet) {
    RayPacket query{};
    for (int lane = 0; lane < kRayLanes; ++lane)
      if ((packet + lane) % 5 != 0) {
        const Vec3f from = random.point(3);
        query.set(lane, from, (random.point(1) - from).normalized(), 0, 100);
      }
    const HitPacket hits = rays.first_hits(query);
    const auto passed = rays.passed(query);
    for (int lane = 0; lane < kRayLanes; ++lane) {
      if (!query.on[lane]) {
        EXPECT_EQ(hits.face[lane], kNoFace);
        EXPECT_EQ(passed[lane], Vec3f(Vec3f::Ones()));
        continue;
      }
      Truth truth;
      const Vec3 from(query.origin[0][lane], query.origin[1][lane], query.origin[2][lane]);
      const Vec3 along(query.direction[0][lane], query.direction[1][lane],
                       query.direction[2][lane]);
      for (std::uint32_t i = 0; i < instances.size(); ++i) {
        const auto& [mesh, columns] = instances[i];
        const Soup& soup = soups[mesh];
        for (std::uint32_t f = 0; f < soup.triangles.size(); ++f) {
          Triangle t;
          for (int c = 0; c < 3; ++c) {
            const Vec3f p = soup.vertices[soup.triangles[f][c]];
            t[c] = (columns[0] * p.x() + columns[1] * p.y() + columns[2] * p.z() + columns[3])
                       .cast<double>();
          }
          try_face(t, from, along, f, i, soup.passed[f], truth);
        }
      }
      const bool tied = truth.face != kNoFace && truth.second - truth.distance < 1e-3;
      if (truth.margin < 1e-4 || tied) continue;
      ++num_sure;
      ASSERT_EQ(hits.face[lane], truth.face);
      const Vec3f dark = truth.passed.maxCoeff() < 0.002f ? Vec3f(Vec3f::Zero()) : truth.passed;
      EXPECT_TRUE(passed[lane].isApprox(dark, 1e-4f)) << passed[lane].transpose();
      num_passed += dark.maxCoeff() > 0 && dark.maxCoeff() < 1;
      if (truth.face == kNoFace) continue;
      ++num_hits;
      EXPECT_EQ(hits.instance[lane], truth.instance);
      EXPECT_NEAR(hits.distance[lane], truth.distance, 1e-4);
    }
  }
  EXPECT_GT(num_sure, 800);
  EXPECT_GT(num_hits, 300);
  EXPECT_GT(num_passed, 30);
}

TEST(InstanceRays, MeetNothingInAnEmptyScene) {
  InstanceRays rays;
  rays.commit();
  RayPacket query{};
  query.set(3, Vec3f::Zero(), Vec3f::UnitX(), 0, 10);
  EXPECT_EQ(rays.first_hits(query).face[3], kNoFace);
  EXPECT_EQ(rays.passed(query)[3], Vec3f(Vec3f::Ones()));
}

}  // namespace
}  // namespace trivet
