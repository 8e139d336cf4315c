#include "ops/operations/contact_end.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>

#include "core/contact/triangle_distance.h"

namespace trivet {
namespace {

constexpr double kSamePlane = 1e-7;  // sine of the angle between faces that count as one
constexpr int kMaxFaces = 10000;     // that a vertex goes over before it is asked again

Vec3 face_normal(const Triangle& t) {
  const Vec3 n = (t[1] - t[0]).cross(t[2] - t[0]);
  const double length = n.norm();
  return length > 0 ? Vec3(n / length) : Vec3(Vec3::Zero());
}

struct Exit {
  double time = kInfinity;
  int edge = 0;
};

// Exit of p + t velocity from the face; never earlier than `now`.
Exit leaves(const Triangle& t, const Vec3& normal, const Vec3& p, const Vec3& velocity,
            double now) {
  Exit exit;
  // The first edge that is passed outwards ends the contact with this face.
  for (int k = 0; k < 3; ++k) {
    const Vec3 outward = (t[(k + 1) % 3] - t[k]).cross(normal);
    const double speed = outward.dot(velocity);
    if (speed <= 0) continue;
    const double time = std::max(now, -outward.dot(p - t[k]) / speed);
    if (time < exit.time) exit = {time, k};
  }
  return exit;
}

// The other face at that edge in the same plane; -1: none.
Index next_in_plane(const Body& body, Index face, int edge, const Vec3& normal) {
  const Adjacency& adjacency = body.shape->adjacency;
  const Index id = adjacency.face_edges[face][edge];
  if (id < 0) return -1;
  for (const Wing& wing : adjacency.edge_faces[id]) {
    if (wing.face == face) continue;
    const Vec3 other = face_normal(body.triangle(wing.face));
    if (other.dot(normal) > 0 && other.cross(normal).norm() <= kSamePlane) return wing.face;
  }
  return -1;
}

double way_over_faces(const Body& body, Index face, const Vec3& p, const Vec3& velocity) {
  double now = 0;
  // A point that leaves a face goes on over its neighbour in the same plane.
  for (int i = 0; i < kMaxFaces; ++i) {
    const Triangle t = body.triangle(face);
    const Vec3 normal = face_normal(t);
    const Exit exit = leaves(t, normal, p, velocity, now);
    if (exit.time == kInfinity) return kInfinity;
    now = exit.time;
    face = next_in_plane(body, face, exit.edge, normal);
    if (face < 0) break;
  }
  return now;
}

// The time at which a + b t, in [0, 1] at 0, leaves that range.
double leaves_range(double a, double b) {
  if (b > 0) return std::max(0.0, (1 - a) / b);
  if (b < 0) return std::max(0.0, -a / b);
  return kInfinity;
}

std::array<Vec3, 2> edge_of(const Body& body, Index edge) {
  const auto& ends = body.shape->adjacency.edge_vertices[edge];
  return {body.vertex(ends[0]), body.vertex(ends[1])};
}

double way_of_edges(const Body& moving, const Body& fixed, const ContactPoint& contact,
                    const Vec3& velocity) {
  const auto [a, a_end] = edge_of(moving, contact.feature_object);
  const auto [b, b_end] = edge_of(fixed, contact.feature_support);
  const Vec3 u = a_end - a, v = b_end - b, n = u.cross(v);
  const double squared = n.squaredNorm();
  if (squared == 0) return 0;
  // a + s u meets b + t v, seen along n.
  const auto along = [&](const Vec3& r, const Vec3& other) {
    return r.cross(other).dot(n) / squared;
  };
  const Vec3 r = b - a;
  return std::min(leaves_range(along(r, v), -along(velocity, v)),
                  leaves_range(along(r, u), -along(velocity, u)));
}

Triangle shifted(Triangle t, const Vec3& by) {
  for (Vec3& p : t) p += by;
  return t;
}

// Two triangles' distance is a convex function of time: it is small in one interval.
double way_of_faces(const Triangle& moving, const Triangle& fixed, const Vec3& velocity,
                    double tolerance) {
  const auto near = [&](double time) {
    return closest_points(shifted(moving, time * velocity), fixed).distance <= tolerance;
  };
  // The end is bracketed by doubling, and found by halving.
  double good = 0, bad = tolerance / velocity.norm();
  for (int i = 0; i < 60 && near(bad); ++i) good = bad, bad *= 2;
  for (int i = 0; i < 40; ++i) {
    const double middle = 0.5 * (good + bad);
    (near(middle) ? good : bad) = middle;
  }
  return good;
}

}  // namespace

double contact_end(const Body& moving, const Body* fixed, const ContactPoint& contact,
                   const Vec3& velocity, double tolerance) {
  // The floor has no end.
  if (!fixed) return kInfinity;
  // A vertex runs off a face over its edges, an edge runs off an edge at either's ends.
  switch (contact.features) {
    case ContactFeatures::VertexFace:
      return way_over_faces(*fixed, contact.feature_support, moving.vertex(contact.feature_object),
                            velocity);
    case ContactFeatures::FaceVertex:
      return way_over_faces(moving, contact.feature_object, fixed->vertex(contact.feature_support),
                            -velocity);
    case ContactFeatures::EdgeEdge:
      return way_of_edges(moving, *fixed, contact, velocity);
    // Closest points of two faces have no feature to run off: their distance itself is followed.
    case ContactFeatures::ClosestPoints:
      return way_of_faces(moving.triangle(contact.feature_object),
                          fixed->triangle(contact.feature_support), velocity, tolerance);
  }
  return kInfinity;
}

}  // namespace trivet
