#include "apps/edit/window/message_bar.h"

#include <QColor>
#include <QFont>
#include <QHBoxLayout>

namespace trivet::edit {
namespace {

constexpr int kInformationMs = 6000;

}  // namespace

MessageBar::MessageBar(QWidget* parent)
    : QFrame(parent), m_heading(new QLabel), m_text(new QLabel) {
  setObjectName("message_bar");
  auto* const row = new QHBoxLayout(this);
  row->setContentsMargins(12, 6, 6, 6);
  row->setSpacing(10);
  QFont bold = m_heading->font();
  bold.setBold(true);
  m_heading->setFont(bold);
  m_text->setWordWrap(true);
  m_text->setTextInteractionFlags(Qt::TextSelectableByMouse);
  auto* const close = new QToolButton;
  close->setText(QStringLiteral("×"));
  close->setAutoRaise(true);
  close->setToolTip(tr("Close (Escape)"));
  row->addWidget(m_heading);
  row->addWidget(m_text, 1);
  row->addWidget(close);
  connect(close, &QToolButton::clicked, this, &MessageBar::dismiss);
  m_leave.setSingleShot(true);
  m_leave.setInterval(kInformationMs);
  connect(&m_leave, &QTimer::timeout, this, &MessageBar::dismiss);
  hide();
}

void MessageBar::set_theme(const Theme& theme) {
  m_theme = theme;
  paint();
}

void MessageBar::paint() {
  const QColor colour = m_kind == Message::Kind::Info      ? m_theme.information()
                        : m_kind == Message::Kind::Warning ? m_theme.warning()
                                                           : m_theme.refused();
  setStyleSheet(QString("#message_bar { background: %1; border: none; border-left: 4px solid %2; }")
                    .arg(m_theme.base().name(), colour.name()));
}

void MessageBar::show_message(const Message& message) {
  m_kind = message.kind;
  m_heading->setText(message.kind == Message::Kind::Refused   ? tr("Refused")
                     : message.kind == Message::Kind::Error   ? tr("Error")
                     : message.kind == Message::Kind::Warning ? tr("Attention")
                                                              : tr("Done"));
  m_text->setText(QString::fromStdString(message.text));
  paint();
  show();
  if (message.kind == Message::Kind::Info || message.kind == Message::Kind::Warning)
    m_leave.start();
  else
    m_leave.stop();
}

void MessageBar::set_width(int width) { resize(width, layout()->totalHeightForWidth(width)); }

void MessageBar::dismiss() {
  if (isHidden()) return;
  hide();
  Q_EMIT dismissed();
}

}  // namespace trivet::edit
