// Pictures by rays and labelled images of a scene, as arrays; what `trivet render` writes.
#include <pybind11/stl.h>

#include "apps/python/module/arrays.h"
#include "apps/python/module/bindings.h"
#include "apps/python/module/callback.h"
#include "apps/python/module/drawn_scene.h"
#include "apps/python/module/errors.h"
#include "core/base/arena.h"
#include "core/base/bad_input.h"
#include "core/picture/camera_dome.h"
#include "ops/files/labels/label_json.h"
#include "raster/path/picture.h"

namespace trivet::python {
namespace {

using namespace py::literals;

template <class T>
py::array_t<T> image_of(std::vector<T>&& values, int width, int height, py::ssize_t channels) {
  const auto kept = new std::vector<T>(std::move(values));
  const py::capsule owner(kept, [](void* p) { delete static_cast<std::vector<T>*>(p); });
  std::vector<py::ssize_t> shape{height, width};
  if (channels > 1) shape.push_back(channels);
  return py::array_t<T>(shape, kept->data(), owner);
}

// A picture under way: it may outlive the call that Ctrl+C ended, and its parts of Python do with
// it.
struct Painting {
  Painting(SharedScene& shared, const PinholeCamera& of, const Colours& highlight,
           const py::object& progress)
      : camera(of), scene(std::in_place, shared, Names{}, highlight), told(progress, cancel) {}

  Image image();

  PinholeCamera camera;
  std::optional<DrawnScene> scene;
  std::atomic<bool> cancel = false;
  PythonCallback told;
  PictureOptions options;
  PathOptions path;
  int num_threads = 0;
};

Image Painting::image() {
  Image out;
  in_arena(num_threads,
           [&] { out = trace_picture(scene->labelled().picture, camera, options, path); });
  scene.reset();  // takes long for large meshes, too
  return out;
}

// Ended with the GIL, wherever that is.
std::shared_ptr<Painting> painting(SharedScene& shared, const PinholeCamera& camera,
                                   const Colours& highlight, const py::object& progress) {
  return {new Painting(shared, camera, highlight, progress), [](Painting* p) {
            const py::gil_scoped_acquire acquire;
            delete p;
          }};
}

py::array_t<std::uint8_t> render(SharedScene& shared, const PinholeCamera& camera, int samples,
                                 int bounces, bool transparent, const Colours& highlight,
                                 const py::object& progress, int num_threads) {
  const auto work = painting(shared, camera, highlight, progress);
  work->options.width = camera.width, work->options.height = camera.height;
  work->options.samples = samples;
  if (transparent) work->options.background[3] = 0;
  if (work->told.is_given())
    work->options.progress = [told = &work->told](double fraction) { (*told)(fraction); };
  work->path.bounces = bounces;
  work->path.cancel = &work->cancel;
  work->num_threads = num_threads;
  const std::shared_ptr<std::atomic<bool>> cancel(work, &work->cancel);
  Image image;
  try {
    image = apart(cancel, [work] { return work->image(); });
  } catch (const PictureCancelled&) {
  } catch (const py::error_already_set&) {
    if (!work->told.has_raised()) throw;
  }
  work->told.rethrow();
  if (image.rgba.empty()) raise_stopped();
  return image_of(std::move(image.rgba), camera.width, camera.height, 4);
}

void add_box(const OrderedJson& box, std::vector<double>& out) {
  for (std::size_t k = 0; k < 4; ++k)
    out.push_back(box.is_null() ? std::numeric_limits<double>::quiet_NaN() : box[k].get<double>());
}

py::array_t<double> boxes(const std::vector<double>& values) {
  return column(values).reshape({static_cast<py::ssize_t>(values.size() / 4), py::ssize_t{4}});
}

struct FoundLabels {
  Labels labels;
  std::vector<std::uint16_t> mask;
  std::vector<LabelledObject> objects;
  std::vector<std::string> classes;
};

FoundLabels found_labels(const LabelledScene& scene, const PinholeCamera& camera,
                         const LabelOptions& options) {
  FoundLabels out{render_labels(scene.picture, camera, options), {}, scene.objects, scene.classes};
  out.mask = class_mask(scene, out.labels);
  return out;
}

void add_objects(const FoundLabels& found, py::dict& out) {
  std::vector<std::string> names;
  std::vector<int> class_ids;
  std::vector<double> visible, whole, share;
  std::vector<std::int64_t> num_visible, num_alone;
  for (std::size_t i = 0; i < found.objects.size(); ++i) {
    const ObjectLabel& label = found.labels.objects[i];
    names.push_back(found.objects[i].name);
    class_ids.push_back(found.objects[i].class_id);
    add_box(visible_box_json(label.visible_box), visible);
    add_box(whole_box_json(label.whole_box), whole);
    share.push_back(label.visible_share());
    num_visible.push_back(label.num_visible);
    num_alone.push_back(label.num_alone);
  }
  out["names"] = py::tuple(py::cast(names));
  out["class_names"] = py::tuple(py::cast(found.classes));
  out["class_ids"] = column(class_ids);
  out["boxes_visible"] = boxes(visible);
  out["boxes_whole"] = boxes(whole);
  out["pixels_visible"] = column(num_visible);
  out["pixels_alone"] = column(num_alone);
  out["visible_share"] = column(share);
}

// Runs f on the drawn scene in a thread that alone owns it: to free it may take long, too.
template <class F>
auto of_drawn(SharedScene& shared, const Names& classes, int num_threads, F f) {
  auto drawn = std::make_shared<DrawnScene>(shared, classes);
  return apart(std::make_shared<std::atomic<bool>>(false),
               [drawn = std::move(drawn), f, num_threads] {
                 std::optional<decltype(f(drawn->labelled()))> out;
                 in_arena(num_threads, [&] { out = f(drawn->labelled()); });
                 return std::move(*out);
               });
}

py::dict labels(SharedScene& shared, const PinholeCamera& camera, const Names& classes,
                bool normals, bool visibility, int num_threads) {
  FoundLabels found = of_drawn(shared, classes, num_threads, [=](const LabelledScene& scene) {
    return found_labels(scene, camera, {normals, visibility});
  });
  Labels& labels = found.labels;
  const int width = camera.width, height = camera.height;
  py::dict out;
  add_objects(found, out);
  out["normals"] = py::none();
  if (normals) {
    py::array_t<float> array({py::ssize_t{height}, py::ssize_t{width}, py::ssize_t{3}});
    std::copy_n(labels.normals.data()->data(), 3 * labels.normals.size(), array.mutable_data());
    out["normals"] = array;
  }
  out["depth"] = image_of(std::move(labels.depth), width, height, 1);
  out["instances"] = image_of(std::move(labels.instances), width, height, 1);
  out["classes"] = image_of(std::move(found.mask), width, height, 1);
  return out;
}

PinholeCamera automatic(SharedScene& shared, int width, int height) {
  check_camera(pinhole_camera(Camera{}, width, height));
  return of_drawn(shared, {}, 0, [=](const LabelledScene& scene) {
    return pinhole_camera(automatic_camera(scene.picture, double(width) / height), width, height);
  });
}

std::vector<PinholeCamera> dome(SharedScene& shared, int count, int width, int height,
                                std::uint64_t seed, double radius, double lowest, double highest,
                                double fov) {
  check_camera(pinhole_camera(Camera{}, width, height));
  const DomeOptions options{count, seed, radius, lowest, highest, fov};
  return of_drawn(shared, {}, 0, [=](const LabelledScene& scene) {
    std::vector<PinholeCamera> out;
    out.reserve(static_cast<std::size_t>(std::max(count, 0)));
    for (const Camera& camera : camera_dome(scene.picture, double(width) / height, options))
      out.push_back(pinhole_camera(camera, width, height));
    return out;
  });
}

}  // namespace

void bind_pictures(SceneClass& scene) {
  scene
      .def("render", &render, "camera"_a, "samples"_a, "bounces"_a, "transparent"_a, "highlight"_a,
           "progress"_a, "num_threads"_a)
      .def("labels", &labels, "camera"_a, "classes"_a, "normals"_a, "visibility"_a, "num_threads"_a)
      .def("automatic_camera", &automatic, "width"_a, "height"_a)
      .def("dome", &dome, "count"_a, "width"_a, "height"_a, "seed"_a, "radius"_a, "lowest"_a,
           "highest"_a, "fov"_a);
}

}  // namespace trivet::python
