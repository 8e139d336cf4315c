// An MJCF model as a tree of bodies, before poses are computed. Private to the reader.
#pragma once

#include <string>
#include <vector>

#include "core/io/foreign/mass_sum.h"
#include "core/io/foreign/mjcf/assets.h"

namespace trivet::mjcf {

struct Geom {
  ForeignCollider collider;  // without a mesh and no plane: it does not collide
  bool is_plane = false;
  bool collides = true;
};

struct Joint {
  enum class Kind { Free, Ball, Slide, Hinge } kind = Kind::Hinge;
  Vec3 anchor = Vec3::Zero(), axis = Vec3::UnitZ();  // in the body's frame
  double reference = 0;                              // metres or degrees
  size_t first_number = 0;                           // in a keyframe's qpos
  size_t num_numbers() const { return kind == Kind::Free ? 7 : kind == Kind::Ball ? 4 : 1; }
};

struct Body {
  std::string name;  // as the file has it; empty: none
  int parent = -1;   // -1: the world itself
  const XmlNode* node = nullptr;
  Pose frame;  // of the enclosing frames, in the parent
  Pose local;  // of the body, in the parent
  bool mocap = false;
  bool moves = false;       // it, or what it is part of, has joints
  bool needs_mass = false;  // it moves, and its file gives none
  bool is_copy = false;     // its tag makes several bodies
  std::vector<Joint> joints;
  std::vector<Geom> geoms;
  MassSum of_geoms;
  std::optional<GivenMass> inertial;
};

struct Model {
  std::vector<Body> bodies;  // the world first, parents before their children
  size_t num_numbers = 0;    // of a keyframe's qpos
};

/// The bodies of <worldbody>. Adds to notes and unread of the scene.
Model read_bodies(const XmlNode& root, const Settings& settings, Assets& assets,
                  const ForeignOptions& options, ForeignScene& scene);

/// Adds a geom to its body. @param frame  of enclosing frames, in the body.
void read_geom(const Attributes& a, const Pose& frame, const Settings& settings, Assets& assets,
               const ForeignOptions& options, Body& body, ForeignScene& scene);

/// What a body weighs by the rules of <compiler>.
std::optional<GivenMass> mass_of(const Body& body, const Settings& settings);

}  // namespace trivet::mjcf
