#include "apps/edit_by_hand/at_work.h"

#include <QFile>
#include <QProcess>
#include <cstdio>

#include "apps/edit_document/boxes.h"
#include "apps/edit_document/scene_checks.h"

namespace trivet::edit::test {
namespace {

const QSize kSmall(1280, 800), kLarge(2560, 1440);

QByteArray bytes_of(const QString& file) {
  QFile in(file);
  return in.open(QIODevice::ReadOnly) ? in.readAll() : QByteArray();
}

}  // namespace

AtWork::AtWork(Document& document, MainWindow& window, User& user, const QString& folder)
    : m_document(document), m_window(window), m_user(user), m_folder(folder) {}

// --- before the work -----------------------------------------------------------------------------

void AtWork::new_scene() {
  m_document.new_scene();
  QVERIFY(m_user.wait());
}

void AtWork::write_model(const QString& name, const std::vector<Aabb>& boxes) {
  write_boxes((m_folder + "/" + name + ".obj").toStdString(), boxes);
}

void AtWork::place(const std::string& name, const QString& model, const Vec3& at, bool fixed) {
  m_user.import_model(m_folder + "/" + model, name, at, fixed);
}

void AtWork::begin(const QString& job, const Aabb& shown) {
  m_job = job;
  m_document.select({});
  m_window.toolbox().take(ToolKind::Select);
  view().frame(shown);
  QVERIFY(m_user.wait());
  m_user.look(job + "_before");
  m_bytes = bytes_of(QString::fromStdString(save(job + "_before")));
  QVERIFY(!m_bytes.isEmpty());
  m_before = m_user.effort();
  m_steps = m_document.history().num_done;
}

// --- the work ------------------------------------------------------------------------------------

Vec3 AtWork::on(const std::string& name, const Vec2& at) {
  return {at.x(), at.y(), box(name).upper.z()};
}

bool AtWork::is_at_rest(const std::string& name) {
  return m_user.object(name).state == ObjectState::Stable;
}

bool AtWork::gesture(const std::function<void()>& act) {
  const std::uint64_t before = fingerprint(*m_document.snapshot());
  const size_t steps = m_document.history().num_done;
  act();
  [&] {
    QVERIFY(m_user.wait());
    QVERIFY2(m_window.toolbox().current() == ToolKind::Select, "no tool is taken");
    QVERIFY2(m_document.history().num_done == steps + 1,
             qPrintable("a gesture is one step: " + m_window.message_bar().text()));
    const std::uint64_t after = fingerprint(*m_document.snapshot());
    const Selection selection = m_document.selection();
    m_document.undo();
    QVERIFY(m_document.wait_until_idle(kPatienceMs));
    QCOMPARE(fingerprint(*m_document.snapshot()), before);
    m_document.redo();
    QVERIFY(m_document.wait_until_idle(kPatienceMs));
    QCOMPARE(fingerprint(*m_document.snapshot()), after);
    m_document.select(selection);
    QVERIFY(m_user.wait());
  }();
  return !QTest::currentTestFailed();
}

void AtWork::drag(const std::string& name, const Vec3& to) {
  const Vec3 centre = m_user.object(name).centre_of_mass();
  const QPoint foot =
      m_user.pixel(WindowKind::Perspective, {centre.x(), centre.y(), box(name).lower.z()});
  const QPoint from = m_user.pixel_on(name, WindowKind::Perspective);
  const QPoint end = from + m_user.pixel(WindowKind::Perspective, to) - foot;
  QVERIFY2(view().rect().contains(end), ("the goal of " + name + " is beside the view").c_str());
  gesture([&] { m_user.drag(view(), from, end); });
}

void AtWork::click_on(const std::string& name, Qt::KeyboardModifiers modifiers) {
  m_user.click(view(), m_user.pixel_on(name, WindowKind::Perspective), modifiers);
}

// --- after the work ------------------------------------------------------------------------------

User::Effort AtWork::effort() const {
  const User::Effort& now = m_user.effort();
  return {now.clicks - m_before.clicks, now.drags - m_before.drags, now.keys - m_before.keys};
}

std::string AtWork::save(const QString& name) {
  const std::string file = (m_folder + "/" + name + ".glb").toStdString();
  m_document.save_as(file);
  return m_document.wait_until_idle(kPatienceMs) ? file : std::string();
}

void AtWork::end() {
  const User::Effort spent = effort();
  std::printf("%s: %d clicks, %d drags, %d keys\n", qPrintable(m_job), spent.clicks, spent.drags,
              spent.keys);
  for (const QSize& size : {kLarge, kSmall}) {
    m_window.resize(size);
    for (const bool dark : {true, false}) {
      m_window.set_dark(dark);
      QVERIFY(m_user.wait());
      m_user.look(QString("%1_%2_%3").arg(m_job).arg(size.width()).arg(dark ? "dark" : "light"));
    }
  }
  QProcess check;
  check.start(TRIVET_PROGRAM, {"check", QString::fromStdString(save(m_job + "_after"))});
  QVERIFY(check.waitForFinished(kPatienceMs));
  QVERIFY2(check.exitCode() == 0, check.readAllStandardError() + check.readAllStandardOutput());
  m_document.go_to_step(m_steps);
  QVERIFY(m_document.wait_until_idle(kPatienceMs));
  QCOMPARE(bytes_of(QString::fromStdString(save(m_job + "_undone"))), m_bytes);
}

}  // namespace trivet::edit::test
