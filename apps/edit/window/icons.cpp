#include "apps/edit/window/icons.h"

#include <QPainter>
#include <QPainterPath>
#include <QPen>
#include <QPixmap>
#include <cmath>
#include <vector>

namespace trivet::edit {
namespace {

/// Strokes and areas on a grid of 20 x 20.
struct Drawing {
  QPainterPath stroke, area;

  void line(std::vector<QPointF> points) {
    stroke.moveTo(points.front());
    for (size_t i = 1; i < points.size(); ++i) stroke.lineTo(points[i]);
  }
  /// A line with a head at its end.
  void arrow(const QPointF& from, const QPointF& to, double head = 3.2) {
    line({from, to});
    const QPointF d = to - from;
    const double length = std::hypot(d.x(), d.y());
    const QPointF u = d / length, n(-u.y(), u.x());
    line({to - head * u + head * n, to, to - head * u - head * n});
  }
  void arc(const QRectF& box, double from_deg, double span_deg) {
    stroke.arcMoveTo(box, from_deg);
    stroke.arcTo(box, from_deg, span_deg);
  }
  void head_at(const QPointF& tip, const QPointF& left, const QPointF& right) {
    line({left, tip, right});
  }
  void box(const QRectF& r) { stroke.addRoundedRect(r, 1, 1); }
  void dot(const QPointF& at, double radius) { area.addEllipse(at, radius, radius); }
  void polygon(const std::vector<QPointF>& points) {
    area.moveTo(points.front());
    for (size_t i = 1; i < points.size(); ++i) area.lineTo(points[i]);
    area.closeSubpath();
  }
};

Drawing tool_drawing(Icon icon) {
  Drawing d;
  switch (icon) {
    case Icon::Select:
      d.polygon({{5, 3}, {15, 11}, {10.5, 11.6}, {13, 16.6}, {11, 17.5}, {8.6, 12.6}, {5, 15.5}});
      break;
    case Icon::Put:
      d.arrow({10, 2.5}, {10, 13}), d.line({{3, 17}, {17, 17}});
      break;
    case Icon::Push:
      d.box({3, 7, 6, 8}), d.arrow({10.5, 11}, {17.5, 11});
      d.line({{2, 17.5}, {18, 17.5}});
      break;
    case Icon::Turn:
      d.line({{3, 17}, {15, 5.5}});
      d.line({{3, 17}, {17.5, 17}});
      d.arc({-8, 6, 22, 22}, 8, 34), d.dot({3, 17}, 1.7);
      break;
    case Icon::PickUp:
      d.arrow({10, 13.5}, {10, 3}), d.line({{3, 17}, {17, 17}});
      break;
    case Icon::Move:
      d.arrow({10, 10}, {10, 2.5}, 2.4), d.arrow({10, 10}, {10, 17.5}, 2.4);
      d.arrow({10, 10}, {2.5, 10}, 2.4), d.arrow({10, 10}, {17.5, 10}, 2.4);
      break;
    case Icon::Rotate:
      d.arc({3.5, 3.5, 13, 13}, 60, 290);
      d.head_at({13.6, 4.6}, {13.2, 8.4}, {17.2, 5.4});
      d.dot({10, 10}, 1.5);
      break;
    case Icon::Drape:
      d.line({{5, 17.5}, {5, 9}, {15, 9}, {15, 17.5}});
      d.line({{2, 14}, {3.4, 6}, {16.6, 6}, {18, 14}});
      d.line({{2, 14},
              {4, 12.4},
              {6, 14},
              {8, 12.4},
              {10, 14},
              {12, 12.4},
              {14, 14},
              {16, 12.4},
              {18, 14}});
      break;
    case Icon::Paint:
      d.line({{17, 3}, {9.5, 10.5}});
      d.polygon({{9.4, 9.2}, {11.2, 11}, {8, 14.6}, {4, 15.5}, {6, 12.4}});
      for (const double x : {3.5, 8.5, 13.5}) d.dot({x, 18}, 1.2);
      break;
    default:
      break;
  }
  return d;
}

Drawing file_drawing(Icon icon) {
  Drawing d;
  switch (icon) {
    case Icon::New:
      d.line({{5, 2.5}, {12, 2.5}, {15.5, 6}, {15.5, 17.5}, {5, 17.5}, {5, 2.5}});
      d.line({{12, 2.5}, {12, 6}, {15.5, 6}});
      break;
    case Icon::Open:
      d.line({{2.5, 16}, {2.5, 4.5}, {7.5, 4.5}, {9.5, 6.5}, {16, 6.5}, {16, 9}});
      d.line({{2.5, 16}, {5.5, 9}, {18, 9}, {15, 16}, {2.5, 16}});
      break;
    case Icon::Save:
      d.line({{3, 3}, {14, 3}, {17, 6}, {17, 17}, {3, 17}, {3, 3}});
      d.box({6.5, 11, 7, 6}), d.line({{6.5, 3.2}, {6.5, 7}, {12.5, 7}, {12.5, 3.2}});
      break;
    case Icon::Import:
      d.arrow({10, 2.5}, {10, 11.5});
      d.line({{3, 11}, {3, 17}, {17, 17}, {17, 11}});
      break;
    case Icon::Picture:
      d.box({2.5, 4, 15, 12.5});
      d.line({{3, 14}, {7.5, 9.5}, {11, 13}, {13.5, 10.8}, {17, 14}});
      d.dot({13.4, 7.6}, 1.4);
      break;
    default:
      break;
  }
  return d;
}

Drawing edit_drawing(Icon icon) {
  Drawing d;
  switch (icon) {
    case Icon::Undo:
    case Icon::Redo:
      d.arc({4, 6, 12, 10}, 90, -200);
      d.line({{10, 6}, {4.2, 6}}), d.head_at({4, 6}, {7, 3}, {7, 9});
      break;
    case Icon::Frame:
      for (const QPointF& c : {QPointF(3, 3), QPointF(17, 3), QPointF(3, 17), QPointF(17, 17)}) {
        const double x = c.x() < 10 ? 4 : -4, y = c.y() < 10 ? 4 : -4;
        d.line({c + QPointF(x, 0), c, c + QPointF(0, y)});
      }
      d.dot({10, 10}, 2.2);
      break;
    case Icon::Maximise:
      d.box({3, 4, 14, 12}), d.line({{3, 6.5}, {17, 6.5}});
      break;
    case Icon::Snap:  // a magnet
      d.line({{4.5, 3}, {4.5, 10}}), d.line({{15.5, 3}, {15.5, 10}});
      d.arc({4.5, 4.5, 11, 11}, 180, 180);
      d.line({{2.5, 5.5}, {6.5, 5.5}}), d.line({{13.5, 5.5}, {17.5, 5.5}});
      break;
    default:
      break;
  }
  return d;
}

Drawing state_drawing(Icon icon) {
  Drawing d;
  switch (icon) {
    case Icon::Stable:
      d.line({{4.5, 10.5}, {8.5, 14.5}, {15.5, 6}});
      break;
    case Icon::Fixed:
      d.line({{4, 16}, {16, 16}}), d.line({{10, 16}, {10, 8}}), d.dot({10, 6}, 3);
      break;
    case Icon::Held:
      d.line({{10, 3}, {10, 10}}), d.arc({6, 8, 8, 8}, 90, -270);
      break;
    case Icon::Unsupported:
      d.arrow({10, 3}, {10, 16});
      break;
    case Icon::Invalid:
      d.line({{5, 5}, {15, 15}}), d.line({{15, 5}, {5, 15}});
      break;
    case Icon::Wedged:
      d.line({{4, 4}, {10, 16}, {16, 4}});
      break;
    default:
      d.arc({5, 5, 10, 10}, 0, 360);
      break;
  }
  return d;
}

}  // namespace

QIcon make_icon(Icon icon, const QColor& colour) {
  const Drawing drawing = icon <= Icon::Drape     ? tool_drawing(icon)
                          : icon <= Icon::Picture ? file_drawing(icon)
                          : icon <= Icon::Snap    ? edit_drawing(icon)
                                                  : state_drawing(icon);
  QIcon out;
  for (const int size : {20, 40, 60}) {
    const auto draw = [&](const QColor& shown, QIcon::Mode mode) {
      QPixmap pixmap(size, size);
      pixmap.fill(Qt::transparent);
      QPainter painter(&pixmap);
      painter.setRenderHint(QPainter::Antialiasing);
      painter.scale(size / 20.0, size / 20.0);
      if (icon == Icon::Redo) painter.translate(20, 0), painter.scale(-1, 1);
      painter.setPen(QPen(shown, 1.5, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
      painter.drawPath(drawing.stroke);
      painter.setPen(Qt::NoPen);
      painter.setBrush(shown);
      painter.drawPath(drawing.area);
      painter.end();
      out.addPixmap(pixmap, mode);
    };
    QColor faint = colour;
    faint.setAlpha(80);
    draw(colour, QIcon::Normal);
    draw(faint, QIcon::Disabled);
    draw(Qt::white, QIcon::Selected);  // on the accent colour
  }
  return out;
}

QIcon application_icon() {
  QIcon out;
  for (const int size : {16, 32, 48, 128}) {
    QPixmap pixmap(size, size);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.scale(size / 20.0, size / 20.0);
    painter.setPen(Qt::NoPen);
    painter.setBrush(QColor(38, 108, 200));
    painter.drawRoundedRect(QRectF(0.5, 0.5, 19, 19), 4, 4);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(Qt::white, 1.8, Qt::SolidLine, Qt::RoundCap));
    painter.drawEllipse(QRectF(3.5, 5, 13, 4.5));
    painter.drawLine(QPointF(5, 9), QPointF(3.5, 15.5));
    painter.drawLine(QPointF(10, 9.6), QPointF(10, 17));
    painter.drawLine(QPointF(15, 9), QPointF(16.5, 15.5));
    painter.end();
    out.addPixmap(pixmap);
  }
  return out;
}

}  // namespace trivet::edit
