#include "apps/edit/window/wish_marks.h"

#include <QColor>
#include <QFontMetrics>
#include <algorithm>

#include "apps/edit/window/live_objects.h"

namespace trivet::edit {
namespace {

constexpr size_t kMostMarks = 200;

// Where it is previewed, else where it stands.
std::optional<Vec3> middle_of(const Document& document, const ObjectSnapshot& object) {
  if (const auto& layout = document.layout())
    for (const Ghost::Member& member : layout->members)
      if (member.id == object.id) {
        Object there = *object.object;
        there.pose = member.pose;
        return world_box(there).centre();
      }
  if (!object->placed) return std::nullopt;
  return world_box(*object.object).centre();
}

const ObjectSnapshot* only_one(const SceneSnapshot& scene, const std::vector<std::string>& names) {
  return names.size() == 1 ? scene.find(names.front()) : nullptr;
}

bool is_selected(const Document& document, size_t entry) {
  const auto snapshot = document.snapshot();
  return std::any_of(document.selection().objects.begin(), document.selection().objects.end(),
                     [&](ObjectId id) {
                       const ObjectSnapshot* const object = snapshot->find(id);
                       return object && document.wishes().is_about(entry, (*object)->name);
                     });
}

// Between the names, without them: "right of, 1 to 3 cm".
QString label_of(const Wish& wish) {
  QString out = QString::fromStdString(wish.text);
  for (const std::vector<std::string>& names : {wish.a, wish.b})
    for (const std::string& name : names) out.remove("\"" + QString::fromStdString(name) + "\"");
  return out.simplified().replace(" ,", ",");
}

QColor colour_of(const WishMark& mark, const Theme& theme) {
  return mark.conflicts ? theme.refused() : mark.is_soft ? theme.warning() : theme.accent();
}

}  // namespace

std::vector<WishMark> wish_marks(const Document& document) {
  std::vector<WishMark> out;
  const auto snapshot = document.snapshot();
  const auto& layout = document.layout();
  const std::vector<Wish>& wishes = document.wishes().list();
  for (size_t i = 0; i < wishes.size() && out.size() < kMostMarks; ++i) {
    const bool conflicts = layout && layout->entries.count(i);
    if (!conflicts && !is_selected(document, i)) continue;
    const ObjectSnapshot* const a = only_one(*snapshot, wishes[i].a);
    const ObjectSnapshot* const b = only_one(*snapshot, wishes[i].b);
    if (!a || !b) continue;
    const auto from = middle_of(document, *a), to = middle_of(document, *b);
    if (from && to)
      out.push_back({*from, *to, label_of(wishes[i]), wishes[i].weight.has_value(), conflicts});
  }
  return out;
}

void add_arrangement(const Document& document, const Theme& theme, LiveScene& scene) {
  if (const auto& layout = document.layout())
    add_ghosts(*document.snapshot(), layout->members, live_colour(theme.accent(), 0.45f), scene);
  for (const WishMark& mark : wish_marks(document)) {
    const LiveColour colour = live_colour(colour_of(mark, theme));
    scene.overlay.lines.push_back({mark.a, mark.b, colour, 2, Hidden::Shown});
    for (const Vec3& end : {mark.a, mark.b})
      scene.overlay.points.push_back({end, colour, 4, Hidden::Shown});
  }
}

// At the middles of the lines; several at one place one below the other.
void paint_wishes(const Document& document, const Theme& theme, const View& view,
                  const QFontMetrics& font, const PaintLabel& paint_label) {
  std::vector<QRectF> taken;
  for (const WishMark& mark : wish_marks(document)) {
    const auto at = view.project(0.5 * (mark.a + mark.b));
    if (!at) continue;
    const QSizeF size(font.horizontalAdvance(mark.label) + 6, font.height() + 2);
    QRectF box(QPointF(at->x() - 0.5 * size.width(), at->y() - 0.5 * size.height()), size);
    for (const QRectF& other : taken)
      if (box.intersects(other)) box.moveTop(other.bottom());
    taken.push_back(box);
    paint_label(box, mark.label, colour_of(mark, theme));
  }
}

}  // namespace trivet::edit
