#include "apps/demo/layout_writer.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "apps/demo/shapes/models.h"

namespace trivet {

Rotation turned(const Vec3& axis, double angle_deg) {
  const double half = angle_deg * std::numbers::pi / 360;
  const auto rounded = [](double v) { return std::nearbyint(v * 1048576) / 1048576; };
  const double w = rounded(std::cos(half)), s = rounded(std::sin(half));
  return Rotation{w, s * axis.x(), s * axis.y(), s * axis.z()}.normalized();
}

Rotation about_z(double angle_deg) { return turned(Vec3::UnitZ(), angle_deg); }

void LayoutWriter::fix(const std::string& object, const std::string& model, const Vec3& position) {
  add_object(object, model);
  m_demo.layout.objects.back().fixed = true;
  m_demo.layout.objects.back().pose = Pose{{}, position};
}

void LayoutWriter::hang(const std::string& object, const std::string& model, const Vec3& position,
                        const NamedJoint& joint) {
  fix(object, model, position);
  m_demo.layout.objects.back().joint = joint;
}

void LayoutWriter::put(const std::string& object, const std::string& model, const Vec3& position,
                       const Rotation& rotation) {
  add_object(object, model);
  const Pose start{rotation.normalized(), position};
  m_demo.layout.operations.push_back(PutOperation{{object}, start});
}

void LayoutWriter::push(const std::string& object, const Vec2& direction, double distance) {
  PushOperation push;
  push.object = object;
  push.direction = direction;
  push.distance = distance;
  add(push);
}

void LayoutWriter::push_to(const std::string& object, const Vec2& goal) {
  PushOperation push;
  push.object = object;
  push.to = goal;
  add(push);
}

void LayoutWriter::turn(const std::string& object, double angle_deg) {
  TurnOperation turn;
  turn.object = object;
  turn.angle_deg = angle_deg;
  turn.settle = true;
  add(turn);
}

void LayoutWriter::move_joint(const std::string& object, double to) {
  MoveJointOperation move;
  move.object = object;
  move.to = to;
  add(move);
}

void LayoutWriter::add(Operation operation) {
  m_demo.layout.operations.push_back(std::move(operation));
}

void LayoutWriter::add_object(const std::string& object, const std::string& model) {
  const std::string file = model + ".glb";
  const auto known = [&](const DemoModel& m) { return m.file == file; };
  if (std::none_of(m_demo.models.begin(), m_demo.models.end(), known))
    m_demo.models.push_back({file, shapes::make_model(model)});
  LayoutObject entry;
  entry.name = object;
  entry.model = file;
  m_demo.layout.objects.push_back(std::move(entry));
}

void LayoutWriter::drape(const std::string& object, const std::string& material, const Vec2& size,
                         double cell, const Vec3& position, const Rotation& rotation) {
  DrapeOperation o;
  o.object = object;
  o.material = material;
  o.size = size;
  o.cell = cell;
  o.start = {rotation, position};
  add(o);
}

}  // namespace trivet
