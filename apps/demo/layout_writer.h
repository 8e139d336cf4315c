// Writes a demo down: its objects, their models, and what is done with them.
#pragma once

#include <string>

#include "apps/demo/demo.h"
#include "apps/demo/shapes/assemble.h"

namespace trivet {

/// About an axis of unit length. Half-angle sines are rounded to 2^-20, so that the layout file is
/// the same with every C library.
Rotation turned(const Vec3& axis, double angle_deg);
Rotation about_z(double angle_deg);

class LayoutWriter {
 public:
  explicit LayoutWriter(std::string name) { m_demo.name = std::move(name); }

  /// Stands there from the start, by default on the floor, and never moves.
  void fix(const std::string& object, const std::string& model,
           const Vec3& position = Vec3(0, 0, shapes::kGrid));

  /// Hangs in a fixed object by a joint, closed at 0.
  void hang(const std::string& object, const std::string& model, const Vec3& position,
            const NamedJoint& joint);

  /// From the pose down; see put.h.
  void put(const std::string& object, const std::string& model, const Vec3& position,
           const Rotation& rotation = {});

  /// Further operations on an object that has been put; see ops/operations/operations.h.
  void push(const std::string& object, const Vec2& direction, double distance);
  void push_to(const std::string& object, const Vec2& goal);
  void turn(const std::string& object, double angle_deg);  // where it stands
  void move_joint(const std::string& object, double to);   // metres or degrees
  void add(Operation operation);
  /// A sheet that starts level, but for its rotation.
  void drape(const std::string& object, const std::string& material, const Vec2& size, double cell,
             const Vec3& position, const Rotation& rotation = {});

  void look(const DemoView& view) { m_demo.view = view; }

  DemoLayout take() { return std::move(m_demo); }

 private:
  void add_object(const std::string& object, const std::string& model);

  DemoLayout m_demo;
};

}  // namespace trivet
