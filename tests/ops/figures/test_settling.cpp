// The paper's figures of PUT and of quasi-static motion: Fig. 3, 10, 11, 12 and 16.
#include <Eigen/Geometry>
#include <cmath>

#include "apps/demo/shapes/models.h"
#include "replay.h"

namespace trivet {
namespace {

using test::box_triangles;
using test::figure_options;
using test::kFigureClearance;
using test::Stage;
using test::Triangles;
using Kind = SettleStep::Kind;

constexpr double kNear = 3 * kFigureClearance;

Rotation about_y(double angle_deg) {
  return Rotation::about_axis(Vec3::UnitY(), std::tan(angle_deg * M_PI / 360));
}

// Puts the object down, and checks every step against all pairs of faces.
OperationResult put_down(Stage& s, Object object, const Pose& start,
                         bool literal_paper_rules = false) {
  const std::string name = object.name;
  const ObjectId id = s.scene.add(std::move(object));
  OperationResult result = trivet::put(s.scene, id, start, figure_options(literal_paper_rules));
  EXPECT_TRUE(result.ok()) << result.reason();
  EXPECT_EQ(s.at(name).state, ObjectState::Stable);
  EXPECT_TRUE(check_scene(s.scene, 1, kFigureClearance, figure_options()).ok());
  test::expect_true_steps(s.scene, name, start, result.steps);
  return result;
}

// Fig. 3: an object falls onto another, collides, and turns until it is in equilibrium: flat on the
// side towards which its centre of mass lies from the edge that touched first.
TEST(Figure3, PutFallsCollidesAndTurns) {
  const double a = 0.2, c = 0.1;  // half extents along x and z
  for (const double angle : {30.0, 75.0}) {
    for (const bool literal : {false, true}) {
      Stage s;
      s.fix("table", box_triangles(Vec3(1, 1, 0.25)), {0, 0, 0.25 + 1e-5});
      const OperationResult result =
          put_down(s, test::object_of("box", box_triangles(Vec3(a, 0.15, c))),
                   {about_y(angle), Vec3(0.1, 0.2, 1.5)}, literal);
      ASSERT_GE(result.steps.size(), 2u);
      EXPECT_EQ(result.steps[0].kind, Kind::Fall);
      EXPECT_EQ(result.steps[1].kind, Kind::TurnAboutLine);
      // The lowest edge is its right one below.
      const double co = std::cos(angle * M_PI / 180), si = std::sin(angle * M_PI / 180);
      const double edge = 0.1 + a * co - c * si;
      const bool back = a * co > c * si;
      const Vec3 expected(back ? edge - a : edge + c, 0.2, 0.5 + 1e-5 + (back ? c : a));
      EXPECT_NEAR((s.position("box") - expected).norm(), 0, kNear) << angle;
    }
  }
}

// Fig. 10: contact at a point P. The object turns about the line through P that is perpendicular to
// PG and to z, until the next corner touches.
TEST(Figure10, PointContactTurnsUntilNextCornerTouches) {
  const Vec3 half(0.1, 0.2, 0.3);
  const Rotation tilted = Rotation::about_axis(Vec3(0.6, 0.64, 0.48), 0.3);
  std::vector<Vec3> corners;  // about G, turned
  for (const double x : {-1, 1})
    for (const double y : {-1, 1})
      for (const double z : {-1, 1})
        corners.push_back(tilted.matrix() * half.cwiseProduct(Vec3(x, y, z)));
  const Vec3 p = *std::min_element(corners.begin(), corners.end(),
                                   [](const Vec3& u, const Vec3& v) { return u.z() < v.z(); });
  const Vec3 axis = Vec3::UnitZ().cross(-p).normalized();  // l; G sinks
  // In small steps, then by bisection: the angle at which the second corner is as low as P.
  const auto is_down = [&](double angle) {
    const Mat3 turn = Eigen::AngleAxisd(angle, axis).toRotationMatrix();
    return std::any_of(corners.begin(), corners.end(),
                       [&](const Vec3& q) { return q != p && (turn * (q - p)).z() <= 0; });
  };
  double low = 0, high = 1e-3;
  while (!is_down(high)) low = high, high += 1e-3;
  for (int i = 0; i < 50; ++i) (is_down(0.5 * (low + high)) ? high : low) = 0.5 * (low + high);

  for (const bool literal : {false, true}) {
    Stage s;
    const Pose start{tilted, Vec3(0.3, -0.2, 1)};
    const OperationResult result =
        put_down(s, test::object_of("box", box_triangles(half)), start, literal);
    ASSERT_GE(result.steps.size(), 2u);
    EXPECT_EQ(result.steps[1].kind, Kind::TurnAboutPoint);
    const Pose& before = result.steps[0].pose_after;
    const Motion turn =
        test::motion_between(before, result.steps[1].pose_after, result.steps[1].kind);
    EXPECT_NEAR((turn.axis - axis).norm(), 0, 1e-6);
    EXPECT_NEAR(2 * std::atan(turn.limit), high, 1e-4);
    const Vec3 here = before.translation + p;  // fixed point of the turn
    EXPECT_NEAR((moved_point(here, turn, turn.limit) - here).norm(), 0, kNear);
    EXPECT_NEAR(here.z(), kFigureClearance, 0.1 * kFigureClearance);
  }
}

// --- a plate on needles ------------------------------------------------------------------------

constexpr double kTip = 0.125;       // height of the needles
constexpr double kThickness = 0.01;  // half
constexpr double kBehind = 0.15, kAhead = 0.35;

// A plate over x from -kBehind to kAhead, put down on the tips of needles.
struct PlateOnNeedles : Stage {
  OperationResult result;
  PlateOnNeedles(const std::vector<Vec2>& needles, double ahead, bool literal) {
    const Vec3 tip(0, 0, kTip);
    const double r = 0.015;
    const Vec3 a(r, 0, 0), b(-r, r, 0), c(-r, -r, 0);
    const Triangles needle = test::outward({{a, b, c}, {a, b, tip}, {b, c, tip}, {c, a, tip}});
    for (size_t i = 0; i < needles.size(); ++i)
      fix(std::string("needle").append(std::to_string(i)), needle,
          {needles[i].x(), needles[i].y(), 1e-5});
    const double length = 0.5 * (kBehind + ahead);
    result = put_down(*this, test::object_of("plate", box_triangles(Vec3(length, 0.2, kThickness))),
                      {{}, Vec3(ahead - length, 0, 0.5)}, literal);
  }

  /// Expects a turn about the y axis through x = 0 on the tips until the edge at x = ahead touches.
  void expect_tilted(Kind kind, double ahead) {
    const double si = (kTip + 1e-5) / ahead, co = std::sqrt(1 - si * si);
    const double half = 0.5 * (kBehind + ahead), g = ahead - half;
    ASSERT_EQ(result.steps.size(), 2u);
    EXPECT_EQ(result.steps[1].kind, kind);
    const Vec3 expected(g * co + kThickness * si, 0, kTip + 1e-5 - g * si + kThickness * co);
    EXPECT_NEAR((position("plate") - expected).norm(), 0, 2 * kNear);
    EXPECT_NEAR(at("plate").pose.rotation.matrix()(0, 0), co, 1e-4);
  }
};

// Fig. 11a: the foot of G on the line P1P2 is between them: it turns about the line.
TEST(Figure11a, LineContactTurnsAboutLine) {
  for (const bool literal : {false, true})
    PlateOnNeedles({{0, -0.1}, {0, 0.15}}, kAhead, literal)
        .expect_tilted(Kind::TurnAboutLine, kAhead);
}

// Fig. 11b: the foot of G is beyond P2: P2 becomes the only contact; here PG is along x.
TEST(Figure11b, LineContactTurnsAboutNearerEnd) {
  for (const bool literal : {false, true})
    PlateOnNeedles({{-0.1, -0.05}, {0, 0}}, kAhead, literal)
        .expect_tilted(Kind::TurnAboutPoint, kAhead);
}

// Fig. 12a: G is over the hull: stable at first contact.
TEST(Figure12a, AreaContactIsStable) {
  for (const bool literal : {false, true}) {
    PlateOnNeedles s({{0, -0.1}, {0, 0.1}, {0.2, 0.05}}, kAhead, literal);
    ASSERT_EQ(s.result.steps.size(), 1u);
    const Vec3 expected(0.1, 0, kTip + 1e-5 + kThickness + kFigureClearance);
    EXPECT_NEAR((s.position("plate") - expected).norm(), 0, kNear);
    // From G at x = 0.1 to the hull's side from (0, 0.1) to (0.2, 0.05), and to that at x = 0.2.
    const double side = std::abs((Vec2(0.1, 0) - Vec2(0, -0.1)).dot(Vec2(-0.15, 0.2)) / 0.25);
    EXPECT_NEAR(s.at("plate").stability_margin, side, 1e-6);
  }
}

// Fig. 12b: a corner of the hull is nearest to G: it becomes the only contact.
TEST(Figure12b, AreaContactTurnsAboutCorner) {
  for (const bool literal : {false, true})
    PlateOnNeedles({{0, 0}, {-0.1, -0.06}, {-0.1, 0.06}}, kAhead, literal)
        .expect_tilted(Kind::TurnAboutPoint, kAhead);
}

// Fig. 12c: a side of the hull is nearest to G: it is the axis.
TEST(Figure12c, AreaContactTurnsAboutSide) {
  for (const bool literal : {false, true})
    PlateOnNeedles({{0, -0.1}, {0, 0.12}, {-0.1, 0}}, kAhead, literal)
        .expect_tilted(Kind::TurnAboutLine, kAhead);
}

// --- Fig. 16: a spoon and a teacup -------------------------------------------------------------

// Computed by hand in a prismatic case: a ruler is lowered into a jar with a small tilt. It stands
// on its edge on the bottom, turns about that and comes to lean on the jar's rim.
TEST(Figure16, RulerLeansInJar) {
  Stage s;
  const double wide = 0.04, high = 0.1, wall = 0.004;  // half the inner width; inner height
  Triangles jar = test::moved(box_triangles(Vec3(wide + 2 * wall, wide, wall)), {0, 0, -wall});
  for (const double side : {-1.0, 1.0})
    jar = test::joined(jar, test::moved(box_triangles(Vec3(wall, wide, high / 2)),
                                        {side * (wide + wall), 0, high / 2 + 1e-4}));
  s.fix("jar", jar, {0, 0, 2 * wall + 1e-5});
  const double bottom = 2 * wall + 1e-5, rim = bottom + high + 1e-4;
  const double length = 0.16, half = 0.002;
  const OperationResult result =
      put_down(s, test::object_of("ruler", box_triangles(Vec3(half, 0.01, length / 2))),
               {about_y(3), Vec3(0, 0, 0.4)});
  ASSERT_EQ(result.steps.size(), 2u);
  // Its right lower edge stays; its right face touches the rim's edge at x = wide.
  const double t = 3 * M_PI / 180;
  const double edge = half * std::cos(t) - length / 2 * std::sin(t);
  const double angle = std::atan2(wide - edge, rim - bottom);
  const double co = std::cos(angle), si = std::sin(angle);
  const Vec3 expected(edge - half * co + length / 2 * si, 0, bottom + half * si + length / 2 * co);
  EXPECT_NEAR((s.position("ruler") - expected).norm(), 0, 2 * kNear);
}

// The paper's own objects. The steps are those allowed by all pairs of faces, the end is at rest.
TEST(Figure16, SpoonLeansOnTeacup) {
  const auto made = [](const std::string& name) {
    Object object;
    Model model = shapes::make_model(name);
    object.name = name;
    object.shape = make_shape(model.mesh);
    object.model = std::make_shared<const Model>(std::move(model));
    return object;
  };
  for (const double beside : {0.02, 0.045}) {
    Stage s;
    put_down(s, made("saucer"), {{}, Vec3(0, 0, 0.1)});
    put_down(s, made("cup"), {{}, Vec3(0, 0, 0.2)});
    const OperationResult result = put_down(s, made("spoon"), {{}, Vec3(beside, beside, 0.3)});
    EXPECT_EQ(result.steps[0].kind, Kind::Fall);
    EXPECT_GE(result.steps.size(), 4u);  // several collisions
    const Vec3 end = result.steps.back().pose_after.translation;
    EXPECT_LT(end.z(), result.steps[0].pose_after.translation.z());
  }
}

}  // namespace
}  // namespace trivet
