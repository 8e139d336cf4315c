#include "ops/files/report/model_info.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "core/base/count_of.h"
#include "core/io/look.h"
#include "core/io/textures/surface_look.h"
#include "core/mesh/part_masses.h"
#include "ops/files/json/text.h"
#include "ops/files/report/json_parts.h"

namespace trivet {
namespace {

std::string up_reason(const Model& model) {
  if (model.up_from_format) return "the format or the file says so";
  const auto likely = likely_up(model.mesh);
  return std::string("the format does not say; z is taken") + (!likely ? ""
                                                               : *likely == UpAxis::Y
                                                                   ? "; by its shape likely y"
                                                                   : "; likely so by its shape");
}

// Measures how much an axis looks like up: 1 for a plane of the origin that the model stands on,
// and the part of its outline that the lowest slice has.
double standing(const Mesh& mesh, const Aabb& box, int axis) {
  constexpr double kOnOrigin = 0.02, kSlice = 0.02;  // of the largest side
  const Vec3 size = box.upper - box.lower;
  const double largest = size.maxCoeff();
  Aabb slice;
  for (const Vec3& v : mesh.vertices)
    if (v[axis] <= box.lower[axis] + kSlice * largest) slice.extend(v);
  double foot = 1;
  for (int other = 0; other < 3; ++other)
    if (other != axis && size[other] > 0)
      foot *= (slice.upper[other] - slice.lower[other]) / size[other];
  return foot + (std::abs(box.lower[axis]) <= kOnOrigin * largest ? 1 : 0);
}

std::string yes_no(bool value) { return value ? "yes" : "no"; }

// Appearance that goes to glTF with the geometry; null: materials and normals alone.
OrderedJson look_json(const Model& model) {
  if (!model.appearance) return nullptr;
  const AppearanceCounts c = count(*model.appearance);
  return {{"nodes", c.nodes},       {"meshes", c.meshes}, {"materials", c.materials},
          {"textures", c.textures}, {"images", c.images}, {"image_bytes", c.image_bytes},
          {"cameras", c.cameras},   {"lights", c.lights}};
}

// Images of textures; sizes of 0: they cannot be drawn.
OrderedJson images_json(const Model& model) {
  OrderedJson out = OrderedJson::array();
  for (const ImageSummary& image : images_of(model))
    out.push_back({{"name", image.name},
                   {"kind", image.kind},
                   {"bytes", image.bytes},
                   {"width", image.width},
                   {"height", image.height}});
  return out;
}

std::string images_text(const Model& model) {
  std::ostringstream out;
  for (const ImageSummary& image : images_of(model)) {
    out << "  image       \"" << image.name << "\", " << image.kind << ", ";
    if (image.width > 0)
      out << image.width << " x " << image.height << " texels\n";
    else
      out << "not drawn\n";
  }
  return out.str();
}

std::string look_text(const Model& model) {
  if (!model.appearance) return "";
  const AppearanceCounts c = count(*model.appearance);
  std::ostringstream out;
  out << "  look        nodes " << c.nodes << ", meshes " << c.meshes << ", materials "
      << c.materials << ", textures " << c.textures << " of " << c.images << " images ("
      << c.image_bytes << " bytes), cameras " << c.cameras << ", lights " << c.lights << "\n";
  return out.str();
}

// Polygonisation of curved surfaces; null: there were none.
OrderedJson polygonised_json(const Model& model) {
  if (!model.polygonised) return nullptr;
  const Polygonisation& p = *model.polygonised;
  return {{"faces", p.num_faces},
          {"edges", p.num_edges},
          {"failed_faces", p.num_failed_faces},
          {"chord", p.chord},
          {"facet_angle_deg", model.tessellation.facet_angle_deg},
          {"deviation", p.deviation},
          {"within_chord", p.deviation <= p.chord}};
}

std::string polygonised_text(const Model& model) {
  if (!model.polygonised) return "";
  const Polygonisation& p = *model.polygonised;
  std::ostringstream out;
  out.precision(3);
  out << "  polygonised " << count_of(p.num_faces, "face") << ", " << count_of(p.num_edges, "edge")
      << ", left out " << count_of(p.num_failed_faces, "face") << "; chord " << p.chord
      << " m, angle " << model.tessellation.facet_angle_deg
      << " degrees; largest deviation measured " << p.deviation << " m"
      << (p.deviation <= p.chord ? "" : ", NOT within the chord") << "\n";
  return out.str();
}

constexpr size_t kMaxParts = 1000;  // that are listed

std::string rule_of(const PartMass& part) {
  if (part.is_cavity) return part.is_turned ? "cavity, turned" : "cavity";
  return std::string(to_string(part.rule)) + (part.is_turned ? ", turned" : "");
}

OrderedJson parts_json(const Shape& shape) {
  OrderedJson out = OrderedJson::array();
  for (const PartMass& part : part_masses(shape.mesh, shape.adjacency)) {
    if (out.size() == kMaxParts) break;
    out.push_back({{"triangles", part.num_triangles},
                   {"rule", to_string(part.rule)},
                   {"cavity", part.is_cavity},
                   {"turned", part.is_turned},
                   {"volume", part.volume},
                   {"area", part.area},
                   {"centre", to_json(part.centre)}});
  }
  return out;
}

std::vector<Sentence> notes_of(const Model& model, const Shape& shape) {
  std::vector<Sentence> out = model.notes;
  for (Sentence& note : mass_notes(shape.mass)) out.push_back(std::move(note));
  return out;
}

std::string vector_text(const Vec3& v) {
  std::ostringstream out;
  out << v.x() << " " << v.y() << " " << v.z();
  return out.str();
}

// Lists the first few parts; a mesh of one part says the same as a whole.
std::string parts_text(const Shape& shape) {
  constexpr size_t kShown = 20;
  const std::vector<PartMass> parts = part_masses(shape.mesh, shape.adjacency);
  if (parts.size() < 2) return "";
  std::ostringstream out;
  out.precision(9);
  for (size_t i = 0; i < std::min(parts.size(), kShown); ++i)
    out << "  part " << i + 1 << "      " << count_of(parts[i].num_triangles, "triangle") << ", by "
        << rule_of(parts[i]) << ", volume " << parts[i].volume << ", area " << parts[i].area
        << ", centre " << vector_text(parts[i].centre) << "\n";
  if (parts.size() > kShown) out << "  part        and " << parts.size() - kShown << " more\n";
  return out.str();
}

}  // namespace

Topology topology(const Adjacency& adjacency) {
  Topology out;
  out.num_edges = adjacency.edge_faces.size();
  for (Index e = 0; e < adjacency.edge_faces.size(); ++e) {
    const auto wings = adjacency.edge_faces[e];
    out.boundary_edges += wings.size() == 1;
    out.non_manifold_edges += wings.size() > 2;
    out.flipped_edges += wings.size() == 2 && wings[0].forward == wings[1].forward;
  }
  const auto& parts = adjacency.components;
  out.closed = std::all_of(parts.begin(), parts.end(), [](const auto& c) { return c.even; });
  out.oriented = std::all_of(parts.begin(), parts.end(), [](const auto& c) { return c.balanced; });
  out.oriented |= out.flipped_edges == 0 && out.non_manifold_edges == 0;
  out.manifold = out.non_manifold_edges == 0;
  return out;
}

const char* likely_unit(const Aabb& box) {
  constexpr double kLongest = 3;  // metres, of what is set on tables and floors
  const double length = (box.upper - box.lower).maxCoeff();
  if (length <= kLongest) return "m";
  return length <= 100 * kLongest ? "cm" : "mm";
}

std::optional<UpAxis> likely_up(const Mesh& mesh) {
  constexpr double kDoubtful = 0.2;
  const Aabb box = mesh.box();
  if (box.empty() || !((box.upper - box.lower).maxCoeff() > 0)) return std::nullopt;
  const double by_y = standing(mesh, box, 1) - standing(mesh, box, 2);
  if (std::abs(by_y) <= kDoubtful) return std::nullopt;
  return by_y > 0 ? UpAxis::Y : UpAxis::Z;
}

std::string model_info_json(const Model& model, const Shape& shape) {
  const Topology t = topology(shape.adjacency);
  const Aabb box = shape.mesh.box();
  OrderedJson json = {{"file", model.path},
                      {"format", model.format},
                      {"nodes", model.num_nodes},
                      {"materials", model.materials.size()},
                      {"look", look_json(model)},
                      {"images", images_json(model)},
                      {"polygonised", polygonised_json(model)},
                      {"triangles", shape.mesh.triangles.size()},
                      {"vertices", shape.mesh.vertices.size()},
                      {"edges", t.num_edges},
                      {"components", shape.adjacency.components.size()},
                      {"closed", t.closed},
                      {"oriented", t.oriented},
                      {"manifold", t.manifold},
                      {"boundary_edges", t.boundary_edges},
                      {"non_manifold_edges", t.non_manifold_edges},
                      {"flipped_edges", t.flipped_edges}};
  json["box"] = {{"lower", to_json(box.lower)}, {"upper", to_json(box.upper)}};
  json["size"] = to_json(Vec3(box.upper - box.lower));
  json["up"] = model.up == UpAxis::Y ? "y" : "z";
  json["up_reason"] = up_reason(model);
  const auto up = model.up_from_format ? std::nullopt : likely_up(model.mesh);
  json["likely_up"] = up ? OrderedJson(*up == UpAxis::Y ? "y" : "z") : OrderedJson();
  json["metres_per_unit"] =
      model.metres_per_unit ? OrderedJson(*model.metres_per_unit) : OrderedJson();
  json["likely_unit"] = model.metres_per_unit ? OrderedJson() : OrderedJson(likely_unit(box));
  json["mass_rule"] = to_string(shape.mass.rule);
  json["centre"] = to_json(shape.mass.centre);
  json["volume"] = shape.mass.volume;
  json["area"] = shape.mass.area;
  json["parts"] = parts_json(shape);
  json["notes"] = in_english(notes_of(model, shape));
  return readable_json(json);
}

std::string model_info_text(const Model& model, const Shape& shape) {
  const Topology t = topology(shape.adjacency);
  const Aabb box = shape.mesh.box();
  std::ostringstream out;
  out.precision(9);
  out << model.path << "\n"
      << "  format      " << model.format << ", nodes " << model.num_nodes << ", materials "
      << model.materials.size() << "\n"
      << look_text(model) << images_text(model) << polygonised_text(model) << "  triangles   "
      << shape.mesh.triangles.size() << ", vertices " << shape.mesh.vertices.size()
      << ", components " << shape.adjacency.components.size() << "\n"
      << "  closed      " << yes_no(t.closed) << ", oriented " << yes_no(t.oriented)
      << ", manifold " << yes_no(t.manifold) << "\n"
      << "  edges       " << t.num_edges << ", at the boundary " << t.boundary_edges
      << ", non-manifold " << t.non_manifold_edges << ", flipped " << t.flipped_edges << "\n"
      << "  box         " << vector_text(box.lower) << " to " << vector_text(box.upper) << "\n"
      << "  size        " << vector_text(box.upper - box.lower) << " in units of the file\n"
      << "  up          " << (model.up == UpAxis::Y ? "y" : "z") << " (" << up_reason(model)
      << ")\n"
      << "  unit        ";
  if (model.metres_per_unit)
    out << *model.metres_per_unit << " metres, says the file; applied where no scale is given\n";
  else
    out << "the file does not say; by its size likely " << likely_unit(box) << "\n";
  out << "  mass        by " << to_string(shape.mass.rule) << ", centre "
      << vector_text(shape.mass.centre) << "\n"
      << "  volume      " << shape.mass.volume << ", area " << shape.mass.area << "\n";
  out << parts_text(shape);
  for (const Sentence& note : notes_of(model, shape))
    out << "  note        " << in_english(note) << "\n";
  return out.str();
}

}  // namespace trivet
