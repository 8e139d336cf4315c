// Pictures by rays and labelled images of a scene, as arrays; what `trivet render` writes.
#include <pybind11/stl.h>
#include <tbb/task_arena.h>

#include <map>

#include "apps/python/module/arrays.h"
#include "apps/python/module/bindings.h"
#include "apps/python/module/callback.h"
#include "apps/python/module/errors.h"
#include "core/base/bad_input.h"
#include "core/picture/camera_dome.h"
#include "ops/files/labels/label_json.h"
#include "ops/files/report/models_of_shapes.h"
#include "raster/path/path_picture.h"

namespace trivet::python {
namespace {

using namespace py::literals;
using Names = std::map<std::string, std::string>;
using Colours = std::map<std::string, std::array<float, 4>>;

/// A scene as it is now, kept until the work is done: others may change theirs meanwhile.
struct Drawn {
  Scene scene;
  std::optional<WholeModels> whole;  // of `scene`
  LabelledScene labelled;            // of `whole`
};

std::unique_ptr<Drawn> drawn(SharedScene& shared, const Names& classes = {}) {
  auto out = std::make_unique<Drawn>();
  Layout layout;
  {
    const SceneGuard guard(shared);
    out->scene = shared.scene();
    layout = shared.session().layout();
  }
  for (const auto& [name, class_name] : classes)
    if (!out->scene.find(name)) raise("NoSuchObject", "there is no object \"" + name + "\"");
  without_gil([&] {
    out->whole.emplace(out->scene);
    out->labelled = labelled_scene(out->whole->scene(), layout, classes);
    return 0;
  });
  return out;
}

void add_highlights(const Colours& colours, LabelledScene& scene) {
  for (const auto& [name, colour] : colours) {
    bool found = false;
    for (std::size_t i = 0; i < scene.objects.size(); ++i)
      if (scene.objects[i].name == name) {
        scene.picture.objects[i].highlight = colour;
        found = true;
      }
    if (!found) raise("NoSuchObject", "there is no object \"" + name + "\" in the scene");
  }
}

template <class F>
void in_arena(int num_threads, F f) {
  tbb::task_arena(num_threads > 0 ? num_threads : tbb::task_arena::automatic).execute(f);
}

template <class T>
py::array_t<T> image_of(std::vector<T>&& values, int width, int height, py::ssize_t channels) {
  const auto kept = new std::vector<T>(std::move(values));
  const py::capsule owner(kept, [](void* p) { delete static_cast<std::vector<T>*>(p); });
  std::vector<py::ssize_t> shape{height, width};
  if (channels > 1) shape.push_back(channels);
  return py::array_t<T>(shape, kept->data(), owner);
}

// Why a picture was not finished.
[[noreturn]] void raise_for_cancelled(PythonCallback& told) {
  told.rethrow();
  if (PyErr_CheckSignals()) throw py::error_already_set();
  PyErr_SetString(PyExc_RuntimeError, "the interpreter is ending: the picture was not finished");
  throw py::error_already_set();
}

py::array_t<std::uint8_t> render(SharedScene& shared, const PinholeCamera& camera, int samples,
                                 int bounces, bool transparent, const Colours& highlight,
                                 const py::object& progress, int num_threads) {
  const auto what = drawn(shared);
  add_highlights(highlight, what->labelled);
  std::atomic<bool> cancel = false;
  PythonCallback told(progress, cancel);
  PictureOptions options;
  options.width = camera.width, options.height = camera.height;
  options.samples = samples;
  if (transparent) options.background[3] = 0;
  if (told.is_given()) options.progress = [&](double fraction) { told(fraction); };
  PathOptions path;
  path.bounces = bounces;
  path.cancel = &cancel;
  Image image;
  try {
    const Cancellable cancellable(cancel);
    without_gil([&] {
      in_arena(num_threads,
               [&] { image = trace_picture(what->labelled.picture, camera, options, path); });
      return 0;
    });
  } catch (const PictureCancelled&) {
    raise_for_cancelled(told);
  }
  told.rethrow();
  if (PyErr_CheckSignals()) throw py::error_already_set();
  return image_of(std::move(image.rgba), camera.width, camera.height, 4);
}

void add_box(const OrderedJson& box, std::vector<double>& out) {
  for (std::size_t k = 0; k < 4; ++k)
    out.push_back(box.is_null() ? std::numeric_limits<double>::quiet_NaN() : box[k].get<double>());
}

py::array_t<double> boxes(const std::vector<double>& values) {
  return column(values).reshape({static_cast<py::ssize_t>(values.size() / 4), py::ssize_t{4}});
}

void add_objects(const LabelledScene& scene, const Labels& labels, py::dict& out) {
  std::vector<std::string> names;
  std::vector<int> class_ids;
  std::vector<double> visible, whole, share;
  std::vector<std::int64_t> num_visible, num_alone;
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    const ObjectLabel& label = labels.objects[i];
    names.push_back(scene.objects[i].name);
    class_ids.push_back(scene.objects[i].class_id);
    add_box(visible_box_json(label.visible_box), visible);
    add_box(whole_box_json(label.whole_box), whole);
    share.push_back(label.visible_share());
    num_visible.push_back(label.num_visible);
    num_alone.push_back(label.num_alone);
  }
  out["names"] = py::tuple(py::cast(names));
  out["class_names"] = py::tuple(py::cast(scene.classes));
  out["class_ids"] = column(class_ids);
  out["boxes_visible"] = boxes(visible);
  out["boxes_whole"] = boxes(whole);
  out["pixels_visible"] = column(num_visible);
  out["pixels_alone"] = column(num_alone);
  out["visible_share"] = column(share);
}

py::dict labels(SharedScene& shared, const PinholeCamera& camera, const Names& classes,
                bool normals, bool visibility, int num_threads) {
  const auto what = drawn(shared, classes);
  Labels labels;
  std::vector<std::uint16_t> mask;
  without_gil([&] {
    in_arena(num_threads, [&] {
      labels = render_labels(what->labelled.picture, camera, {normals, visibility});
      mask = class_mask(what->labelled, labels);
    });
    return 0;
  });
  if (PyErr_CheckSignals()) throw py::error_already_set();
  const int width = camera.width, height = camera.height;
  py::dict out;
  add_objects(what->labelled, labels, out);
  out["normals"] = py::none();
  if (normals) {
    py::array_t<float> array({py::ssize_t{height}, py::ssize_t{width}, py::ssize_t{3}});
    std::copy_n(labels.normals.data()->data(), 3 * labels.normals.size(), array.mutable_data());
    out["normals"] = array;
  }
  out["depth"] = image_of(std::move(labels.depth), width, height, 1);
  out["instances"] = image_of(std::move(labels.instances), width, height, 1);
  out["classes"] = image_of(std::move(mask), width, height, 1);
  return out;
}

PinholeCamera automatic(SharedScene& shared, int width, int height) {
  check_camera(pinhole_camera(Camera{}, width, height));
  const auto what = drawn(shared);
  return pinhole_camera(automatic_camera(what->labelled.picture, double(width) / height), width,
                        height);
}

std::vector<PinholeCamera> dome(SharedScene& shared, int count, int width, int height,
                                std::uint64_t seed, double radius, double lowest, double highest,
                                double fov) {
  check_camera(pinhole_camera(Camera{}, width, height));
  const auto what = drawn(shared);
  const DomeOptions options{count, seed, radius, lowest, highest, fov};
  std::vector<PinholeCamera> out;
  out.reserve(static_cast<std::size_t>(std::max(count, 0)));
  for (const Camera& camera : camera_dome(what->labelled.picture, double(width) / height, options))
    out.push_back(pinhole_camera(camera, width, height));
  return out;
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
