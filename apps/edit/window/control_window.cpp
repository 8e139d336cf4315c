#include "apps/edit/window/control_window.h"

#include <QFileInfo>
#include <QPixmap>
#include <QSignalBlocker>
#include <QStringList>
#include <QVBoxLayout>

#include "apps/demo/demo.h"

namespace trivet::edit {
namespace {

constexpr int kFileRole = Qt::UserRole, kDemoRole = Qt::UserRole + 1;
constexpr QSize kPicture(48, 32);  // of a demo

}  // namespace

ControlWindow::ControlWindow(Document& document, Toolbox& toolbox, QWidget* parent)
    : QSplitter(Qt::Vertical, parent),
      m_document(document),
      m_outliner(new Outliner(document)),
      m_search(new QLineEdit),
      m_properties(new Properties(document)),
      m_operations(new OperationPanel(document, toolbox)),
      m_history(new QListWidget),
      m_files(new QListWidget),
      m_tabs(new QTabWidget) {
  m_tabs->setDocumentMode(true);
  m_tabs->addTab(m_properties, tr("Properties"));
  m_tabs->addTab(m_operations, tr("Operation"));
  m_tabs->addTab(m_history, tr("History"));
  m_tabs->addTab(m_files, tr("Files"));
  m_history->setObjectName("history");
  m_history->setToolTip(tr("Click a step to go back or forward to it"));
  m_history->setUniformItemSizes(true);
  m_files->setIconSize(kPicture);
  addWidget(make_search());
  addWidget(m_tabs);
  setChildrenCollapsible(false);
  setHandleWidth(1);
  setSizes({145, 285});
  setStretchFactor(0, 2), setStretchFactor(1, 1);
  setMinimumWidth(250);
  connect(&m_document, &Document::history_changed, this, &ControlWindow::show_history);
  const auto go_to = [this](QListWidgetItem* item) {
    m_document.go_to_step(static_cast<size_t>(m_history->row(item)));
  };
  connect(m_history, &QListWidget::itemClicked, this, go_to);
  connect(m_history, &QListWidget::itemActivated, this, go_to);
  connect(m_files, &QListWidget::itemActivated, this,
          [this](QListWidgetItem* item) { choose_file(*item); });
  show_history();
}

/// The outliner below its search field.
QWidget* ControlWindow::make_search() {
  auto* const both = new QWidget;
  auto* const column = new QVBoxLayout(both);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  m_search->setObjectName("search");
  m_search->setPlaceholderText(tr("Search objects (/)"));
  m_search->setToolTip(tr("Part of a name; Return selects all objects that are found"));
  m_search->setClearButtonEnabled(true);
  column->addWidget(m_search);
  column->addWidget(m_outliner, 1);
  connect(m_search, &QLineEdit::textChanged, m_outliner, &Outliner::set_filter);
  connect(m_search, &QLineEdit::returnPressed, m_outliner, &Outliner::select_found);
  return both;
}

void ControlWindow::set_theme(const Theme& theme) {
  m_theme = theme;
  m_outliner->set_theme(theme);
  show_history();
}

void ControlWindow::show_history() {
  const QSignalBlocker blocker(m_history);
  const History& history = m_document.history();
  m_history->clear();
  m_history->addItem(tr("Start"));
  for (const std::string& step : history.steps) m_history->addItem(QString::fromStdString(step));
  for (int row = static_cast<int>(history.num_done) + 1; row < m_history->count(); ++row)
    m_history->item(row)->setForeground(m_theme.faint_text());
  m_history->setCurrentRow(static_cast<int>(history.num_done));
}

void ControlWindow::show_files(const QStringList& recent) {
  m_files->clear();
  const auto heading = [this](const QString& text) {
    auto* const item = new QListWidgetItem(text, m_files);
    item->setFlags(Qt::NoItemFlags);
  };
  heading(tr("Demos"));
  for (const std::string& demo : demo_names()) {
    const QString name = QString::fromStdString(demo);
    auto* const item = new QListWidgetItem(QPixmap(":/demos/" + name + ".png"), name, m_files);
    item->setData(kDemoRole, name);
  }
  if (!recent.isEmpty()) heading(tr("Recent"));
  for (const QString& file : recent) {
    auto* const item = new QListWidgetItem("   " + QFileInfo(file).fileName(), m_files);
    item->setData(kFileRole, file);
    item->setToolTip(file);
  }
}

void ControlWindow::choose_file(const QListWidgetItem& item) {
  if (const QString demo = item.data(kDemoRole).toString(); !demo.isEmpty())
    Q_EMIT demo_wanted(demo);
  if (const QString file = item.data(kFileRole).toString(); !file.isEmpty())
    Q_EMIT file_wanted(file);
}

}  // namespace trivet::edit
