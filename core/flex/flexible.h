// A flexible object at rest: what scenes keep beside its shape.
#pragma once

#include <optional>

#include "core/flex/body.h"
#include "core/motion/pose.h"

namespace trivet {

/// Names who touches it, or holds its pins: names outlive the objects.
struct FlexSupport {
  std::string name;  // of an object; "floor"; "pins" that nobody holds
  double share = 0;  // of its weight; negative: it presses down
};

/// The proof of rest. Net forces are of a vertex's own weight.
struct RestCertificate {
  double net_force = 0;  // the largest, after a fresh update of the friction
  Vec3 net_force_at = Vec3::Zero();
  double friction_used = 0;  // the largest share of a friction's cone
  double balance = 0;        // contact and pins over the weight: 1 at rest
  double stretch = 1;        // the largest ratio of lengths to those at rest
  bool stable = false;       // no small push grows faster than in 1,000 s
  int num_vertices = 0, num_steps = 0;
  int num_contacts = 0, num_own_contacts = 0;
};

/// An object that holds a pin, and where.
struct FlexTie {
  std::string name;
  int vertex = 0;
  Vec3 point = Vec3::Zero();  // in the frame of its pose, metres
};

/// Its beginning, so that it can be draped again. In the world.
struct FlexStart {
  std::vector<Vec3> path;  // of a cable
  Pose pose;               // of a sheet's middle
  std::vector<Vec3> pins;  // by whose nearest vertices it is held
  double cell = 0;         // as given
};

/// Middle surface and line, in the object's frame.
struct Flexible {
  bool is_cable = false;
  flex::FlexMaterial material;
  flex::Points vertices;                  // of the middle, metres
  std::vector<std::array<int, 3>> faces;  // of a cable (i, i + 1, i + 1)
  std::optional<flex::Grid> grid;         // of a sheet
  double length = 0;                      // of a cable at rest, m
  flex::Points rest;                      // of a mesh at rest; else empty
  std::vector<int> pins;                  // vertices that are held
  std::vector<FlexTie> ties;              // those of them that objects hold
  std::optional<FlexStart> start;         // nullopt: not known
  double layer = 0, pressure = 0;         // of its contact; see flex::ContactOptions
  flex::Points friction;                  // all of it on each vertex, N
  RestCertificate certificate;
  std::vector<FlexSupport> supports;  // all that touched it, the largest share first
};

}  // namespace trivet
