#include "apps/edit/window/view_frame.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QSizePolicy>
#include <QVBoxLayout>

namespace trivet::edit {

ViewFrame::ViewFrame(const QString& title, QWidget* content, QWidget* parent)
    : QFrame(parent),
      m_bar(new QWidget),
      m_content(content),
      m_title(new QLabel(title)),
      m_note(new QLabel) {
  auto* const bar = new QHBoxLayout(m_bar);
  bar->setContentsMargins(10, 0, 6, 0);
  bar->setSpacing(8);
  m_title->setObjectName("title");
  m_note->setObjectName("faint");
  m_note->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  bar->addWidget(m_title);
  bar->addWidget(m_note, 1);
  m_bar->setFixedHeight(26);
  m_bar->setToolTip(tr("Double click to maximise this window, and to restore it"));
  m_bar->installEventFilter(this);
  auto* const column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  column->addWidget(m_bar);
  column->addWidget(m_content, 1);
}

void ViewFrame::add_to_title(QWidget* widget) { m_bar->layout()->addWidget(widget); }

void ViewFrame::set_note(const QString& note) { m_note->setText(note); }

bool ViewFrame::eventFilter(QObject* object, QEvent* event) {
  if (object == m_bar && event->type() == QEvent::MouseButtonDblClick) Q_EMIT maximise_wanted();
  return QFrame::eventFilter(object, event);
}

}  // namespace trivet::edit
