#include "apps/edit_window/zlists_watched.h"

#include <QComboBox>

#include "raster/zlist/depth_picture.h"

namespace trivet::edit::test {
namespace {

/// Number of pixels with the colour that outlines doubtful pixels.
int num_outlined(const QImage& image) {
  int count = 0;
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x) {
      const QRgb p = image.pixel(x, y);
      count += Rgb{std::uint8_t(qRed(p)), std::uint8_t(qGreen(p)), std::uint8_t(qBlue(p))} ==
               kDoubtfulColour;
    }
  return count;
}

// No draft, as after a while without motion.
bool shows(Document& document, SceneView& view) {
  const auto has_view = [&] {
    return document.zlists() && !document.zlists()->lists.depths.frame.empty();
  };
  return QTest::qWaitFor(has_view, kPatienceMs) &&
         QTest::qWaitFor([&] { return view.is_up_to_date(); }, kPatienceMs);
}

void look_at_a_drag(Document& document, MainWindow& window, User& user) {
  user.select("teapot");
  user.take("push");
  QVERIFY(user.wait());
  SceneView& view = window.view(WindowKind::Perspective);
  const QPoint from = user.pixel_on("teapot", WindowKind::Perspective);
  user.press(view, from, Qt::LeftButton);
  for (int i = 1; i <= 12; ++i) user.move_to(view, from + QPoint(-4 * i, 0));
  QVERIFY(user.wait_for_drag(view));
  look_at_doubtful_pixels(document, window, user);
  user.press_key(Qt::Key_Escape);
  user.release(view, from, Qt::LeftButton);
  QVERIFY(user.wait());
}

void look_at_a_fall(Document& document, MainWindow& window, User& user) {
  user.select("cup_front");
  user.take("put");
  QVERIFY(user.wait());
  SceneView& view = window.view(WindowKind::ThreeView);
  user.move_to(view,
               user.pixel(WindowKind::ThreeView, user.object("plate_front").centre_of_mass()));
  QVERIFY(QTest::qWaitFor([&] { return document.ghost().has_value(); }, kPatienceMs));
  QVERIFY(shows(document, view));
  QVERIFY(document.zlists()->motion.axis == Vec3(0, 0, -1));
  user.look("zlists_fall");
  user.take("select");
}

void look_at_preferences(Document& document, MainWindow& window, User& user) {
  user.with_dialog(
      [&] { window.action("preferences")->trigger(); },
      [&](QWidget& dialog) {
        auto* const box = dialog.findChild<QComboBox*>("backend");
        QVERIFY(box);
        box->setFocus();
        QTest::keyClick(box, Qt::Key_End);
        QTest::keyClick(box, Qt::Key_Up);  // z-lists in software
        QVERIFY(QTest::qWaitFor([&] { return document.detection().moves.name == "software"; },
                                kPatienceMs));
        user.look("preferences");
        for (int i = 0; i < 2; ++i) QTest::keyClick(box, Qt::Key_Up);  // automatic
        QVERIFY(box->currentIndex() == 0);
        QTest::keyClick(&dialog, Qt::Key_Escape);
      });
  QVERIFY(
      QTest::qWaitFor([&] { return document.detection().moves.name != "software"; }, kPatienceMs));
}

}  // namespace

void look_at_doubtful_pixels(Document& document, MainWindow& window, User& user) {
  for (const bool dark : {false, true}) {
    window.set_dark(dark);
    for (const auto kind : {WindowKind::Perspective, WindowKind::ThreeView, WindowKind::Constraint})
      QVERIFY(shows(document, window.view(kind)));
    QVERIFY(!document.zlists()->touched.empty());
    const QImage image = user.look(dark ? "zlists_drag_dark" : "zlists_drag_light");
    QVERIFY2(num_outlined(image) > 60, "doubtful pixels are outlined");
  }
}

void look_at_zlists(Document& document, MainWindow& window, User& user) {
  window.open_demo("breakfast");
  QVERIFY(user.wait());
  QVERIFY(!document.watches_zlists());
  user.press_key(Qt::Key_Z);
  QVERIFY(document.watches_zlists());
  look_at_a_drag(document, window, user);
  look_at_a_fall(document, window, user);
  user.press_key(Qt::Key_Z);
  QVERIFY(!document.watches_zlists());
  look_at_preferences(document, window, user);
  QVERIFY(!document.is_modified());
}

}  // namespace trivet::edit::test
