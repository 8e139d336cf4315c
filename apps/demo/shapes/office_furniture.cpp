// Desk, bookcase and swivel chair. Their fronts are at -y; where a person sits is the front of the
// desk and of the chair.
#include "apps/demo/shapes/models.h"
#include "apps/demo/shapes/palette.h"
#include "apps/demo/shapes/parts.h"

namespace trivet::shapes {
namespace {

constexpr double kFurnitureOverlap = 0.001;  // how deep parts go into each other

// Three drawers one over the other, a cabinet around them, a bow handle on each.
void add_drawers(double x_low, double x_high, double top, Index board, Index front, Index metal,
                 std::vector<Part>* parts) {
  add_box({x_low, -0.270, 0}, {x_high, 0.310, top}, 0.002, board, parts);
  const double bottoms[] = {0.030, 0.330, 0.535}, tops[] = {0.324, 0.529, 0.690};
  for (int i = 0; i < 3; ++i) {
    add_box({x_low + 0.004, -0.290, bottoms[i]},
            {x_high - 0.004, -0.270 + kFurnitureOverlap, tops[i]}, 0.002, front, parts);
    const double middle = 0.5 * (x_low + x_high), z = tops[i] - 0.055;
    parts->push_back({painted(moved(bow_handle(0.065), {middle, -0.290, z}), metal), 60});
  }
}

}  // namespace

Model make_desk() {
  constexpr Index kTop = 0, kBody = 1, kFront = 2, kMetal = 3;
  std::vector<Part> parts;
  const double under = kDeskHeight - 0.028, top = under + kFurnitureOverlap;
  parts.push_back({painted(skin(slab({0.750, 0.350}, 0.018, 0.004, under, kDeskHeight, 4)), kTop)});
  add_drawers(0.290, 0.710, top, kBody, kFront, kMetal, &parts);
  add_box({-0.720, -0.310, 0}, {-0.690, 0.310, top}, 0.002, kBody, &parts);
  add_box({-0.690 - kFurnitureOverlap, 0.240, 0.340}, {0.290 + kFurnitureOverlap, 0.258, top},
          0.002, kBody, &parts);
  return assemble("desk", parts,
                  {make_material("desk top", 0.50f, 0.30f, 0.14f, 0.45f),
                   make_material("desk body", 0.60f, 0.60f, 0.58f, 0.6f),
                   make_material("drawer front", 0.50f, 0.30f, 0.14f, 0.5f), silver()});
}

Model make_wall() {
  return assemble("wall", {{painted(box({-1.6, -0.06, 0}, {1.6, 0.06, 2.1}), 0), 40}},
                  {make_material("wall", 0.72f, 0.70f, 0.64f, 0.9f)});
}

Model make_bookcase() {
  constexpr Index kWood = 0, kBack = 1;
  const double half_width = 0.360, side = 0.020, front = -0.165, back = 0.165;
  std::vector<Part> parts;
  for (const double s : {-1.0, 1.0}) {
    const double inner = s * (half_width - side), outer = s * half_width;
    add_box({std::min(inner, outer), front, 0}, {std::max(inner, outer), back, kBookcaseHeight},
            0.0015, kWood, &parts);
  }
  const double inside = half_width - side + kFurnitureOverlap;
  for (const double height : kBookcaseBoards)
    add_box({-inside, front + 0.003, height - 0.020}, {inside, back - 0.002, height}, 0.0015, kWood,
            &parts);
  add_box({-inside, front, kBookcaseHeight - 0.020}, {inside, back, kBookcaseHeight - 0.0005},
          0.0015, kWood, &parts);
  add_box({-inside, front + 0.020, 0}, {inside, front + 0.036, kBookcaseBoards[0] - 0.019}, 0,
          kWood, &parts);
  add_box({-inside, back - 0.010, 0.010}, {inside, back - 0.001, kBookcaseHeight - 0.010}, 0, kBack,
          &parts);
  return assemble("bookcase", parts,
                  {make_material("bookcase", 0.42f, 0.235f, 0.10f, 0.5f),
                   make_material("bookcase back", 0.33f, 0.18f, 0.075f, 0.7f)});
}

namespace {

constexpr Index kPlastic = 1, kSteel = 2;  // after the fabric

// One of the five feet: an arm that falls off outwards, and a castor under its end.
void add_foot(double angle_deg, std::vector<Part>* parts) {
  const auto arm =
      flatten({smooth({0.020, 0.105, 0.017, 0.024}), smooth({0.120, 0.096, 0.015, 0.021}),
               smooth({0.240, 0.079, 0.012, 0.016}), smooth({0.292, 0.066, 0.009, 0.012})},
              0.0015);
  const auto rim = flatten(
      {corner({0, -0.020}), smooth({0.020, -0.020}), smooth({0.0265, -0.016}), smooth({0.0275, 0}),
       smooth({0.0265, 0.016}), smooth({0.020, 0.020}), corner({0, 0.020})},
      0.0010);
  // The wheel stands on a facet, which runs along its axis.
  Surface wheel = turned(skin(revolve(rim, {16, 16, 0})), Vec3::UnitZ(), 360.0 / 32);
  wheel = moved(turned(wheel, Vec3::UnitX(), 90), {0.280, 0, 0.0275});
  const Surface pin = rod({0.280, 0, 0.045}, {0.280, 0, 0.072}, 0.007, 0.007, 8);
  for (const Surface& surface : {skin(sweep(arm, 10)), wheel, pin})
    parts->push_back({painted(turned(surface, Vec3::UnitZ(), angle_deg), kPlastic), 55});
}

// A cushion that is hollow by `dip` in the middle and bends by `bend` towards the ends of x.
Surface upholstery(const Vec2& half_size, double thickness, double dip, double bend) {
  const double t = thickness;
  auto rings = cushion(half_size, 0.105,
                       flatten({corner({0.030, 0}), smooth({0.008, 0.2 * t}), smooth({0, 0.5 * t}),
                                smooth({0.008, 0.8 * t}), smooth({0.030, t}), smooth({0.060, t}),
                                smooth({0.102, t})},
                               0.0012),
                       5);
  const Vec2 h = half_size;
  deform(&rings, [&](const Vec3& p) -> Vec3 {
    const double u = p.x() / h.x(), v = p.y() / h.y();
    const double hollow = p.z() > 0.9 * t ? dip * (1 - u * u) * (1 - v * v) : 0;
    return {p.x(), p.y(), p.z() - hollow + bend * u * u};
  });
  return skin(rings);
}

// A loop from under the seat up to the pad on which the arm rests; on the side of +x.
void add_arm_rest(double turn_deg, std::vector<Part>* parts) {
  const auto loop =
      flatten({corner({0.180, 0.432, 0.010, 0.016}), smooth({0.255, 0.432, 0.010, 0.016}),
               smooth({0.287, 0.455, 0.010, 0.016}), smooth({0.292, 0.520, 0.010, 0.016}),
               corner({0.285, 0.655, 0.010, 0.016})},
              0.0015);
  auto pad = slab({0.034, 0.125}, 0.030, 0.008, 0.648, 0.674, 4);
  deform(&pad, [](const Vec3& p) -> Vec3 { return {p.x() + 0.282, p.y() + 0.020, p.z()}; });
  // Turned by half a turn it serves the other side; its pad is moved to where the hand is.
  const Surface bow = turned(skin(sweep(loop, 10)), Vec3::UnitZ(), turn_deg);
  const Vec3 back(0, turn_deg > 0 ? 0.040 : 0, 0);
  parts->push_back({painted(bow, kPlastic), 60});
  parts->push_back({painted(moved(turned(skin(pad), Vec3::UnitZ(), turn_deg), back), kPlastic)});
}

}  // namespace

Model make_chair() {
  std::vector<Part> parts;
  for (int i = 0; i < 5; ++i) add_foot(90 + 72 * i, &parts);
  const auto column =
      flatten({corner({0, 0.085}), corner({0.034, 0.085}), corner({0.034, 0.120}),
               corner({0.026, 0.130}), corner({0.026, 0.270}, kSteel),
               corner({0.015, 0.272}, kSteel), corner({0.015, 0.405}), corner({0, 0.405})},
              0.001);
  Surface post = skin(revolve(column, {20, 20, 0}));
  for (Index& m : post.materials) m = m == kSteel ? kSteel : kPlastic;
  parts.push_back({std::move(post), 50});
  add_box({-0.110, -0.110, 0.400}, {0.110, 0.130, 0.430}, 0.006, kPlastic, &parts);
  parts.push_back({moved(upholstery({0.245, 0.235}, 0.075, 0.018, 0), {0, 0, 0.424}), 60});
  // The back stands on its lower end and leans by 10 degrees; a bar joins it to the seat.
  Surface back = upholstery({0.215, 0.215}, 0.055, 0.006, 0.045);
  back = turned(turned(std::move(back), Vec3::UnitX(), 90), Vec3::UnitX(), -10);
  parts.push_back({moved(std::move(back), {0, 0.262, 0.765}), 60});
  const auto bar =
      flatten({corner({0.080, 0.414, 0.009, 0.030}), smooth({0.240, 0.414, 0.009, 0.030}),
               smooth({0.290, 0.450, 0.009, 0.030}), smooth({0.300, 0.560, 0.009, 0.030}),
               corner({0.288, 0.740, 0.009, 0.030})},
              0.0015);
  parts.push_back({painted(turned(skin(sweep(bar, 12)), Vec3::UnitZ(), 90), kPlastic), 60});
  for (const double turn_deg : {0.0, 180.0}) add_arm_rest(turn_deg, &parts);
  return assemble("chair", parts,
                  {make_material("fabric", 0.045f, 0.12f, 0.22f, 0.9f), black_plastic(), silver()});
}

}  // namespace trivet::shapes
