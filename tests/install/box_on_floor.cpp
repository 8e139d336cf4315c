// A client program: puts a box on the floor and asks the library for what it can.
#include <trivet/trivet.h>

#include <cstdio>
#include <cstdlib>

namespace {

/// A closed box of 12 triangles about the origin.
trivet::Mesh box_mesh(const trivet::Vec3& half) {
  trivet::Mesh mesh;
  for (int i = 0; i < 8; ++i)
    mesh.vertices.push_back(
        {i & 1 ? half.x : -half.x, i & 2 ? half.y : -half.y, i & 4 ? half.z : -half.z});
  mesh.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                    {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  return mesh;
}

void expect(bool holds, const char* what) {
  if (holds) return;
  std::fprintf(stderr, "does not hold: %s\n", what);
  std::exit(1);
}

void put_boxes(trivet::Scene& scene) {
  const trivet::Model box(box_mesh({0.3, 0.2, 0.1}));
  const trivet::ObjectId lower = scene.add("lower", box), upper = scene.add("upper", box);
  expect(trivet::put(scene, lower, {.position = {0, 0, 0.5}}).ok(),
         "the box is put onto the floor");
  const double height = scene.info(lower).pose.position.z;
  std::printf("The centre of the box is %.9f m above the floor.\n", height);
  expect(height > 0.1 && height < 0.100001, "it lies on the floor");
  expect(trivet::put_on(scene, upper, {.on = "lower", .at = trivet::Vec2{0, 0}}).ok(),
         "one is put onto the other");
  expect(scene.info(upper).supports == std::vector<std::string>{"lower"},
         "the lower box carries the upper one");

  const trivet::Result refused = trivet::put(scene, upper, {.position = {0, 0, 0.15}});
  expect(!refused.ok() && refused.refusal->cause == "crossing",
         "a start within another object is refused");
  expect(trivet::push(scene, lower, {.distance = 0.2}).carried == std::vector<std::string>{"upper"},
         "a push carries the load");
  const std::uint64_t pushed = scene.fingerprint();
  expect(scene.undo() && scene.fingerprint() != pushed && scene.redo() &&
             scene.fingerprint() == pushed,
         "steps are undone and redone");
}

void cancel_push(trivet::Scene& scene) {
  trivet::Cancel cancel;
  cancel.request();
  const trivet::Result result =
      trivet::push(scene, *scene.find("lower"), {.distance = 0.1}, {.cancel = &cancel});
  expect(result.status == trivet::Result::Status::Cancelled, "an operation is cancelled");
}

void look(const trivet::Scene& scene) {
  expect(trivet::check(scene).ok() && trivet::stability(scene).stands(), "the scene is true");
  const trivet::Camera camera = trivet::automatic_camera(scene, 64, 48);
  expect(trivet::labels(scene, camera).objects.at(0).num_visible > 0,
         "the camera sees the lower box");
  expect(trivet::render(scene, camera, 1).rgba.size() == 64 * 48 * 4, "a picture is drawn");
  const trivet::ZLists lists = trivet::z_lists(scene, {.resolution = 16});
  expect(!lists.items.empty() && lists.start.size() == std::size_t(lists.width * lists.height + 1),
         "pixels have lists");
}

void expect_errors(trivet::Scene& scene) {
  try {
    (void)trivet::load_model("missing.obj");
  } catch (const trivet::Error& error) {
    expect(error.kind() == trivet::Error::Kind::BadInput, "a missing model is bad input");
    try {
      (void)trivet::perform(scene, R"({"op": "push", "object": "lower", "speed": 1})");
    } catch (const trivet::Error&) {
      return;
    }
  }
  expect(false, "errors are thrown");
}

}  // namespace

int main() {
  trivet::Scene scene;
  put_boxes(scene);
  cancel_push(scene);
  look(scene);
  expect_errors(scene);
  trivet::save_scene(scene, "boxes.glb");
  expect(trivet::open_scene("boxes.glb").fingerprint() == scene.fingerprint(),
         "a file has the same bits");
  return 0;
}
