// Writes the problem of a demo down: its objects, things to arrange, relations.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "apps/demo/arranged.h"

namespace trivet {

class ProblemWriter {
 public:
  using Json = nlohmann::ordered_json;

  explicit ProblemWriter(std::string name) { m_out.name = std::move(name); }

  /// Stands there from the start and never moves; its lowest point is at z = 0.
  void fix(const std::string& object, const std::string& model, double scale = 1,
           const Vec2& at = Vec2::Zero());
  /// @param more  "pose" and "yaw".
  void add(const std::string& object, const std::string& model, Json more = Json::object(),
           double scale = 1);
  /// Space to keep free, in the model's frame.
  void add_zone(const std::string& object, const std::string& name, const Vec3& lower,
                const Vec3& upper);
  /// @param b  may be empty.
  void relate(const char* is, const std::string& a, const std::string& b,
              Json more = Json::object());
  void add_relation(Json relation) { m_relations.push_back(std::move(relation)); }
  void look(const DemoView& view) { m_out.view = view; }

  ArrangedDemo take();

 private:
  Json object_of(const std::string& object, const std::string& model, double scale);

  ArrangedDemo m_out;
  Json m_objects = Json::array(), m_things = Json::array(), m_relations = Json::array();
  Json m_zones = Json::object();
};

ArrangedDemo make_table_for_six();
ArrangedDemo make_tight_table();
ArrangedDemo make_bookcase_demo();
ArrangedDemo make_market();
ArrangedDemo make_office3();
ArrangedDemo make_workshop();

}  // namespace trivet
