// Writes a demo down: its objects, their models, and what is done with them.
#pragma once

#include <string>

#include "apps/demo/demo.h"

namespace trivet {

/// About an axis of unit length. Half-angle sines are rounded to 2^-20, so that the layout file is
/// the same with every C library.
Rotation turned(const Vec3& axis, double angle_deg);

class LayoutWriter {
 public:
  explicit LayoutWriter(std::string name) { m_demo.name = std::move(name); }

  /// Stands on the floor from the start and never moves.
  void fix(const std::string& object, const std::string& model);

  /// From the pose down; see put.h.
  void put(const std::string& object, const std::string& model, const Vec3& position,
           const Rotation& rotation = {});

  /// Further operations on an object that has been put; see ops/operations/operations.h.
  void push(const std::string& object, const Vec2& direction, double distance);
  void push_to(const std::string& object, const Vec2& goal);
  void turn(const std::string& object, double angle_deg);  // where it stands
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
