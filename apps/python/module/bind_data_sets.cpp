// Views of a scene as data sets in folders, as `trivet render --coco, --bop` writes them.
#include <pybind11/stl.h>

#include "apps/python/module/bindings.h"
#include "apps/python/module/callback.h"
#include "apps/python/module/drawn_scene.h"
#include "core/base/arena.h"
#include "core/base/bad_input.h"
#include "ops/files/labels/data_sets.h"
#include "ops/files/labels/folders.h"
#include "raster/path/picture.h"

namespace trivet::python {
namespace {

using namespace py::literals;

std::unique_ptr<DataSetWriter> writer_of(const std::string& form, const std::string& folder,
                                         const LabelledScene& scene, double depth_unit) {
  if (form == "coco") return make_coco_writer(folder, scene);
  if (form == "bop") return make_bop_writer(folder, scene, depth_unit);
  bad_input("form: \"%1\" is not accepted; accepted: \"coco\" or \"bop\"", form);
}

struct DataSetRequest {
  std::string folder, form;
  std::vector<PinholeCamera> cameras;
  int samples, bounces;
  double depth_unit;
};

// Until it is cancelled; the files that describe all views come last.
void write_views(const DataSetRequest& request, DrawnScene& drawn, PythonCallback& told,
                 const std::atomic<bool>& cancel) {
  const LabelledScene& scene = drawn.labelled();
  const auto writer = writer_of(request.form, request.folder, scene, request.depth_unit);
  PathOptions path;
  path.bounces = request.bounces;
  path.cancel = &cancel;
  const std::size_t count = request.cameras.size();
  for (std::size_t i = 0; i < count; ++i) {
    if (cancel) return;
    const LabelView view{number_text(static_cast<int>(i)), request.cameras[i]};
    const Labels labels = render_labels(scene.picture, view.camera, {.normals = false});
    writer->add(view, labels, traced_png(scene.picture, view.camera, request.samples, path));
    if (told.is_given()) told(i + 1, count);
  }
  if (!cancel) writer->finish();
}

void write_data_set(SharedScene& shared, const std::string& folder, const std::string& form,
                    const std::vector<PinholeCamera>& cameras, const Names& classes, int samples,
                    int bounces, double depth_unit, const py::object& progress, int num_threads) {
  DrawnScene drawn(shared, classes);
  const DataSetRequest request{folder, form, cameras, samples, bounces, depth_unit};
  std::atomic<bool> cancel = false;
  PythonCallback told(progress, cancel);
  {
    const Cancellable cancellable(cancel);
    without_gil([&] {
      in_arena(num_threads, [&] {
        try {
          write_views(request, drawn, told, cancel);
        } catch (const PictureCancelled&) {  // `cancel` is set, which is told below
        }
      });
      return 0;
    });
  }
  told.rethrow();
  if (PyErr_CheckSignals()) throw py::error_already_set();
  if (cancel) raise_stopped();
}

}  // namespace

void bind_data_sets(SceneClass& scene) {
  scene.def("write_data_set", &write_data_set, "folder"_a, "form"_a, "cameras"_a, "classes"_a,
            "samples"_a, "bounces"_a, "depth_unit"_a, "progress"_a, "num_threads"_a);
}

}  // namespace trivet::python
