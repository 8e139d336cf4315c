// Wishes and previewed arrangements in the views: lines with labels between objects, ghosts of all
// things.
#pragma once

#include <QPainter>
#include <functional>

#include "apps/edit/document/document.h"
#include "apps/edit/tools/view.h"
#include "apps/edit/window/theme.h"

namespace trivet::edit {

/// A wish between two objects that stand, or are previewed; those of the selection, or of a
/// conflict.
struct WishMark {
  Vec3 a, b;  // middles of their boxes, world
  QString label;
  bool is_soft = false, conflicts = false;
};
std::vector<WishMark> wish_marks(const Document& document);

/// Lines of the marks, and ghosts of what is previewed.
void add_arrangement(const Document& document, const Theme& theme, LiveScene& scene);

using PaintLabel =
    std::function<void(const QRectF& box, const QString& text, const QColor& colour)>;
void paint_wishes(const Document& document, const Theme& theme, const View& view,
                  const QFontMetrics& font, const PaintLabel& paint_label);

}  // namespace trivet::edit
