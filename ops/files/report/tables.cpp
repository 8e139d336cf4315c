#include "ops/files/report/tables.h"

#include <cmath>
#include <filesystem>

#include "core/base/error.h"
#include "core/base/extension.h"
#include "core/io/atomic_file.h"
#include "ops/files/report/json_parts.h"
#include "ops/files/report/models_of_shapes.h"
#include "ops/files/report/npy.h"

namespace trivet {
namespace {

constexpr const char* kMatrix[3][4] = {
    {"m00", "m01", "m02", "m03"}, {"m10", "m11", "m12", "m13"}, {"m20", "m21", "m22", "m23"}};

using TableRows = std::vector<OrderedJson>;  // objects with the same keys each

void add_vector(OrderedJson& row, std::initializer_list<const char*> keys, const Vec3* v) {
  int i = 0;
  for (const char* key : keys) row[key] = v ? OrderedJson((*v)[i++]) : OrderedJson();
}

void add_pose(OrderedJson& row, const Object& object) {
  const bool placed = object.placed;
  const Rotation& q = object.pose.rotation;
  add_vector(row, {"x", "y", "z"}, placed ? &object.pose.translation : nullptr);
  const std::pair<const char*, double> quaternion[] = {
      {"qw", q.w}, {"qx", q.x}, {"qy", q.y}, {"qz", q.z}};
  for (const auto& [key, value] : quaternion)
    row[key] = placed ? OrderedJson(value) : OrderedJson();
  row["scale"] = object.scale;
  row["up"] = object.up == UpAxis::Y ? "y" : "z";
  const Affine m = object.world_from_object();
  for (int r = 0; r < 3; ++r)
    for (int c = 0; c < 4; ++c) {
      const double entry = c < 3 ? m.linear(r, c) : m.translation[r];
      row[kMatrix[r][c]] = placed ? OrderedJson(entry) : OrderedJson();
    }
}

TableRows pose_rows(const Scene& scene) {
  TableRows rows;
  for (const ObjectId id : scene.ids()) {
    const Object& object = scene.at(id);
    OrderedJson row = {{"name", object.name},
                       {"model", model_path(object)},
                       {"state", to_string(object.state)},
                       {"fixed", object.fixed}};
    add_pose(row, object);
    const Vec3 centre = object.centre_of_mass();
    add_vector(row, {"com_x", "com_y", "com_z"}, object.placed ? &centre : nullptr);
    const bool rests = object.placed && !object.fixed;
    row["stability_margin"] = rests ? OrderedJson(object.stability_margin) : OrderedJson();
    row["least_friction"] = rests ? OrderedJson(object.least_friction) : OrderedJson();
    row["material"] = object.material.name;
    row["friction"] = object.material.friction;
    row["density"] = object.material.density;
    row["restitution"] = object.material.restitution;
    rows.push_back(std::move(row));
  }
  return rows;
}

TableRows contact_rows(const Scene& scene) {
  TableRows rows;
  for (const ObjectId id : scene.ids()) {
    const Object& object = scene.at(id);
    if (!object.placed) continue;
    for (size_t i = 0; i < object.contacts.size(); ++i) {
      const ObjectContact& link = object.contacts[i];
      for (const ContactPoint& p : link.contact.points) {
        OrderedJson row = {{"object", object.name},
                           {"with", named(scene, link.with).name},
                           {"contact", i},
                           {"type", to_string(link.contact.type)}};
        add_vector(row, {"x", "y", "z"}, &p.point);
        add_vector(row, {"nx", "ny", "nz"}, &p.normal);
        row["gap"] = p.gap;
        rows.push_back(std::move(row));
      }
    }
  }
  return rows;
}

TableRows rows_of(const Scene& scene, Table table) {
  return table == Table::Poses ? pose_rows(scene) : contact_rows(scene);
}

std::vector<std::string> columns(Table table) {
  if (table == Table::Contacts)
    return {"object", "with", "contact", "type", "x", "y", "z", "nx", "ny", "nz", "gap"};
  return {"name",
          "model",
          "state",
          "fixed",
          "x",
          "y",
          "z",
          "qw",
          "qx",
          "qy",
          "qz",
          "scale",
          "up",
          "m00",
          "m01",
          "m02",
          "m03",
          "m10",
          "m11",
          "m12",
          "m13",
          "m20",
          "m21",
          "m22",
          "m23",
          "com_x",
          "com_y",
          "com_z",
          "stability_margin",
          "least_friction",
          "material",
          "friction",
          "density",
          "restitution"};
}

std::string csv_field(const OrderedJson& value) {
  if (value.is_null()) return "";
  if (value.is_number_float() && !std::isfinite(value.get<double>())) return "inf";
  if (!value.is_string()) return value.dump();
  const std::string& text = value.get_ref<const std::string&>();
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string out = "\"";
  for (const char c : text) out.append(c == '"' ? 2 : 1, c);
  return out += '"';
}

}  // namespace

std::string table_csv(const Scene& scene, Table table) {
  const std::vector<std::string> keys = columns(table);
  std::string out;
  for (const std::string& key : keys) (out += out.empty() ? "" : ",") += key;
  out += "\r\n";
  for (const OrderedJson& row : rows_of(scene, table)) {
    for (const std::string& key : keys) {
      if (&key != &keys.front()) out += ',';
      out += csv_field(row.at(key));
    }
    out += "\r\n";
  }
  return out;
}

std::string table_json_lines(const Scene& scene, Table table) {
  std::string out;
  for (const OrderedJson& row : rows_of(scene, table))
    out += row.dump(-1, ' ', false, OrderedJson::error_handler_t::replace) + "\n";
  return out;
}

std::string table_npy(const Scene& scene, Table table) {
  return npy_records(columns(table), rows_of(scene, table));
}

std::string arena_line(const Scene& scene, const std::string& id) {
  OrderedJson poses = OrderedJson::object();
  for (const ObjectId object_id : scene.ids()) {
    const Object& object = scene.at(object_id);
    if (!object.placed || object.fixed) continue;
    const Vec3& p = object.pose.translation;
    const Rotation& q = object.pose.rotation;
    poses[object.name] = {{"position_xyz", {p.x(), p.y(), p.z()}},
                          {"rotation_xyzw", {q.x, q.y, q.z, q.w}}};
  }
  if (poses.empty())
    throw Error(Error::Kind::BadInput,
                "no free object is placed; accepted: a scene with one, as a layout of Arena has "
                "their poses");
  const OrderedJson line = {{"variations",
                             {{"scene.relation_placement",
                               {{"layout_id", id}, {"source", "trivet"}, {"poses", poses}}}}}};
  return line.dump(-1, ' ', false, OrderedJson::error_handler_t::replace) + "\n";
}

bool is_table_extension(const std::string& extension) {
  return extension == ".csv" || extension == ".jsonl" || extension == ".npy";
}

void write_table(const Scene& scene, Table table, const std::string& path) {
  const std::string extension = lower_extension(path);
  if (table == Table::Arena) {
    if (extension != ".jsonl")
      throw Error(Error::Kind::BadInput,
                  "%1: a layout of Arena is a line of JSON; accepted: .jsonl", path);
    return write_file_atomically(path,
                                 arena_line(scene, std::filesystem::path(path).stem().string()));
  }
  write_file_atomically(path, extension == ".npy"     ? table_npy(scene, table)
                              : extension == ".jsonl" ? table_json_lines(scene, table)
                                                      : table_csv(scene, table));
}

}  // namespace trivet
