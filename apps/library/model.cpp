#include "trivet/model.h"

#include "apps/library/scene_internal.h"
#include "core/io/mesh_model.h"
#include "core/io/process/sandboxed_import.h"

namespace trivet::v0 {
namespace {

std::shared_ptr<const Model::Internal> made(trivet::Model model) {
  std::string path = std::move(model.path);
  model.path.clear();
  std::vector<std::string> notes = in_english(model.notes);
  return std::make_shared<Model::Internal>(Model::Internal{
      std::make_shared<const trivet::Model>(std::move(model)), std::move(path), std::move(notes)});
}

Shape shape_of(const trivet::Model& model) {
  return Shape(std::make_shared<Shape::Internal>(Shape::Internal{make_shape(model.mesh)}));
}

}  // namespace

Model::Model(std::shared_ptr<const Internal> internal)
    : m_internal(std::move(internal)), m_shape(shape_of(*m_internal->model)) {}

Model::Model(const Mesh& mesh)
    : m_internal(guarded([&] { return made(model_of_mesh(Shape(mesh).internal().shape->mesh)); })),
      m_shape(shape_of(*m_internal->model)) {}

const std::string& Model::path() const { return m_internal->path; }
bool Model::y_up() const { return m_internal->model->up == UpAxis::Y; }
std::optional<double> Model::metres_per_unit() const { return m_internal->model->metres_per_unit; }
const std::vector<std::string>& Model::notes() const { return m_internal->notes; }

Model load_model(const std::string& path, const ModelLimits& limits) {
  return guarded([&] {
    ImportLimits inner = usual_limits();
    inner.max_seconds = limits.max_seconds;
    inner.max_triangles = limits.max_triangles;
    Tessellation tessellation;
    tessellation.chord = limits.chord;
    return Model(made(import_model(path, inner, tessellation)));
  });
}

}  // namespace trivet::v0
