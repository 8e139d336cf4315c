#include "ops/files/report/flexible_json.h"

#include <algorithm>

#include "core/base/limits.h"
#include "ops/files/report/array_text.h"

namespace trivet {
namespace {

constexpr double kLargest = 1e15;       // of numbers that are read
constexpr double kLeastLength = 1e-12;  // of those that divide
static_assert(sizeof(std::array<int, 3>) == 12);

OrderedJson flex_material_json(const flex::FlexMaterial& m) {
  return {{"name", m.name},       {"density", m.density},   {"thickness", m.thickness},
          {"stretch", m.stretch}, {"coupling", m.coupling}, {"shear", m.shear},
          {"bending", m.bending}, {"twist", m.twist},       {"friction", m.friction}};
}

flex::FlexMaterial read_flex_material(const JsonPlace& place) {
  place.expect_object({"name", "density", "thickness", "stretch", "coupling", "shear", "bending",
                       "twist", "friction"},
                      {});
  const auto number = [&](const char* key) { return place.at(key).number(0, kLargest); };
  flex::FlexMaterial out;
  out.name = place.at("name").text();
  out.density = number("density"), out.thickness = number("thickness");
  out.stretch = number("stretch"), out.coupling = number("coupling");
  out.shear = number("shear"), out.bending = number("bending");
  out.twist = number("twist"), out.friction = number("friction");
  return out;
}

RestCertificate read_certificate(const JsonPlace& place) {
  const auto number = [&](const char* key) { return place.at(key).number(-kLargest, kLargest); };
  const auto whole = [&](const char* key) {
    return static_cast<int>(place.at(key).number(0, 1e9));
  };
  RestCertificate out;
  out.net_force = number("net_force");
  const auto at = place.at("net_force_at").numbers(3, -kLargest, kLargest);
  out.net_force_at = {at[0], at[1], at[2]};
  out.friction_used = number("friction_used"), out.balance = number("balance");
  out.stretch = number("stretch"), out.stable = place.at("stable").boolean();
  out.num_vertices = whole("vertices"), out.num_steps = whole("steps");
  out.num_contacts = whole("contacts"), out.num_own_contacts = whole("own_contacts");
  return out;
}

std::vector<FlexSupport> read_supports(const JsonPlace& place) {
  std::vector<FlexSupport> out;
  for (const JsonPlace& item : place.items()) {
    item.expect_object({"name", "share"}, {});
    out.push_back({item.at("name").text(), item.at("share").number(-kLargest, kLargest)});
  }
  return out;
}

FlexStart read_start(const JsonPlace& place) {
  place.expect_object({"path", "position", "rotation", "pins", "cell"}, {});
  const auto points = [](const JsonPlace& list) {
    std::vector<Vec3> out;
    for (const JsonPlace& item : list.items()) {
      const auto p = item.numbers(3, -kMaxLength, kMaxLength);
      out.emplace_back(p[0], p[1], p[2]);
    }
    return out;
  };
  FlexStart out;
  out.path = points(place.at("path")), out.pins = points(place.at("pins"));
  const auto at = place.at("position").numbers(3, -kMaxLength, kMaxLength);
  const auto turn = place.at("rotation").numbers(4, -1, 1);
  out.pose = {{turn[0], turn[1], turn[2], turn[3]}, {at[0], at[1], at[2]}};
  out.cell = place.at("cell").number(0, kMaxLength);
  return out;
}

std::vector<FlexTie> read_ties(const JsonPlace& place, size_t count) {
  std::vector<FlexTie> out;
  for (const JsonPlace& item : place.items()) {
    item.expect_object({"name", "vertex", "point"}, {});
    const auto p = item.at("point").numbers(3, -kLargest, kLargest);
    out.push_back({item.at("name").text(),
                   static_cast<int>(item.at("vertex").number(0, static_cast<double>(count) - 1)),
                   {p[0], p[1], p[2]}});
  }
  return out;
}

OrderedJson start_json(const FlexStart& start) {
  const auto points = [](const std::vector<Vec3>& list) {
    OrderedJson out = OrderedJson::array();
    for (const Vec3& p : list) out.push_back(to_json(p));
    return out;
  };
  const Rotation& r = start.pose.rotation;
  return {{"path", points(start.path)},
          {"position", to_json(start.pose.translation)},
          {"rotation", {r.w, r.x, r.y, r.z}},
          {"pins", points(start.pins)},
          {"cell", start.cell}};
}

OrderedJson ties_json(const std::vector<FlexTie>& ties) {
  OrderedJson out = OrderedJson::array();
  for (const FlexTie& tie : ties)
    out.push_back({{"name", tie.name}, {"vertex", tie.vertex}, {"point", to_json(tie.point)}});
  return out;
}

template <class T>
void expect_finite(const JsonPlace& place, const std::vector<T>& items, size_t count) {
  const bool fits = items.size() == count && std::all_of(items.begin(), items.end(),
                                                         [](const T& v) { return v.allFinite(); });
  if (!fits) place.fail(say("is no array of %1 finite items", count));
}

void expect_vertices(const JsonPlace& place, const Flexible& flexible) {
  const auto count = static_cast<int>(flexible.vertices.size());
  for (const auto& [a, b, c] : flexible.faces) {
    for (const int v : {a, b, c})
      if (v < 0 || v >= count) place.fail(say("has ids beyond those of %1 vertices", count));
    if (a == b || a == c || (b == c && !flexible.is_cable))
      place.fail("has a face with two equal corners");
  }
}

void read_rest_shape(const JsonPlace& place, Flexible& out) {
  const auto count = static_cast<int>(out.vertices.size());
  if (const auto grid = place.find("grid")) {
    const auto n = grid->numbers(4, kLeastLength, kLargest);
    const bool fits = n[0] >= 1 && n[1] >= 1 && n[0] <= count && n[1] <= count;
    if (fits) out.grid = flex::Grid{static_cast<int>(n[0]), static_cast<int>(n[1]), n[2], n[3]};
    if (!fits || (out.grid->num_u + 1.0) * (out.grid->num_v + 1.0) != count)
      grid->refuse("cells along both sides that fit the vertices, and their lengths");
  }
  if (const auto length = place.find("length")) out.length = length->number(kLeastLength, kLargest);
  if (const auto rest = place.find("rest_vertices")) {
    out.rest = items_of<Vec3>(*rest);
    expect_finite(*rest, out.rest, out.vertices.size());
  }
  if (const auto pins = place.find("pins"))
    for (const JsonPlace& pin : pins->items())
      out.pins.push_back(static_cast<int>(pin.number(0, count - 1.0)));
}

}  // namespace

OrderedJson flexible_json(const Flexible& flexible) {
  const RestCertificate& c = flexible.certificate;
  OrderedJson supports = OrderedJson::array();
  for (const FlexSupport& support : flexible.supports)
    supports.push_back({{"name", support.name}, {"share", support.share}});
  return {{"material", flexible.material.name},
          {"vertices", c.num_vertices},
          {"net_force", c.net_force},
          {"net_force_at", to_json(c.net_force_at)},
          {"friction_used", c.friction_used},
          {"balance", c.balance},
          {"stretch", c.stretch},
          {"stable", c.stable},
          {"steps", c.num_steps},
          {"contacts", c.num_contacts},
          {"own_contacts", c.num_own_contacts},
          {"supports", std::move(supports)}};
}

OrderedJson stored_flexible_json(const Flexible& flexible) {
  OrderedJson json = {{"cable", flexible.is_cable},
                      {"material", flex_material_json(flexible.material)},
                      {"vertices", text_of(flexible.vertices)},
                      {"faces", text_of(flexible.faces)},
                      {"forces", text_of(flexible.friction)},
                      {"layer", flexible.layer},
                      {"pressure", flexible.pressure},
                      {"rest", flexible_json(flexible)}};
  if (const auto& grid = flexible.grid)
    json["grid"] = {grid->num_u, grid->num_v, grid->length_u, grid->length_v};
  if (flexible.is_cable) json["length"] = flexible.length;
  if (!flexible.rest.empty()) json["rest_vertices"] = text_of(flexible.rest);
  if (!flexible.pins.empty()) json["pins"] = flexible.pins;
  if (flexible.start) json["start"] = start_json(*flexible.start);
  if (!flexible.ties.empty()) json["ties"] = ties_json(flexible.ties);
  return json;
}

Flexible read_stored_flexible(const JsonPlace& place) {
  place.expect_object(
      {"cable", "material", "vertices", "faces", "forces", "layer", "pressure", "rest"},
      {"grid", "length", "rest_vertices", "pins", "start", "ties"});
  Flexible out;
  out.is_cable = place.at("cable").boolean();
  out.material = read_flex_material(place.at("material"));
  out.vertices = items_of<Vec3>(place.at("vertices"));
  out.faces = items_of<std::array<int, 3>>(place.at("faces"));
  out.friction = items_of<Vec3>(place.at("forces"));
  const size_t count = out.vertices.size();
  expect_finite(place.at("vertices"), out.vertices, count);
  expect_finite(place.at("forces"), out.friction, count);
  expect_vertices(place.at("faces"), out);
  out.layer = place.at("layer").number(kLeastLength, kLargest);
  out.pressure = place.at("pressure").number(0, kLargest);
  read_rest_shape(place, out);
  if (const auto start = place.find("start")) out.start = read_start(*start);
  if (const auto ties = place.find("ties")) out.ties = read_ties(*ties, count);
  out.certificate = read_certificate(place.at("rest"));
  out.supports = read_supports(place.at("rest").at("supports"));
  return out;
}

}  // namespace trivet
