#include "apps/demo/problem_writer.h"

#include <algorithm>

#include "apps/demo/shapes/assemble.h"
#include "apps/demo/shapes/models.h"
#include "ops/files/json/text.h"

namespace trivet {

void ProblemWriter::fix(const std::string& object, const std::string& model, double scale,
                        const Vec2& at) {
  Json entry = object_of(object, model, scale);
  entry["fixed"] = true;
  entry["position"] = {at.x(), at.y(), shapes::kGrid};
  m_objects.push_back(std::move(entry));
}

void ProblemWriter::add(const std::string& object, const std::string& model, Json more,
                        double scale) {
  m_objects.push_back(object_of(object, model, scale));
  Json thing = {{"object", object}};
  thing.update(more);
  m_things.push_back(std::move(thing));
}

void ProblemWriter::add_zone(const std::string& object, const std::string& name, const Vec3& lower,
                             const Vec3& upper) {
  const auto corner = [](const Vec3& p) { return Json::array({p.x(), p.y(), p.z()}); };
  m_zones[object].push_back({{"name", name}, {"box", {corner(lower), corner(upper)}}});
}

void ProblemWriter::relate(const char* is, const std::string& a, const std::string& b, Json more) {
  Json relation = {{"is", is}, {"a", a}};
  if (!b.empty()) relation["b"] = b;
  relation.update(more);
  m_relations.push_back(std::move(relation));
}

ArrangedDemo ProblemWriter::take() {
  Json arrange = {{"seed", 1}}, operation = {{"op", "arrange"}};  // a batch draws its seeds
  for (Json* const section : {&arrange, &operation}) {
    (*section)["things"] = m_things;
    if (!m_zones.empty()) (*section)["zones"] = m_zones;
    (*section)["relations"] = m_relations;
  }
  m_out.problem =
      readable_json({{"trivet", 1}, {"objects", m_objects}, {"arrange", arrange}}) + "\n";
  m_out.recipe = readable_json({{"trivet_recipe", 1},
                                {"objects", m_objects},
                                {"operations", Json::array({operation})}}) +
                 "\n";
  return std::move(m_out);
}

ProblemWriter::Json ProblemWriter::object_of(const std::string& object, const std::string& model,
                                             double scale) {
  const std::string file = model + ".glb";
  const auto known = [&](const DemoModel& m) { return m.file == file; };
  if (std::none_of(m_out.models.begin(), m_out.models.end(), known))
    m_out.models.push_back({file, shapes::make_model(model)});
  Json out = {{"name", object}, {"model", file}};
  if (scale != 1) out["scale"] = scale;
  return out;
}

}  // namespace trivet
