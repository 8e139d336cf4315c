#include "apps/edit/window/workspace.h"

#include <QSettings>
#include <QVBoxLayout>
#include <algorithm>

namespace trivet::edit {
namespace {

QString layout_key(const char* what) { return QString("window/") + what; }

}  // namespace

Workspace::Workspace(Document& document, Toolbox& toolbox, SceneDrawing& drawing)
    : m_document(document),
      m_toolbox(toolbox),
      m_drawing(drawing),
      m_columns(new QSplitter(Qt::Horizontal)),
      m_left(new QSplitter(Qt::Vertical)),
      m_right(new QSplitter(Qt::Vertical)),
      m_control(new ControlWindow(document, toolbox)),
      m_perspective(make_view(WindowKind::Perspective)),
      m_three(make_view(WindowKind::ThreeView)),
      m_constraint(make_view(WindowKind::Constraint)),
      m_message_bar(new MessageBar(this)) {
  m_constraint->set_camera(ViewCamera::orthographic(-Vec3::UnitZ(), Vec3::UnitY()));
  connect(m_constraint, &SceneView::camera_moved, this, [this] { m_constraint_is_free = true; });
  make_frames();
  arrange();
  make_section_buttons();
  connect(m_message_bar, &MessageBar::dismissed, &m_drawing, &SceneDrawing::put_out_lights);
}

// The views use the painter until they are gone.
Workspace::~Workspace() { delete m_columns; }

SceneView* Workspace::make_view(WindowKind kind) {
  auto* const view = new SceneView(kind, m_document, m_toolbox, m_drawing, m_painter);
  connect(view, &SceneView::pointed, this, &Workspace::pointed);
  connect(view, &SceneView::context_menu_wanted, this, &Workspace::context_menu_wanted);
  return view;
}

void Workspace::make_frames() {
  m_frames = {
      new ViewFrame(tr("Control"), m_control), new ViewFrame(tr("Perspective"), m_perspective),
      new ViewFrame(tr("Three-view"), m_three), new ViewFrame(tr("Constraint"), m_constraint)};
  for (ViewFrame* const frame : m_frames)
    connect(frame, &ViewFrame::maximise_wanted, this, [this, frame] { maximise(frame); });
}

void Workspace::arrange() {
  m_left->addWidget(m_frames[0]), m_left->addWidget(m_frames[2]);
  m_right->addWidget(m_frames[1]), m_right->addWidget(m_frames[3]);
  m_columns->addWidget(m_left), m_columns->addWidget(m_right);
  for (QSplitter* const splitter : {m_left, m_right, m_columns}) {
    splitter->setHandleWidth(3);
    splitter->setChildrenCollapsible(false);
  }
  auto* const column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(m_columns);
}

SceneView& Workspace::view(WindowKind kind) const {
  return kind == WindowKind::Perspective  ? *m_perspective
         : kind == WindowKind::Constraint ? *m_constraint
                                          : *m_three;
}

SceneView& Workspace::active_view() const {
  for (SceneView* const view : {m_three, m_constraint, m_perspective})
    if (view->underMouse()) return *view;
  for (SceneView* const view : {m_three, m_constraint})
    if (view->hasFocus()) return *view;
  return *m_perspective;
}

SceneView* Workspace::view_at(const QPoint& at) const {
  for (SceneView* const view : views())
    if (view->isVisible() && view->rect().contains(view->mapFrom(window(), at))) return view;
  return nullptr;
}

void Workspace::set_theme(const Theme& theme) {
  m_message_bar->set_theme(theme);
  m_control->set_theme(theme);
}

void Workspace::follow_tool() {
  for (SceneView* const view : views()) view->follow_tool();
}

// --- messages ------------------------------------------------------------------------------------

void Workspace::show_message(const Message& message) {
  m_message_bar->show_message(message);
  place_message_bar();
}

void Workspace::place_message_bar() {
  if (!m_message_bar->isVisibleTo(this)) return;
  constexpr int kWidest = 760, kMargin = 12;
  QWidget* const over = m_maximised ? static_cast<QWidget*>(m_maximised) : m_frames[1];
  const QPoint corner = over->mapTo(this, QPoint(0, 26));
  const int width = std::min(kWidest, over->width() - 2 * kMargin);
  m_message_bar->set_width(std::max(width, 200));
  m_message_bar->move(corner + QPoint((over->width() - m_message_bar->width()) / 2, kMargin));
  m_message_bar->raise();
}

void Workspace::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  place_message_bar();
}

// --- sections ------------------------------------------------------------------------------------

void Workspace::make_section_buttons() {
  for (ViewFrame* const frame : m_frames) {
    auto* const view = qobject_cast<SceneView*>(frame->content());
    if (!view) continue;
    auto* const button = new QToolButton;
    button->setObjectName("section");
    button->setText(tr("Section"));
    button->setCheckable(true);
    button->setAutoRaise(true);
    button->setFocusPolicy(Qt::NoFocus);
    button->setToolTip(view == m_constraint
                           ? tr("Cut away what hides the active object (X); Control and the wheel "
                                "move the plane")
                           : tr("Cut away what stands in front of the active object (X); Control "
                                "and the wheel move the plane"));
    connect(button, &QToolButton::clicked, this, [this, view] { toggle_section(*view); });
    frame->add_to_title(button);
    m_section_buttons[view] = button;
  }
  // Under a shelf's board the constraint window would show nothing but the board.
  toggle_section(*m_constraint);
}

void Workspace::toggle_section(SceneView& view) {
  Section section;
  section.on = !view.section().on;
  section.only_if_hidden = &view == m_constraint;
  view.set_section(section);
  m_section_buttons.at(&view)->setChecked(section.on);
}

// --- sizes ---------------------------------------------------------------------------------------

void Workspace::maximise(ViewFrame* frame) {
  m_maximised = m_maximised == frame ? nullptr : frame;
  for (ViewFrame* const other : m_frames) other->setVisible(!m_maximised || other == m_maximised);
  m_left->setVisible(!m_maximised || m_left->indexOf(m_maximised) >= 0);
  m_right->setVisible(!m_maximised || m_right->indexOf(m_maximised) >= 0);
  place_message_bar();
}

void Workspace::toggle_maximised() {
  ViewFrame* frame = m_frames[0];
  for (ViewFrame* const other : m_frames)
    if (other->content() == &active_view()) frame = other;
  maximise(m_maximised ? m_maximised : frame);
}

void Workspace::reset_layout() {
  if (m_maximised) maximise(m_maximised);
  m_columns->setSizes({340, 940});
  m_left->setSizes({465, 195});
  m_right->setSizes({400, 260});
}

void Workspace::restore_layout() {
  const QSettings settings;
  reset_layout();
  m_columns->restoreState(settings.value(layout_key("columns")).toByteArray());
  m_left->restoreState(settings.value(layout_key("left")).toByteArray());
  m_right->restoreState(settings.value(layout_key("right")).toByteArray());
  const QString shown = settings.value("view/three_view", "top").toString();
  aim_three_view(shown == "side" || shown == "front" ? shown : "top");
}

void Workspace::save_layout() const {
  QSettings settings;
  settings.setValue(layout_key("columns"), m_columns->saveState());
  settings.setValue(layout_key("left"), m_left->saveState());
  settings.setValue(layout_key("right"), m_right->saveState());
  settings.setValue("view/three_view", m_three_shows);
}

}  // namespace trivet::edit
