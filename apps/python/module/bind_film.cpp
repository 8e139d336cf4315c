// Films: what moves while operations are done.
#include "apps/python/module/bindings.h"
#include "apps/python/module/errors.h"
#include "apps/python/module/made_by_functions.h"

namespace trivet::python {
namespace {

void begin_film(SharedScene& scene) {
  const SceneGuard guard(scene);
  if (scene.film) raise("SceneBusy", "a film of the scene is being made already");
  scene.film.emplace(scene.scene());
}

MotionFilm end_film(SharedScene& scene) {
  const SceneGuard guard(scene);
  if (!scene.film) raise("SceneBusy", "no film of the scene is being made");
  MotionFilm out = std::move(*scene.film);
  scene.film.reset();
  out.add(scene.scene());
  return out;
}

py::bytes film_bytes(const MotionFilm& film) {
  return apart(std::make_shared<std::atomic<bool>>(false), [film] { return film.glb(); });
}

}  // namespace

void bind_film(py::module_& m, SceneClass& scene) {
  py::class_<MotionFilm>(m, "Film", made_by_functions())
      .def("to_glb", &film_bytes)
      .def_property_readonly("seconds", &MotionFilm::seconds);
  scene.def("begin_film", &begin_film).def("end_film", &end_film);
}

}  // namespace trivet::python
