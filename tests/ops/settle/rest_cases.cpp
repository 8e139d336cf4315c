#include "rest_cases.h"

#include <algorithm>
#include <filesystem>

#include "apps/demo/shapes/models.h"
#include "core/base/tunables.h"
#include "core/io/read_model.h"
#include "core/model/model.h"
#include "support/settle_options.h"
#include "support/shared_data.h"
#include "support/solids.h"

namespace trivet::test {
namespace {

constexpr double kObjectSize = 0.2, kSupportSize = 0.4;  // metres, diagonals

double scale_to(const Shape& shape, double size) { return size / shape.box.diagonal(); }

Vec3 middle(const Body& body) { return body.world_box.centre(); }

// The item with the middle of its box at `place`.
FixedBody body_at(const Stock::Item& item, double size, const Rotation& rotation,
                  const Vec3& place) {
  FixedBody out{item.shape, item.up, scale_to(*item.shape, size), {rotation, Vec3::Zero()}};
  out.pose.translation = place - middle(out.body());
  return out;
}

const Stock::Item& any(const std::vector<Stock::Item>& items, Random& random) {
  return items[random.integer(0, static_cast<int>(items.size()) - 1)];
}

// A support as it stands or turned about z, or two side by side, or one in any orientation.
void add_supports(RestCase& out, const Stock& stock, Random& random) {
  const int kind = random.integer(0, 4);
  out.scene->floor = random.integer(0, 3) != 0;
  const int num = kind == 0 ? 0 : kind == 4 ? 2 : 1;
  if (num == 0) out.scene->floor = true;
  for (int i = 0; i < num; ++i) {
    const Stock::Item& item = any(stock.supports, random);
    const Rotation rotation =
        kind == 3 ? random.rotation() : Rotation::about_axis(Vec3::UnitZ(), random.uniform(-1, 1));
    Vec3 place = num == 2 ? Vec3(i ? 0.15 : -0.15, random.uniform(-0.05, 0.05), 0) : Vec3::Zero();
    FixedBody body = body_at(item, random.uniform(0.7, 1) * kSupportSize, rotation, place);
    body.pose.translation.z() += out.clearance - body.body().world_box.lower.z();
    out.add(body);
    out.name += " on " + item.name;
  }
}

// Every third object is left where it first touches: some are at rest there, too.
bool bring_to_rest(RestCase& rest, bool settles) {
  const Neighbourhood others = rest.others();
  SettleProblem problem = rest.problem(others);
  if (settles) {
    problem.options.max_motions = 400;
    const SettleOutcome out = settle(problem);
    rest.pose = out.pose;
    return out.status == SettleOutcome::Status::AtRest;
  }
  const Body body = rest.body();
  const Motion fall = Motion::translation(-Vec3::UnitZ(), 10);
  const FirstContact found = first_contact({&body, 1}, others, fall, {rest.clearance}, nullptr);
  if (found.status != FirstContact::Status::Contact) return false;
  rest.pose = moved_pose(rest.pose, fall, found.time);
  return true;
}

Vec3 direction_from(Side side, Random& random) {
  for (;;) {
    const Vec3 d = random.direction();
    if (side == Side::Above   ? d.z() > 0.5
        : side == Side::Below ? d.z() < -0.5
                              : std::abs(d.z()) < 0.3)
      return d;
  }
}

}  // namespace

// --- stocks ------------------------------------------------------------------------------------

Stock made_stock() {
  Stock out;
  const auto object = [&](const char* name, const Triangles& triangles) {
    out.objects.push_back({name, shape_of(triangles)});
  };
  const auto support = [&](const char* name, const Triangles& triangles) {
    out.supports.push_back({name, shape_of(triangles)});
  };
  object("box", box_triangles(Vec3(0.5, 0.35, 0.25)));
  object("tetrahedron", tetrahedron(1));
  object("cylinder", cylinder(0.25, 0.8, 24));
  object("plate", cylinder(0.5, 0.06, 32));
  object("torus", torus(0.35, 0.12, 20, 10));
  object("ball", ball(0.4, 8, 12));
  object("stick", stick(1));
  object("hook", hook(0.6, 0.15, 0.05));
  object("dish", dish(0.15, 0.05, 0.01, 1.5, 24));
  object("bumps", bumpy_sphere(20, 30, 0.1, 5));
  support("box", box_triangles(Vec3(0.2, 0.3, 0.1)));
  support("bowl", dish(0.3, 0.25, 0.01, 1.3, 24));
  support("saucer", dish(0.15, 0.03, 0.006, 1.5, 24));
  support("peg",
          revolved({{0, 0}, {0.2, 0}, {0.2, 0.02}, {0.03, 0.03}, {0.02, 0.4}, {0, 0.42}}, 16));
  support("ball", ball(0.3, 10, 16));
  support("slope", prism({{-0.6, 0}, {0.6, 0}, {0.6, 0.8}}, 0.6));
  support("ridge", prism({{-0.3, 0}, {0.3, 0}, {0, 0.6}}, 0.4));
  support("bar", joined(moved(rod({{-0.5, 0, 0}, {0.5, 0, 0}}, 0.02, 12), Vec3(0, 0, 0.3)),
                        moved(box_triangles(Vec3(0.02, 0.02, 0.12)), Vec3(0.45, 0, 0.13))));
  support("torus", torus(0.35, 0.12, 20, 10));
  return out;
}

Stock demo_stock() {
  Stock out;
  for (const char* name : {"saucer", "plate", "cup", "glass", "bowl", "spoon", "knife", "apple",
                           "toast", "loaf", "egg"})
    out.objects.push_back({name, make_shape(shapes::make_model(name).mesh)});
  out.supports = out.objects;
  return out;
}

Stock real_stock() {
  Stock out;
  const auto add = [](std::vector<Stock::Item>& to, const char* file, UpAxis up) {
    const std::string path = shared_data("models/") + file;
    if (std::filesystem::exists(path)) to.push_back({file, make_shape(read_model(path).mesh), up});
  };
  for (const char* file : {"sh3d_c0_bread.obj", "sh3d_by_choppingBoard.obj",
                           "gazebo_plastic_cup.obj", "sh3d_by_spoon.obj", "sh3d_by_knife.obj",
                           "sh3d_by_fork.obj", "sh3d_k_coffee-mug.obj", "sh3d_s_marteau.obj",
                           "sh3d_s_tournevis.obj", "sh3d_s_pencil1.obj", "sh3d_c0_cissors_swap.obj",
                           "ripc_nut-big.obj", "sh3d_by_sunglasses.obj", "sh3d_s_bandeja.obj"})
    add(out.objects, file, UpAxis::Y);
  for (const char* file : {"gso_silver_tape.obj", "ycb_banana.obj", "gso_hammer.obj",
                           "gso_dinosaur_figure.obj", "ycb_mug.obj"})
    add(out.objects, file, UpAxis::Z);
  for (const char* file :
       {"sh3d_s_shopping-basket.obj", "fsim_dishwasher_rack.stl", "sh3d_c0_foldingChair.obj",
        "sh3d_c0_wheelbarrow.obj", "sh3d_c0_barrel.obj", "sh3d_k_bread-plate.obj",
        "sh3d_s_sushi_tray.obj", "sh3d_c0_pallet.obj"})
    add(out.supports, file, UpAxis::Y);
  for (const char* file : {"contactdb_bowl.stl", "ycb_bowl.obj", "libero_plate.obj",
                           "trimesh_chair_model.obj", "aws_KitchenUtensils_01.obj"})
    add(out.supports, file, UpAxis::Z);
  return out;
}

// --- cases -------------------------------------------------------------------------------------

SettleProblem RestCase::problem(const Neighbourhood& others) const {
  SettleProblem out;
  out.options = options;
  out.shape = shape.get();
  out.up = up;
  out.scale = scale;
  out.start = pose;
  out.others = &others;
  out.clearance = clearance;
  return out;
}

std::vector<ContactPoint> RestCase::contacts() const {
  const double tolerance = kContactTolerance * clearance;
  return all_points(contacts_with(body(), others(), tolerance, kFootSlack * clearance), tolerance);
}

void RestCase::add(const FixedBody& body) {
  Object object;
  object.name = std::to_string(scene->num_objects());
  object.shape = body.shape;
  object.up = body.up;
  object.scale = body.scale;
  object.pose = body.pose;
  object.fixed = object.placed = true;
  object.state = ObjectState::Fixed;
  scene->add(std::move(object));
}

RestCase RestCase::with(const FixedBody& neighbour) const {
  RestCase out = *this;
  out.scene = std::make_shared<Scene>(*scene);
  out.add(neighbour);
  return out;
}

std::optional<RestCase> rest_case(const Stock& stock, int index, const SettleOptions& options) {
  Random random(7000 + static_cast<unsigned>(index));
  const Stock::Item& item = any(stock.objects, random);
  RestCase out;
  out.name = item.name;
  out.shape = item.shape;
  out.up = item.up;
  out.scale = scale_to(*item.shape, kObjectSize);
  out.clearance = kRelativeClearance;
  out.options = options;
  add_supports(out, stock, random);
  const double top = std::max(0.0, out.scene->box().upper.z());
  out.pose = {random.rotation(), random.beside(0.12, 0)};
  out.pose.translation.z() += top + 0.05 - out.body().world_box.lower.z();
  if (!bring_to_rest(out, index % 3 != 2)) return std::nullopt;
  const Neighbourhood others = out.others();
  if (!is_at_rest(out.problem(others))) return std::nullopt;
  return out;
}

const char* to_string(Side side) {
  return side == Side::Above ? "above" : side == Side::Below ? "below" : "beside";
}

std::optional<FixedBody> neighbour_of(const RestCase& rest, const Stock& stock, Side side,
                                      Random& random) {
  const Body object = rest.body();
  const Stock::Item& item = any(stock.objects, random);
  const Vec3 from = direction_from(side, random);
  const double size = random.uniform(0.3, 1.5) * kObjectSize;
  const Rotation rotation = random.integer(0, 2) ? random.rotation() : Rotation{};
  const Vec3 aim = middle(object) + random.in_cube(0.3 * kObjectSize);
  FixedBody out = body_at(item, size, rotation, aim + 3 * kObjectSize * from);
  const Body start = out.body();
  FirstContactQuery query;
  query.moving = {&start, 1};
  query.fixed = {&object, 1};
  query.motion = Motion::translation(-from, 4 * kObjectSize);
  query.clearance.distance = rest.clearance;
  const FirstContact found = first_contact(query);
  if (found.status != FirstContact::Status::Contact) return std::nullopt;
  out.pose.translation -= found.time * from;
  return out;
}

}  // namespace trivet::test
