#include "apps/edit/window/start_page.h"

#include <QCommandLinkButton>
#include <QFileInfo>
#include <QFont>
#include <QFrame>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QIcon>
#include <QLabel>
#include <QPalette>
#include <QPixmap>
#include <QPushButton>
#include <QScrollArea>
#include <QStringList>
#include <algorithm>
#include <utility>

#include "apps/demo/arranged.h"
#include "apps/demo/demo.h"
#include "apps/edit/window/icons.h"

namespace trivet::edit {
namespace {

constexpr int kWidth = 720;
constexpr int kMostShown = 6;
constexpr QSize kDemoPicture(72, 48);

/// In the resources: 288 x 192 pixels.
QPixmap picture_of(const QString& demo) { return QPixmap(":/demos/" + demo + ".png"); }

QString description_of(const std::string& demo) {
  if (demo == "spoon-saucer") return StartPage::tr("A spoon and its saucer: the first steps");
  if (demo == "breakfast") return StartPage::tr("A breakfast table of 24 objects");
  if (demo == "office1") return StartPage::tr("A tidy office of 16 objects");
  if (demo == "office2") return StartPage::tr("The same office, untidied, with 9 more objects");
  if (demo == "tablecloth") return StartPage::tr("The same table with a cloth that came down");
  if (demo == "desk") return StartPage::tr("A coat over a chair, a paper at an edge, a lead");
  if (demo == "towel") return StartPage::tr("A towel on a peg");
  if (demo == "kitchen") return StartPage::tr("A kitchen unit with drawers and doors");
  if (demo == "table-for-six") return StartPage::tr("A table laid for six");
  if (demo == "tight-table") return StartPage::tr("The same on a smaller table");
  if (demo == "bookcase") return StartPage::tr("Books in rows, a plant and a telephone");
  if (demo == "market") return StartPage::tr("A shop's shelf, filled row by row");
  if (demo == "office3") return StartPage::tr("A desk with everything in view and in reach");
  if (demo == "workshop") return StartPage::tr("A workbench, tools and parts in their zones");
  return {};
}

QLabel* heading(const QString& text) {
  auto* const label = new QLabel(text);
  label->setObjectName("title");
  return label;
}

}  // namespace

StartPage::StartPage(QWidget* parent) : QWidget(parent), m_column(new QVBoxLayout) {
  auto* const inside = new QWidget;
  auto* const row = new QHBoxLayout(inside);
  row->setContentsMargins(24, 24, 24, 24);
  row->addStretch(1);
  row->addLayout(m_column, 100);
  row->addStretch(1);
  auto* const scroll = new QScrollArea;
  scroll->setWidget(inside);
  scroll->setWidgetResizable(true);
  auto* const all = new QVBoxLayout(this);
  all->setContentsMargins(0, 0, 0, 0);
  all->addWidget(scroll);
}

void StartPage::show_choices(const QStringList& recent,
                             const std::vector<Recoverable>& recoverable) {
  delete m_content;
  m_content = new QWidget;
  m_content->setMaximumWidth(kWidth);
  auto* const column = new QVBoxLayout(m_content);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(10);
  add_title(*column);
  for (const Recoverable& session : recoverable) add_recoverable(*column, session);
  add_beginnings(*column);
  add_recent(*column, recent);
  column->addStretch(1);
  m_column->addWidget(m_content);
}

void StartPage::add_title(QVBoxLayout& column) {
  auto* const title = new QLabel("Trivet");
  QFont large = title->font();
  large.setPointSizeF(2.2 * large.pointSizeF());
  large.setBold(true);
  title->setFont(large);
  auto* const what = new QLabel(tr("Lays out 3D objects without interpenetration, at rest."));
  what->setObjectName("faint");
  what->setWordWrap(true);
  column.addWidget(title);
  column.addWidget(what);
}

void StartPage::add_beginnings(QVBoxLayout& column) {
  auto* const grid = new QGridLayout;
  grid->setHorizontalSpacing(24);
  grid->setVerticalSpacing(4);
  grid->setColumnStretch(0, 1);
  grid->setColumnStretch(1, 1);
  grid->addWidget(heading(tr("Begin")), 0, 0);
  grid->addWidget(heading(tr("Demos")), 0, 1);
  int line[2] = {1, 1};
  const auto add = [&](int side, const QIcon& icon, const QString& name, const QString& text,
                       auto&& clicked) {
    auto* const button = new QCommandLinkButton(name, text);
    button->setIcon(icon);
    grid->addWidget(button, line[side]++, side);
    connect(button, &QCommandLinkButton::clicked, this, clicked);
    return button;
  };
  const auto icon_of = [this](Icon icon) {
    return make_icon(icon, palette().color(QPalette::Highlight));
  };
  add(0, icon_of(Icon::New), tr("New scene"), tr("An empty floor"),
      [this] { Q_EMIT new_wanted(); });
  add(0, icon_of(Icon::Open), tr("Open…"), tr("A scene (.glb) or a layout (.json)"),
      [this] { Q_EMIT open_wanted(); });
  add(0, icon_of(Icon::Import), tr("Import models…"),
      tr("Any mesh; or drop files onto this window"), [this] { Q_EMIT import_wanted(); });
  add(0, icon_of(Icon::Put), tr("A table in two minutes"), tr("A tutorial in eight steps"),
      [this] { Q_EMIT help_wanted(); });
  const auto add_demo = [&](int side, const std::string& demo) {
    const QString name = QString::fromStdString(demo);
    add(side, picture_of(name), name, description_of(demo), [this, name] {
      Q_EMIT demo_wanted(name);
    })->setIconSize(kDemoPicture);
  };
  for (const std::string& demo : demo_names()) add_demo(1, demo);
  line[0] = line[1] = std::max(line[0], line[1]);
  grid->addWidget(heading(tr("Demos that arrange themselves by constraints")), line[0]++, 0, 1, 2);
  line[1] = line[0];
  int side = 0;
  for (const std::string& demo : arranged_demo_names())
    add_demo(std::exchange(side, 1 - side), demo);
  column.addLayout(grid);
}

void StartPage::add_recent(QVBoxLayout& column, const QStringList& recent) {
  if (!recent.isEmpty()) column.addWidget(heading(tr("Recent files")));
  for (const QString& file : recent.mid(0, kMostShown)) {
    auto* const link =
        new QLabel(QString("<a href=\"%1\">%2</a>&nbsp;&nbsp; %3")
                       .arg(file.toHtmlEscaped(), QFileInfo(file).fileName().toHtmlEscaped(),
                            QFileInfo(file).path().toHtmlEscaped()));
    link->setTextInteractionFlags(Qt::LinksAccessibleByMouse | Qt::LinksAccessibleByKeyboard);
    column.addWidget(link);
    connect(link, &QLabel::linkActivated, this, &StartPage::file_wanted);
  }
}

void StartPage::add_recoverable(QVBoxLayout& column, const Recoverable& session) {
  auto* const card = new QFrame;
  card->setObjectName("card");
  card->setStyleSheet("#card { border: 1px solid palette(highlight); border-radius: 4px; }");
  auto* const row = new QHBoxLayout(card);
  const QString name = session.file.empty() ? tr("A scene that was never saved")
                                            : QString::fromStdString(session.file);
  auto* const text = new QLabel(tr("%1 was not closed properly; %n steps, the last on %2", nullptr,
                                   static_cast<int>(session.num_steps))
                                    .arg(name, QString::fromStdString(session.when)));
  text->setWordWrap(true);
  auto* const recover = new QPushButton(tr("Recover"));
  auto* const discard = new QPushButton(tr("Discard"));
  row->addWidget(text, 1);
  row->addWidget(recover);
  row->addWidget(discard);
  column.addWidget(card);
  const QString journal = QString::fromStdString(session.journal);
  connect(recover, &QPushButton::clicked, this,
          [this, journal] { Q_EMIT recovery_wanted(journal); });
  connect(discard, &QPushButton::clicked, this,
          [this, journal] { Q_EMIT discard_wanted(journal); });
}

}  // namespace trivet::edit
