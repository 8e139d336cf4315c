#include "apps/trivet/scene_page.h"

#include <algorithm>
#include <bit>
#include <map>
#include <set>

#include "apps/trivet/verbs.h"
#include "core/base/bad_input.h"
#include "core/io/base64.h"
#include "core/mesh/hull.h"
#include "core/picture/face_colours.h"
#include "core/picture/scene.h"
#include "ops/files/report/json_parts.h"

namespace trivet::apps {
namespace {

static_assert(std::endian::native == std::endian::little, "browsers read these bytes as they are");

constexpr double kFlat = 0.9999;  // cosine; edges of hulls between faces in one plane are not drawn
constexpr int kFewColours = 1 << 16;
constexpr const char* kPlaceOfScene = "@SCENE@";

template <class T>
std::string bytes_text(const std::vector<T>& values) {
  return base64({reinterpret_cast<const char*>(values.data()), sizeof(T) * values.size()});
}

void append_point(const Vec3& p, std::vector<float>& out) {
  for (int i = 0; i < 3; ++i) out.push_back(static_cast<float>(p[i]));
}

// Two vertices for each edge of the convex hull that is one.
std::vector<std::uint32_t> hull_edges(const Mesh& mesh) {
  std::map<std::pair<Index, Index>, std::vector<Vec3>> sides;
  for (const Index3& t : convex_hull(mesh.vertices).triangles) {
    const Vec3 a = mesh.vertices[t[0]], b = mesh.vertices[t[1]], c = mesh.vertices[t[2]];
    const Vec3 normal = (b - a).cross(c - a).normalized();
    for (int i = 0; i < 3; ++i) {
      const Index from = t[i], to = t[(i + 1) % 3];
      sides[{std::min(from, to), std::max(from, to)}].push_back(normal);
    }
  }
  std::vector<std::uint32_t> out;
  for (const auto& [edge, normals] : sides) {
    if (normals.size() == 2 && std::abs(normals[0].dot(normals[1])) > kFlat) continue;
    out.push_back(static_cast<std::uint32_t>(edge.first));
    out.push_back(static_cast<std::uint32_t>(edge.second));
  }
  return out;
}

// A palette, and for each face its place there.
void add_colours(const Model& model, OrderedJson& json) {
  using Colour = std::array<std::uint8_t, 4>;
  std::vector<Colour> colours = face_colours(picture_mesh(model));
  std::map<Colour, std::uint16_t> places;
  for (const Colour& colour : colours) places.emplace(colour, 0);
  if (places.size() > kFewColours) {  // 4 bits of each are enough then
    places.clear();
    for (Colour& colour : colours) {
      for (std::uint8_t& channel : colour) channel &= 0xf0;
      places.emplace(colour, 0);
    }
  }
  json["palette"] = OrderedJson::array();
  for (auto& [colour, place] : places) {
    place = static_cast<std::uint16_t>(json["palette"].size());
    json["palette"].push_back(colour);
  }
  std::vector<std::uint16_t> of_faces;
  of_faces.reserve(colours.size());
  for (const Colour& colour : colours) of_faces.push_back(places[colour]);
  json["color"] = bytes_text(of_faces);
}

class PageWriter {
 public:
  PageWriter(const Scene& scene, const SceneVerdict& verdict, double lift)
      : m_scene(scene), m_verdict(verdict), m_lift(lift), m_box(scene.box()) {
    if (m_box.empty()) m_box = {Vec3::Constant(-0.5), Vec3::Constant(0.5)};
    for (const SceneFinding& f : verdict.findings) m_marked.insert({f.object, f.other});
    for (const ObjectId id : scene.ids())
      if (scene.at(id).placed) {
        m_numbers[scene.at(id).name] = static_cast<int>(m_placed.size());
        m_placed.push_back(id);
      }
  }

  OrderedJson json() {
    check_size();
    OrderedJson objects = OrderedJson::array();
    for (const ObjectId id : m_placed) objects.push_back(object(id));
    const double radius = m_box.diagonal() / 2;
    OrderedJson out = {{"meshes", m_meshes},
                       {"objects", objects},
                       {"radius", radius > 0 ? radius : 1.0},
                       {"grid", {middle().x(), middle().y()}},
                       {"floor", m_scene.floor ? OrderedJson(-middle().z()) : OrderedJson()}};
    add_contacts(out);
    out["show"] = OrderedJson::array();
    out["verdict"] = m_verdict.path + (m_verdict.ok() ? ": ok" : ": failed") +
                     (m_verdict.whole() ? "" : ", judged in part");
    out["pairs"] = pairs_text(m_verdict.pairs, m_verdict.clearance);
    out["touching"] = OrderedJson::array();
    for (const TouchingPair& p : m_verdict.pairs.touching) out["touching"].push_back(touching(p));
    out["findings"] = OrderedJson::array();
    for (const SceneFinding& f : m_verdict.findings) out["findings"].push_back(finding(f));
    return out;
  }

 private:
  Vec3 middle() const { return m_box.centre(); }

  void check_size() const {
    size_t num_faces = 0;
    std::set<const Shape*> seen;
    for (const ObjectId id : m_placed)
      if (seen.insert(m_scene.at(id).shape.get()).second)
        num_faces += m_scene.at(id).shape->mesh.triangles.size();
    if (num_faces > kMostFacesOfPage)
      bad_input("--html: the scene has %1 faces; accepted: up to %2", num_faces, kMostFacesOfPage);
  }

  OrderedJson object(ObjectId id) {
    const Object& o = m_scene.at(id);
    const Affine at = o.world_from_object();
    const Vec3 origin = at.apply(o.shape->mesh.box().centre()) - middle();
    OrderedJson matrix = OrderedJson::array();
    for (int c = 0; c < 3; ++c) {
      Vec3 unit = Vec3::Zero();
      unit[c] = 1;
      const Vec3 column = at.apply(unit) - at.apply(Vec3::Zero());
      for (int r = 0; r < 3; ++r) matrix.push_back(column[r]);
      matrix.push_back(0);
    }
    for (int r = 0; r < 3; ++r) matrix.push_back(origin[r]);
    matrix.push_back(1);
    return {{"name", o.name},
            {"state", to_string(o.state)},
            {"mesh", mesh_number(o)},
            {"highlight", m_marked.count(o.name) != 0},
            {"matrix", matrix},
            {"center", to_json(Vec3(m_scene.world_box(id).centre() - middle()))}};
  }

  size_t mesh_number(const Object& o) {
    const auto [it, is_new] = m_mesh_numbers.try_emplace(o.shape.get(), m_meshes.size());
    if (is_new) m_meshes.push_back(mesh(o));
    return it->second;
  }

  static OrderedJson mesh(const Object& o) {
    const Mesh& mesh = o.shape->mesh;
    const Vec3 centre = mesh.box().centre();
    std::vector<float> vertices;
    std::vector<std::uint32_t> faces;
    for (const Vec3& v : mesh.vertices) append_point(v - centre, vertices);
    for (const Index3& t : mesh.triangles)
      for (int i = 0; i < 3; ++i) faces.push_back(static_cast<std::uint32_t>(t[i]));
    OrderedJson out = {{"vertices", bytes_text(vertices)}, {"faces", bytes_text(faces)}};
    add_colours(*o.model, out);
    out["hull"] = bytes_text(hull_edges(mesh));
    return out;
  }

  void add_contacts(OrderedJson& out) const {
    std::vector<float> points, normals;
    OrderedJson edges = OrderedJson::array();
    for (const LoadSupport::Entry& entry : load_support(m_scene).entries) {
      const int load = m_numbers.at(m_scene.at(entry.object).name);
      if (entry.on_floor) edges.push_back({-1, load});
      for (const ObjectId below : entry.supports)
        edges.push_back({m_numbers.at(m_scene.at(below).name), load});
      for (const ObjectContact& link : m_scene.at(entry.object).contacts)
        for (const ContactPoint& p : link.contact.points) {
          append_point(p.point - middle(), points);
          append_point(link.contact.normal, normals);
        }
    }
    out["contacts"] = {{"point", bytes_text(points)}, {"normal", bytes_text(normals)}};
    out["edges"] = edges;
  }

  OrderedJson numbers_of(const std::string& a, const std::string& b) const {
    OrderedJson out = OrderedJson::array();
    for (const std::string& name : {a, b})
      if (const auto it = m_numbers.find(name); it != m_numbers.end()) out.push_back(it->second);
    return out;
  }

  OrderedJson touching(const TouchingPair& p) const {
    return {{"text", touching_text(p)}, {"objects", numbers_of(p.a, p.b)}};
  }

  OrderedJson finding(const SceneFinding& f) const {
    const OrderedJson objects = numbers_of(f.object, f.other);
    Vec3 point = middle();
    if (const auto id = m_scene.find(f.object)) point = m_scene.world_box(*id).centre();
    if (f.kind == SceneFinding::Kind::PassesThrough) point = f.point + m_lift * Vec3::UnitZ();
    return {{"text", finding_text(f)},
            {"objects", objects},
            {"point", to_json(Vec3(point - middle()))}};
  }

  const Scene& m_scene;
  const SceneVerdict& m_verdict;
  double m_lift;
  Aabb m_box;
  std::set<std::string> m_marked;
  std::vector<ObjectId> m_placed;
  std::map<std::string, int> m_numbers;
  std::map<const Shape*, size_t> m_mesh_numbers;
  OrderedJson m_meshes = OrderedJson::array();
};

}  // namespace

std::string scene_page(const Scene& scene, const SceneVerdict& verdict, double lift) {
  std::string text = PageWriter(scene, verdict, lift)
                         .json()
                         .dump(-1, ' ', false, OrderedJson::error_handler_t::replace);
  // The text must not end the element of the page.
  for (size_t at = text.find('<'); at != text.npos; at = text.find('<', at))
    text.replace(at, 1, "\\u003c");
  std::string page = kViewerPage;
  page.replace(page.find(kPlaceOfScene), std::string(kPlaceOfScene).size(), text);
  return page;
}

}  // namespace trivet::apps
