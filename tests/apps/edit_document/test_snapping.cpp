// Snapping: what the pointer means, against looking at all edges; drags that snap.
#include <Eigen/Geometry>
#include <random>

#include "apps/edit/tools/picking.h"
#include "apps/edit/tools/snapping.h"
#include "apps/edit_document/hand.h"

namespace trivet::edit::test {
namespace {

constexpr double kCrease = 0.93969262078590838;  // cos 20 degrees

struct Near {
  std::optional<Snap> best;
  double px = kInfinity;

  void offer(const SceneSnapshot& scene, const View& view, const Vec2& pointer, const Snap& snap) {
    const auto seen = view.project(snap.point);
    if (!seen) return;
    const double distance = (*seen - pointer).norm();
    if (distance > kSnapPx || distance >= px) return;
    const auto hit = pick(scene, view.seen_ray(*seen), {});
    const double depth = view.depth(snap.point);
    if (view.cut && depth < *view.cut) return;
    if (hit && view.depth(hit->point) < depth - 0.5 * view.metres_per_px(depth)) return;
    best = snap, px = distance;
  }
};

Vec3 normal_of(const Triangle& t) { return (t[1] - t[0]).cross(t[2] - t[0]).normalized(); }

/// True if no other face continues this one over its edge, by comparing all faces.
bool is_sharp(const Mesh& mesh, Index a, Index b) {
  std::vector<Vec3> normals;
  int num_forward = 0;
  for (size_t f = 0; f < mesh.triangles.size(); ++f)
    for (int k = 0; k < 3; ++k) {
      const Index p = mesh.triangles[f][k], q = mesh.triangles[f][(k + 1) % 3];
      if (!(p == a && q == b) && !(p == b && q == a)) continue;
      num_forward += p == a;
      normals.push_back(normal_of(mesh.triangle(static_cast<Index>(f))));
    }
  if (normals.size() != 2) return true;
  return (num_forward == 1 ? 1 : -1) * normals[0].dot(normals[1]) < kCrease;
}

/// By looking at all edges of all objects.
std::optional<Snap> brute_force(const SceneSnapshot& scene, const View& view, const Vec2& pointer) {
  Near corner, edge;
  for (const ObjectSnapshot& object : scene.objects) {
    const Mesh& mesh = object->shape->mesh;
    const Affine world = object->world_from_object();
    for (const auto& t : mesh.triangles)
      for (int k = 0; k < 3; ++k) {
        const Index a = std::min(t[k], t[(k + 1) % 3]), b = std::max(t[k], t[(k + 1) % 3]);
        if (!is_sharp(mesh, a, b)) continue;
        const Vec3 p = world.apply(mesh.vertices[a]), q = world.apply(mesh.vertices[b]);
        for (const Vec3& end : {p, q})
          corner.offer(scene, view, pointer, {Snap::Kind::Corner, end, object.id});
        // The place that is nearest in the picture, by halving the edge.
        Vec3 low = p, high = q;
        const auto distance = [&](const Vec3& at) {
          const auto px = view.project(at);
          return px ? (*px - pointer).norm() : kInfinity;
        };
        for (int i = 0; i < 100; ++i) {
          const Vec3 left = low + (high - low) / 3, right = high - (high - low) / 3;
          (distance(left) < distance(right) ? high : low) =
              distance(left) < distance(right) ? right : left;
        }
        edge.offer(scene, view, pointer, {Snap::Kind::Edge, 0.5 * (low + high), object.id});
      }
  }
  if (corner.best) return corner.best;
  if (edge.best) return edge.best;
  const auto hit = pick(scene, view.seen_ray(pointer), {});
  return hit ? std::optional(Snap{Snap::Kind::Face, hit->point, hit->object}) : std::nullopt;
}

/// Boxes, a shelf and a slanted box, seen from anywhere.
class Snapping : public testing::Test {
 protected:
  Snapping() : document(folder.file("recovery")), toolbox(*document), hand(document, toolbox) {
    write_boxes(folder.file("shelf.obj"), shelf_boxes());
    write_boxes(folder.file("box.obj"), {{{-0.1, -0.1, -0.1}, {0.1, 0.1, 0.1}}});
    document.import(folder.file("shelf.obj"), "shelf", true);
    stand("box", {{}, Vec3(0.9, -0.6, 0.3)});
    const Rotation slanted = Rotation{0.9, 0.2, 0.3, 0.1}.normalized();
    stand("slanted", {slanted, Vec3(-0.9, -0.6, 0.4)});
    hand.look_at(document->snapshot()->box());
  }

  void stand(const std::string& name, const Pose& pose) {
    document.import(folder.file("box.obj"), name);
    StandOperation operation;
    operation.object = name;
    operation.pose = pose;
    if (!document.done(document->perform(operation)))
      throw std::runtime_error(document.last_text());
  }

  Vec3 corner_of_box() const {
    return document.object("box").pose.translation + Vec3(-0.1, -0.1, 0.1);
  }

  TemporaryFolder folder;
  Recorder document;
  Toolbox toolbox;
  Hand hand;
};

TEST_F(Snapping, EqualsBruteForce) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> uniform(0, 1);
  int kinds[3] = {}, num_edges_cut = 0;
  for (int i = 0; i < 300; ++i) {
    View view = hand.view;
    view.width_px = 200, view.height_px = 160;
    const double angle = 6.28 * uniform(random);
    view.eye =
        view.target + Vec3(2.5 * std::cos(angle), 2.5 * std::sin(angle), 3 * uniform(random) - 0.4);
    view.orthographic = i % 3 == 0;
    view.height = 1.4;
    if (i % 4 == 0) view.cut = 2.2;
    const Vec2 pointer(200 * uniform(random), 160 * uniform(random));
    const SceneSnapshot& scene = *document->snapshot();
    SnapOptions options;
    const auto found = snap(scene, view, pointer, options, {});
    const auto expected = brute_force(scene, view, pointer);
    ASSERT_EQ(found.has_value(), expected.has_value()) << i;
    if (!found) continue;
    ++kinds[static_cast<int>(found->kind)];
    num_edges_cut += view.cut.has_value();
    EXPECT_EQ(found->kind, expected->kind) << i;
    EXPECT_EQ(found->object, expected->object) << i;
    EXPECT_LT((found->point - expected->point).norm(), 1e-6) << i;
  }
  for (const int count : kinds) EXPECT_GT(count, 20);
  EXPECT_GT(num_edges_cut, 20);
}

// Many corners behind a wall do not hide its edge from the pointer.
TEST(Snap, FindsAnEdgeBeforeManyHiddenCorners) {
  TemporaryFolder folder;
  Recorder document(folder.file("recovery"));
  std::vector<Aabb> boxes = {{{-0.5, -0.1, 0}, {0.5, 0, 0.5}}};
  for (int i = 0; i < 12; ++i) {  // 96 corners, 8 mm below the edge
    const double x = 1e-3 * i - 6e-3;
    boxes.push_back({{x, 0.3, 0.4920}, {x + 5e-4, 0.31, 0.4925}});
  }
  write_boxes(folder.file("wall.obj"), boxes);
  document.import(folder.file("wall.obj"), "wall", true);
  View view;  // 1 px is 1 mm
  view.orthographic = true;
  view.width_px = view.height_px = 1000, view.height = 1;
  view.eye = Vec3(0, -3, 0.5), view.target = Vec3(0, 0, 0.5);
  const Vec2 pointer = *view.project(Vec3(0, -0.1, 0.4985));
  const auto found = snap(*document->snapshot(), view, pointer, {}, {});
  ASSERT_TRUE(found);
  EXPECT_EQ(found->kind, Snap::Kind::Edge);
  EXPECT_NEAR(found->point.z(), 0.5, 1e-4);
}

TEST_F(Snapping, LeavesOutWhatIsNotWanted) {
  const SceneSnapshot& scene = *document->snapshot();
  const Vec2 at = hand.px(corner_of_box()) + Vec2(1, 1);
  SnapOptions options;
  ASSERT_TRUE(snap(scene, hand.view, at, options, {}));
  EXPECT_EQ(snap(scene, hand.view, at, options, {})->kind, Snap::Kind::Corner);
  EXPECT_EQ(in_words(*snap(scene, hand.view, at, options, {}), scene), "corner of \"box\"");
  options.corners = false;
  EXPECT_EQ(snap(scene, hand.view, at, options, {})->kind, Snap::Kind::Edge);
  options.edges = false;
  EXPECT_EQ(snap(scene, hand.view, at, options, {})->kind, Snap::Kind::Face);
  options.faces = false;
  EXPECT_FALSE(snap(scene, hand.view, at, options, {}));
  options = {};
  const auto behind = snap(scene, hand.view, at, options, {document.id("box")});
  EXPECT_TRUE(!behind || behind->object != document.id("box"));
  EXPECT_FALSE(snap(scene, hand.view, at, options, {}, document.id("shelf")));
}

// Corner to corner: what is grabbed of the object goes exactly there, if nothing is in the way.
TEST_F(Snapping, MovesCornerToCorner) {
  toolbox.take(ToolKind::Move);
  document->select_only(document.id("box"));
  toolbox.options().snap.on = true;
  toolbox.options().free = true;
  const Vec3 start = document.object("box").pose.translation, from = corner_of_box();
  const Vec3 to(-0.52, -0.2, 0.82);  // of the shelf
  hand.move(hand.px(from) + Vec2(2, 1));
  hand.press(hand.px(from) + Vec2(2, 1));
  for (const Vec2& at : {Vec2(hand.px(to) - Vec2(40, 40)), Vec2(hand.px(to) + Vec2(-3, -2))}) {
    hand.move(at);
    document->wait_until_idle();
  }
  const Overlay shown = toolbox.overlay(hand.view);
  EXPECT_EQ(shown.note, "corner of \"shelf\"");
  EXPECT_TRUE(std::any_of(shown.lines.begin(), shown.lines.end(),
                          [](const Overlay::Line& l) { return l.role == Overlay::Role::Snap; }));
  hand.release(hand.px(to) + Vec2(-3, -2));
  document->wait_until_idle();
  EXPECT_LT((document.object("box").pose.translation - (start + to - from)).norm(), 1e-5);
  EXPECT_TRUE(toolbox.overlay(hand.view).note.empty());
}

TEST_F(Snapping, GoesByStepsWhileControlIsHeld) {
  toolbox.take(ToolKind::Move);
  document->select_only(document.id("box"));
  toolbox.options().free = true;
  toolbox.options().snap.corners = toolbox.options().snap.edges = toolbox.options().snap.faces =
      false;
  const Vec3 centre = document.object("box").centre_of_mass();
  const double unit = hand.view.metres_per_px(hand.view.depth(centre));
  const Vec2 arrow = hand.px(centre + 60 * unit * Vec3::UnitX());
  hand.modifiers.control = true;
  hand.drag(arrow, arrow + Vec2(57, 3));
  const Vec3 moved = document.object("box").pose.translation - Vec3(0.9, -0.6, 0.3);
  EXPECT_GT(moved.x(), 0.04);
  EXPECT_EQ(moved.y(), 0);
  // The grabbed point, the middle, is on the grid.
  EXPECT_NEAR(std::remainder(document.object("box").centre_of_mass().x(), 0.05), 0, 1e-9);
  hand.modifiers.control = false;
  toolbox.options().snap.on = true;
  toolbox.take(ToolKind::Rotate);
  const Vec3 now = document.object("box").centre_of_mass();
  const Vec2 ring = hand.px(now) + Vec2(84, 0);
  hand.move(ring);
  hand.press(ring);
  hand.move(ring + Vec2(-20, -60));
  document->wait_until_idle();
  EXPECT_EQ(toolbox.overlay(hand.view).note, "steps of 15°");
  hand.release(ring + Vec2(-20, -60));
  document->wait_until_idle();
  const Rotation r = document.object("box").pose.rotation;
  const double deg = 2 * std::acos(std::min(1.0, std::abs(r.w))) * 180 / 3.14159265358979;
  EXPECT_GT(deg, 1);
  EXPECT_NEAR(std::remainder(deg, 15), 0, 1e-4);
}

TEST_F(Snapping, PutsOverTheGrid) {
  write_boxes(folder.file("cup.obj"), {{{-0.03, -0.03, 0}, {0.03, 0.03, 0.08}}});
  document.import(folder.file("cup.obj"), "cup");
  toolbox.take(ToolKind::Put);
  document->select_only(document.id("cup"));
  toolbox.options().snap.on = true;
  hand.click(hand.px(Vec3(0.13, -0.83, 0)));
  ASSERT_TRUE(document.object("cup").placed) << document.last_text();
  const Vec3 at = document.object("cup").centre_of_mass();
  EXPECT_NEAR(at.x(), 0.15, 1e-5);
  EXPECT_NEAR(at.y(), -0.85, 1e-5);
}

}  // namespace
}  // namespace trivet::edit::test
