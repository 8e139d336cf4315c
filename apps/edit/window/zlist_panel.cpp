#include "apps/edit/window/zlist_panel.h"

#include <QAbstractItemView>
#include <QColor>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QIcon>
#include <QImage>
#include <QLocale>
#include <QPainter>
#include <QPalette>
#include <QPen>
#include <QPixmap>
#include <QSizePolicy>
#include <QVBoxLayout>
#include <algorithm>

#include "raster/zlist/depth_picture.h"

namespace trivet::edit {
namespace {

constexpr int kMargin = 10, kBarHeight = 8, kCrossLength = 5;

QString number(double x) { return QLocale().toString(x, 'g', 4); }

QString unit_of(const Motion& motion) {
  return motion.kind == Motion::Kind::Translation ? QObject::tr(" mm") : QStringLiteral("°");
}

QString time_text(const Motion& motion, double time) {
  return time < kInfinity ? number(shown_time(motion, time)) + unit_of(motion)
                          : QObject::tr("none");
}

QImage image_of(const DepthPicture& picture, DepthShow show, int magnify) {
  const auto rgba = picture.paint(show, magnify);
  return QImage(rgba.data(), magnify * picture.width(), magnify * picture.height(),
                QImage::Format_RGBA8888)
      .copy();
}

void draw_scale(QPainter& painter, const QRect& bar, const std::array<double, 2>& range,
                const QString& unit, const QColor& text) {
  for (int i = 0; i < bar.width(); ++i) {
    const Rgb c = scale_colour((i + 0.5) / bar.width());
    painter.fillRect(bar.left() + i, bar.top(), 1, bar.height(), QColor(c[0], c[1], c[2]));
  }
  painter.setPen(text);
  const QRect below(bar.left(), bar.bottom() + 2, bar.width(), painter.fontMetrics().height());
  painter.drawText(below, Qt::AlignLeft, number(range[0]));
  painter.drawText(below, Qt::AlignHCenter, number(0.5 * (range[0] + range[1])));
  painter.drawText(below, Qt::AlignRight, number(range[1]) + unit);
}

// A white cross with a black rim. The middle is left open for the outlines of doubtful pixels
// there.
void draw_cross(QPainter& painter, const QPoint& at, int magnify) {
  const int begin = 3 * magnify;
  for (const auto& [width, colour] : {std::pair(3, Qt::black), std::pair(1, Qt::white)}) {
    painter.setPen(QPen(colour, width));
    for (const QPoint& way : {QPoint(1, 0), QPoint(-1, 0), QPoint(0, 1), QPoint(0, -1)})
      painter.drawLine(at + begin * way, at + (begin + kCrossLength) * way);
  }
}

QString contact_text(const ZListView& view) {
  const FirstContact& contact = view.lists.contact;
  if (contact.status == FirstContact::Status::Free) return QObject::tr("nothing stops it");
  const QString name = QString::fromStdString(view.touched);
  if (contact.status == FirstContact::Status::Crossing)
    return QObject::tr("inside %1 from the start").arg(name);
  return QObject::tr("stops at <b>%1</b> after <b>%2</b>")
      .arg(name.toHtmlEscaped(), time_text(view.motion, contact.time));
}

QString summary_of(const ZListView& view) {
  const MotionZLists& lists = view.lists;
  const MotionDepths& depths = lists.depths;
  QString out = contact_text(view);
  out += QObject::tr(" · not before %1, at the latest %2")
             .arg(time_text(view.motion, lists.lower()), time_text(view.motion, lists.upper()));
  out += QObject::tr(" · %1 of %2 pixels doubtful").arg(depths.num_doubtful).arg(depths.num_pixels);
  const int num_pairs = static_cast<int>(lists.candidates.work.face_pairs);
  out += QObject::tr(" · %n pairs of faces by %1, %2 confirmed", nullptr, num_pairs)
             .arg(QString::fromStdString(view.finder).toHtmlEscaped())
             .arg(lists.num_confirmed);
  return out + QObject::tr(" · %1 ms").arg(QLocale().toString(view.milliseconds, 'f', 1));
}

QIcon swatch(const QColor& colour) {
  QPixmap out(10, 10);
  out.fill(colour);
  return out;
}

}  // namespace

DepthImages::DepthImages(QWidget* parent) : QWidget(parent) {
  setMinimumSize(420, 120);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
}

void DepthImages::show_view(std::shared_ptr<const ZListView> view) {
  m_view = std::move(view);
  update();
}

void DepthImages::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  const QColor text = palette().color(QPalette::WindowText);
  painter.setPen(text);
  if (!m_view || m_view->lists.depths.frame.empty()) {
    painter.drawText(rect().adjusted(kMargin, 0, -kMargin, 0), Qt::AlignCenter | Qt::TextWordWrap,
                     m_view ? tr("No other object is in the way of this motion.")
                            : tr("Drag an object, or move the mouse with Put: the depths of its "
                                 "motion appear here."));
    return;
  }
  const DepthPicture picture(m_view->lists.depths);
  const int line = painter.fontMetrics().height(), below = kBarHeight + line + 6;
  const int room = (width() - 4 * kMargin) / 3, high = height() - line - below - kMargin;
  const int magnify = std::max(1, std::min(room / picture.width(), high / picture.height()));
  const QSize size(magnify * picture.width(), magnify * picture.height());
  const FirstContact& contact = m_view->lists.contact;
  const bool touches =
      contact.status == FirstContact::Status::Contact && contact.fixed != FirstContact::kFloor;
  const auto met = touches ? picture.seen_at(contact.point) : std::nullopt;
  int left = kMargin;
  for (const auto& [show, title] :
       {std::pair(DepthShow::Moving, tr("Moving front")),
        std::pair(DepthShow::Fixed, tr("Fixed front")), std::pair(DepthShow::Gap, tr("Gap"))}) {
    painter.setPen(text);
    painter.drawText(QRect(left, 0, room, line), Qt::AlignLeft, title);
    const QRect at(QPoint(left + (room - size.width()) / 2, line + 3), size);
    painter.drawImage(at.topLeft(), image_of(picture, show, magnify));
    painter.setPen(palette().color(QPalette::PlaceholderText));
    painter.drawRect(at.adjusted(-1, -1, 0, 0));
    if (met)
      draw_cross(
          painter,
          at.topLeft() + magnify * QPoint((*met)[0], (*met)[1]) + QPoint(magnify / 2, magnify / 2),
          magnify);
    if (const auto range = picture.range(show))
      draw_scale(painter, QRect(left, at.bottom() + 6, room, kBarHeight), *range,
                 unit_of(m_view->motion), text);
    left += room + kMargin;
  }
}

ZListPanel::ZListPanel(Document& document, QWidget* parent)
    : QWidget(parent),
      m_document(document),
      m_summary(new QLabel),
      m_images(new DepthImages),
      m_pairs(new QTreeWidget) {
  m_summary->setWordWrap(true);
  m_summary->setTextFormat(Qt::RichText);
  m_summary->setContentsMargins(kMargin, 2, kMargin, 0);
  m_summary->setAlignment(Qt::AlignLeft | Qt::AlignTop);
  // Views that grow or shrink by a line would move the scene under the mouse.
  m_summary->setFixedHeight(2 * m_summary->fontMetrics().lineSpacing() + 4);
  m_pairs->setObjectName("zlist_pairs");
  m_pairs->setHeaderLabels({tr("Moving face"), tr("Fixed face"), tr("Not before")});
  m_pairs->setRootIsDecorated(false);
  m_pairs->setUniformRowHeights(true);
  m_pairs->setSelectionMode(QAbstractItemView::NoSelection);
  m_pairs->setFocusPolicy(Qt::NoFocus);
  m_pairs->header()->setSectionResizeMode(QHeaderView::Stretch);
  m_pairs->setMinimumWidth(300);
  auto* const row = new QHBoxLayout;
  row->setSpacing(0);
  row->addWidget(m_images, 3);
  row->addWidget(m_pairs, 2);
  auto* const column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 4);
  column->setSpacing(4);
  column->addWidget(m_summary);
  column->addLayout(row, 1);
  connect(&m_document, &Document::zlists_changed, this, &ZListPanel::follow);
}

void ZListPanel::set_theme(const Theme& theme) {
  m_pairs->headerItem()->setIcon(0, swatch(theme.moving_face()));
  m_pairs->headerItem()->setIcon(1, swatch(theme.fixed_face()));
  m_images->update();
}

void ZListPanel::follow() {
  const std::shared_ptr<const ZListView> view = m_document.zlists();
  m_images->show_view(view);
  m_summary->setText(view ? summary_of(*view) : QString());
  m_summary->setToolTip(m_summary->text());
  if (view)
    list_pairs(*view);
  else
    m_pairs->clear();
}

void ZListPanel::list_pairs(const ZListView& view) {
  const auto face_text = [](const FaceName& face) {
    return QString::fromStdString(face.object) + " " + QString::number(face.face);
  };
  m_pairs->clear();
  QList<QTreeWidgetItem*> items;
  for (const ConfirmedPair& pair : view.confirmed)
    items << new QTreeWidgetItem({face_text(pair.moving), face_text(pair.fixed),
                                  number(pair.not_before) + unit_of(view.motion)});
  m_pairs->addTopLevelItems(items);
}

}  // namespace trivet::edit
