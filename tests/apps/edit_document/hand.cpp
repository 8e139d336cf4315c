#include "apps/edit_document/hand.h"

#include "apps/edit/tools/picking.h"

namespace trivet::edit::test {

void Hand::look_at(const Aabb& box) {
  view = View();
  view.width_px = 1280;
  view.height_px = 720;
  view.target = box.centre();
  view.eye = box.centre() + 2.5 * box.diagonal() * Vec3(0.3, -0.8, 0.6).normalized();
}

void Hand::look_down(const Aabb& box) {
  look_at(box);
  view.orthographic = true;
  view.height = 1.2 * box.diagonal();
  view.eye = box.centre() + Vec3(0, 0, 2 * box.diagonal());
  view.up = Vec3::UnitY();
}

void Hand::send(PointerEvent::Kind kind, const Vec2& at) {
  PointerEvent event;
  event.kind = kind;
  event.px = at;
  if (kind != PointerEvent::Kind::Move) event.button = MouseButton::Left;
  if (kind == PointerEvent::Kind::Press) m_down = true;
  if (kind == PointerEvent::Kind::Release) m_down = false;
  event.left_is_down = m_down;
  event.modifiers = modifiers;
  event.window = window;
  event.view = view;
  m_toolbox.pointer(event);
}

void Hand::wheel(const Vec2& at, double steps) {
  PointerEvent event;
  event.kind = PointerEvent::Kind::Wheel;
  event.px = at;
  event.wheel_steps = steps;
  event.left_is_down = m_down;
  event.modifiers = modifiers;
  event.window = window;
  event.view = view;
  m_toolbox.pointer(event);
  m_document->wait_until_idle();
}

void Hand::click(const Vec2& at) {
  move(at);
  press(at);
  release(at);
  m_document->wait_until_idle();
}

void Hand::drag(const Vec2& from, const Vec2& to, int steps) {
  move(from);
  press(from);
  for (int i = 1; i <= steps; ++i) {
    move(from + (to - from) * i / steps);
    m_document->wait_until_idle();
  }
  release(to);
  m_document->wait_until_idle();
}

bool Hand::key(char character) {
  KeyEvent event;
  event.character = character;
  const bool taken = m_toolbox.key(event);
  m_document->wait_until_idle();
  return taken;
}

bool Hand::key(KeyEvent::Key key) {
  KeyEvent event;
  event.key = key;
  const bool taken = m_toolbox.key(event);
  m_document->wait_until_idle();
  return taken;
}

std::optional<Vec2> Hand::seen(const std::string& name) const {
  const Object& object = m_document.object(name);
  const ObjectId id = m_document.id(name);
  const auto is_seen = [&](const Vec2& at) {
    const auto picked = pick(*m_document->snapshot(), view.ray(at));
    return picked && picked->object == id;
  };
  const Affine world = object.world_from_object();
  const auto& mesh = object.shape->mesh;
  for (size_t f = 0; f < mesh.triangles.size(); ++f) {
    const Triangle t = mesh.triangle(static_cast<Index>(f));
    const auto at = view.project(world.apply((t[0] + t[1] + t[2]) / 3));
    if (at && is_seen(*at)) return at;
  }
  return std::nullopt;
}

}  // namespace trivet::edit::test
