#include "ops/operations/drape_watch.h"

#include "core/flex/levels.h"
#include "core/flex/presets.h"
#include "core/flex/thick_shape.h"
#include "core/io/mesh_model.h"

namespace trivet {
namespace {

thread_local DrapeWatch* t_watch = nullptr;

// The level with so many vertices.
flex::DrapeProblem level_with(const flex::DrapeProblem& fine, size_t num_vertices) {
  flex::DrapeProblem level = fine;
  while (level.start.size() > num_vertices) level = flex::coarser(level);
  return level;
}

std::shared_ptr<const Object> object_at(const std::string& name, const flex::DrapeProblem& fine,
                                        const flex::Points& x) {
  const flex::DrapeProblem level = level_with(fine, x.size());
  const double radius = level.material.thickness / 2;
  flex::ThickShape thick = level.num_segments > 0
                               ? flex::thick_cable(x, radius)
                               : flex::thick_sheet(x, flex::body_of(level).faces, radius);
  Model model = model_of_mesh(std::move(thick.mesh));
  model.corner_normals = std::move(thick.corner_normals);
  if (const auto* const preset = flex::flex_preset(level.material.name))
    model.materials[0].base_colour = {preset->colour[0], preset->colour[1], preset->colour[2], 1};
  auto out = std::make_shared<Object>();
  out->name = name;
  out->model = std::make_shared<const Model>(std::move(model));
  out->placed = true;
  return out;
}

}  // namespace

DrapeWatch::DrapeWatch(Show show, double rate)
    : m_show(std::move(show)),
      m_pause(std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(1 / rate))),
      m_outer(t_watch) {
  t_watch = this;
}

DrapeWatch::~DrapeWatch() { t_watch = m_outer; }

DrapeShow::DrapeShow(std::string name, const flex::DrapeProblem& problem)
    : m_name(std::move(name)), m_problem(problem) {}

void DrapeShow::step(const flex::Progress& progress) const {
  DrapeWatch* const watch = t_watch;
  if (!watch || DrapeWatch::Clock::now() < watch->m_next) return;
  watch->m_show(object_at(m_name, m_problem, *progress.x), progress.residual);
  watch->m_next = DrapeWatch::Clock::now() + watch->m_pause;
}

}  // namespace trivet
