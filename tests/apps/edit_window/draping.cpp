#include "apps/edit_window/draping.h"

#include <QComboBox>

#include "apps/demo/demo.h"
#include "apps/edit_document/boxes.h"
#include "core/flex/flexible.h"
#include "core/io/export.h"

namespace trivet::edit::test {
namespace {

using Window = WindowKind;

bool has_object(const Document& document, const char* name) {
  return document.snapshot()->find(name) != nullptr;
}

void take_material(MainWindow& window, const char* material) {
  auto* const materials = window.findChild<QComboBox*>("drape material");
  QVERIFY(materials);
  materials->setCurrentIndex(materials->findData(QString(material)));
  QCOMPARE(window.toolbox().options().drape_material, std::string(material));
}

void stop_it(Document& document, MainWindow& window, User& user, const Vec3& at) {
  window.toolbox().options().drape_cell = 0.006;  // it would take long
  user.click(Window::Perspective, at);
  QTRY_VERIFY_WITH_TIMEOUT(document.snapshot()->falling, kPatienceMs);
  QTest::qWait(2000);
  user.look("napkin_falls");
  user.press_key(Qt::Key_Escape);
  QVERIFY(user.wait());
  QVERIFY(!has_object(document, "cotton"));
  QVERIFY(!document.snapshot()->falling);
  QVERIFY2(window.message_bar().text().contains("cancelled"),
           qPrintable(window.message_bar().text()));
  user.look("napkin_stopped");
}

// As a file that a user would have.
void import_lamp(User& user, const QString& folder) {
  const DemoLayout office = make_demo("office1");
  ExportObject object;
  object.name = "lamp";
  object.model = std::make_shared<Model>(office.model("lamp.glb"));
  QVERIFY(QDir().mkpath(folder));
  const QString file = folder + "/lamp.glb";
  write_scene({{object}, {}}, file.toStdString());
  user.import_model(file, "lamp", Vec3(0, 0, 0.05));
}

void import_socket(User& user, const QString& folder) {
  const QString file = folder + "/socket.obj";
  write_boxes(file.toStdString(), {{{-0.04, -0.04, 0}, {0.04, 0.04, 0.04}}});
  user.import_model(file, "socket", Vec3(0.5, 0, 1e-5), true);
}

Vec3 end_of_lead(User& user) {
  const Object& lead = user.object("lead");
  const FlexTie& tie = lead.flexible->ties.front();
  return lead.world_from_object().apply(lead.flexible->vertices[tie.vertex]);
}

}  // namespace

void drape_a_napkin(Document& document, MainWindow& window, User& user) {
  document.new_scene();
  QVERIFY(user.wait());
  window.open_demo("breakfast");
  QVERIFY(user.wait());
  user.press_key(Qt::Key_D);
  QVERIFY(window.toolbox().current() == ToolKind::Drape);
  take_material(window, "cotton");
  window.toolbox().options().drape_width = window.toolbox().options().drape_length = 0.36;
  const Vec3 at = world_box(user.object("bowl")).centre() + Vec3(0, 0, 0.04);
  user.move_to(window.view(Window::Perspective), user.pixel(Window::Perspective, at));
  user.look("napkin_before");
  stop_it(document, window, user, at);
  window.toolbox().options().drape_cell = 0.03;
  const size_t steps = document.history().num_done;
  user.click(Window::Perspective, at);
  QVERIFY(user.wait());
  QVERIFY2(has_object(document, "cotton"), qPrintable(window.message_bar().text()));
  QVERIFY(user.object("cotton").flexible);
  QCOMPARE(document.history().num_done, steps + 1);
  user.look("napkin_at_rest");
  user.press_key(Qt::Key_Z, Qt::ControlModifier);
  QVERIFY(user.wait());
  QVERIFY(!has_object(document, "cotton"));
}

void lay_a_lead(Document& document, MainWindow& window, User& user, const QString& folder) {
  document.new_scene();
  QVERIFY(user.wait());
  import_lamp(user, folder);
  import_socket(user, folder);
  window.view(Window::Perspective).frame(document.snapshot()->box());
  user.take("drape");
  take_material(window, "lead");
  user.click(Window::Perspective, Vec3(0, -0.05, 0.015));
  user.click(Window::Perspective, Vec3(0.3, -0.15, 0));
  user.move_to(window.view(Window::Perspective),
               user.pixel(Window::Perspective, Vec3(0.5, 0, 0.04)));
  user.look("lead_by_clicks");
  user.click(Window::Perspective, Vec3(0.5, 0, 0.04));
  user.press_key(Qt::Key_Return);
  QVERIFY(user.wait());
  QVERIFY2(has_object(document, "lead"), qPrintable(window.message_bar().text()));
  QCOMPARE(user.object("lead").flexible->ties.size(), size_t{2});
  QCOMPARE(user.object("lead").flexible->ties[0].name, std::string("lamp"));
  QCOMPARE(user.object("lead").flexible->ties[1].name, std::string("socket"));
  user.look("lead_at_rest");
  const Vec3 lamp = user.object("lamp").pose.translation, end = end_of_lead(user);
  user.select("lamp");
  user.take("push");
  user.drag(Window::Perspective, Vec3(0, -0.05, 0.015), Vec3(0.1, 0.05, 0.015));
  QVERIFY(user.wait());
  const Vec3 way = user.object("lamp").pose.translation - lamp;
  QVERIFY2(way.norm() > 0.05, qPrintable(window.message_bar().text()));
  QVERIFY((end_of_lead(user) - end - way).norm() < 1e-6);
  user.look("lead_comes_along");
}

}  // namespace trivet::edit::test
