#include "apps/edit/tools/paint_tool.h"

#include <QCoreApplication>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "apps/edit/document/paint.h"
#include "apps/edit/tools/picking.h"

namespace trivet::edit {
namespace {

constexpr double kStrokePx = 4;       // between points of a stroke
constexpr double kSprayRadius = 0.8;  // of the spacing: of the disc under the mouse
constexpr int kPlaceParts = 16;
constexpr double kPlaceRadius = 0.35;  // radius of a place, of the spacing

/// A level ring.
void add_ring(const Vec3& centre, double radius, Overlay& out) {
  const auto at = [&](int i) {
    const double angle = 2 * std::numbers::pi * i / kPlaceParts;
    return Vec3(centre + radius * Vec3(std::cos(angle), std::sin(angle), 0));
  };
  for (int i = 0; i < kPlaceParts; ++i)
    out.lines.push_back({Overlay::Role::HoverEdge, at(i), at(i + 1)});
}

}  // namespace

bool PaintTool::pointer(const PointerEvent& event) {
  using Kind = PointerEvent::Kind;
  if (event.kind == Kind::Press) {
    if (m_pressed) return true;
    if (event.button != MouseButton::Left || m_document.is_busy() || objects().empty())
      return false;
    m_pressed = event;
    m_last = event.px;
    m_stroke.clear();
    m_began = std::chrono::steady_clock::now();
    if (const auto hit = pick(*m_document.snapshot(), event.view.seen_ray(event.px),
                              m_document.looks().hidden()))
      m_stroke.push_back(hit->point);
    return true;
  }
  if (!m_pressed) return false;
  if (event.kind == Kind::Move) paint_to(event);
  if (event.kind == Kind::Release && event.button == MouseButton::Left) finish();
  return true;
}

// Over the surfaces between the last pixel and this one. Where there is none the stroke goes on
// straight at the next surface.
void PaintTool::paint_to(const PointerEvent& event) {
  const double length = (event.px - m_last).norm();
  const int steps = static_cast<int>(length / kStrokePx);
  const std::vector<ObjectId> hidden = m_document.looks().hidden();
  for (int i = 1; i <= steps; ++i) {
    const Vec2 px = m_last + (event.px - m_last) * i / steps;
    if (const auto hit = pick(*m_document.snapshot(), m_pressed->view.seen_ray(px), hidden))
      m_stroke.push_back(hit->point);
  }
  if (steps > 0) m_last = event.px;
}

void PaintTool::finish() {
  PaintWish wish;
  wish.objects = objects();
  wish.places = places();
  wish.turned = m_options.paint_turned;
  wish.pile = m_options.paint_pile;
  wish.seed = m_options.paint_seed + m_strokes++;
  wish.drop_height = m_options.drop_height;
  m_pressed.reset();
  m_stroke.clear();
  if (wish.places.empty()) return;
  ManyObjects copies = painted(*m_document.snapshot(), wish);
  copies.select = false;  // the next stroke paints the same objects
  m_document.perform_groups(wish.pile ? "pour" : "paint", std::move(copies));
}

bool PaintTool::key(const KeyEvent& event) {
  return event.key == KeyEvent::Key::Escape && escape(*this, m_document);
}

void PaintTool::cancel() {
  m_pressed.reset();
  m_stroke.clear();
}

std::vector<std::string> PaintTool::objects() const {
  return selected_names(m_document.selection(), *m_document.snapshot());
}

double PaintTool::spacing() const {
  if (m_options.paint_spacing > 0) return m_options.paint_spacing;
  return width_of(*m_document.snapshot(), objects());
}

std::vector<Vec3> PaintTool::places() const {
  return m_options.paint_pile ? poured() : spaced(m_stroke, spacing());
}

// As many as the time since the press makes, around the points of the stroke in turn.
std::vector<Vec3> PaintTool::poured() const {
  if (m_stroke.empty()) return {};
  const std::chrono::duration<double> held = std::chrono::steady_clock::now() - m_began;
  const size_t count = 1 + static_cast<size_t>(held.count() * m_options.paint_flow);
  std::vector<Vec3> out =
      sprayed(Vec3::Zero(), kSprayRadius * spacing(), count, m_options.paint_seed + m_strokes);
  for (size_t i = 0; i < out.size(); ++i) out[i] += m_stroke[i * m_stroke.size() / out.size()];
  return out;
}

Overlay PaintTool::overlay(const View&) const {
  Overlay out;
  if (!m_pressed) return out;
  const std::vector<Vec3> all = places();
  const double radius = kPlaceRadius * spacing();
  for (const Vec3& place : all) add_ring(place, radius, out);
  for (size_t i = 0; i + 1 < m_stroke.size(); ++i)
    out.lines.push_back({Overlay::Role::Hint, m_stroke[i], m_stroke[i + 1]});
  const int count = static_cast<int>(all.size());
  out.note = QCoreApplication::translate("tools", "%n copies", nullptr, count).toStdString();
  return out;
}

Cursor PaintTool::cursor() const { return objects().empty() ? Cursor::Arrow : Cursor::Cross; }

std::string PaintTool::in_hand() const {
  const std::vector<std::string> all = objects();
  if (all.empty()) return {};
  if (all.size() == 1) return all.front();
  const int count = static_cast<int>(all.size());
  return QCoreApplication::translate("tools", "%n objects in turn", nullptr, count).toStdString();
}

std::string PaintTool::hint() const {
  if (objects().empty())
    return QT_TRANSLATE_NOOP("tools",
                             "Select the objects to paint copies of, then drag over a surface");
  if (m_options.paint_pile)
    return QT_TRANSLATE_NOOP("tools",
                             "Hold the button over a bowl, a box or a heap: copies fall onto each "
                             "other there until you let go");
  return QT_TRANSLATE_NOOP(
      "tools",
      "Drag over a surface: copies are set down along the stroke; what does not fit is left out");
}

}  // namespace trivet::edit
