// Monitor, keyboard, mouse, telephone and lamp. They face the person, who sits at -y.
#include <cmath>

#include "apps/demo/shapes/models.h"
#include "apps/demo/shapes/palette.h"
#include "apps/demo/shapes/parts.h"

namespace trivet::shapes {
namespace {

constexpr double kDeviceOverlap = 0.0005;  // how deep parts go into each other

// A key cap, its top a little smaller than its foot; the foot's middle at the origin.
Surface key_cap(const Vec2& size, double height) {
  const Vec2 h = 0.5 * size;
  return skin({rectangle(h, -kDeviceOverlap), rectangle(h - Vec2(0.0015, 0.0015), height)});
}

// A rectangle of the picture on the screen, which stands out by half a millimetre per layer.
void add_pixels(const Vec2& lower, const Vec2& upper, int layer, Index material,
                std::vector<Part>* parts) {
  const double front = -0.0005 * layer, back = kDeviceOverlap + 0.0002 * layer;
  parts->push_back(
      {painted(box({lower.x(), front, lower.y()}, {upper.x(), back, upper.y()}), material)});
}

}  // namespace

Model make_monitor() {
  constexpr Index kCase = 0, kScreen = 1, kPaper = 2, kBar = 3, kInk = 4, kAccent = 5;
  std::vector<Part> face;  // its front in the plane y = 0, its middle at the origin
  face.push_back({painted(box({-0.272, 0, -0.168}, {0.272, 0.024, 0.162}, 0.004), kCase), 40});
  face.push_back({painted(box({-0.150, 0.020, -0.100}, {0.150, 0.050, 0.100}, 0.007), kCase), 40});
  add_pixels({-0.262, -0.146}, {0.262, 0.152}, 1, kScreen, &face);
  add_pixels({-0.262, -0.146}, {0.262, -0.132}, 2, kInk, &face);
  add_pixels({-0.230, -0.105}, {0.040, 0.120}, 2, kPaper, &face);
  add_pixels({-0.230, 0.106}, {0.040, 0.120}, 3, kBar, &face);
  const double ends[] = {-0.02, 0.020, 0.010, 0.022, -0.06, 0.018, 0.024, 0.005, 0.020, -0.09};
  for (int i = 0; i < 10; ++i)
    add_pixels({-0.214, 0.083 - 0.0185 * i}, {ends[i], 0.089 - 0.0185 * i}, 3, kInk, &face);
  add_pixels({0.075, -0.040}, {0.235, 0.075}, 2, kPaper, &face);
  const double bars[] = {0.030, 0.055, 0.042, 0.078, 0.066};
  for (int i = 0; i < 5; ++i)
    add_pixels({0.090 + 0.028 * i, -0.028}, {0.108 + 0.028 * i, -0.028 + bars[i]}, 3, kAccent,
               &face);
  std::vector<Part> parts;
  for (Part& part : face) {
    part.surface = moved(turned(part.surface, Vec3::UnitX(), -4), {0, -0.020, 0.300});
    parts.push_back(std::move(part));
  }
  parts.push_back({painted(skin(slab({0.125, 0.095}, 0.030, 0.003, 0, 0.012, 5)), kCase), 40});
  parts.push_back(
      {painted(box({-0.035, 0.034, 0.012 - kDeviceOverlap}, {0.035, 0.052, 0.330}, 0.004), kCase),
       40});
  return assemble("monitor", parts,
                  {black_plastic(), make_material("screen", 0.035f, 0.13f, 0.24f, 0.25f),
                   white_paper(), make_material("title bar", 0.05f, 0.22f, 0.50f, 0.4f),
                   make_material("screen text", 0.10f, 0.11f, 0.13f, 0.4f),
                   make_material("chart", 0.85f, 0.30f, 0.05f, 0.4f)});
}

namespace {

constexpr double kKeyPitch = 0.019;

// A row of keys from `x` on, each as wide as it says, in pitches; a negative number is a gap.
void add_keys(const std::vector<double>& widths, double x, double y, double z, Index material,
              std::vector<Part>* parts) {
  for (const double width : widths) {
    const double step = std::abs(width) * kKeyPitch;
    if (width > 0) {
      const Surface cap = key_cap({step - 0.0022, kKeyPitch - 0.0022}, 0.0065);
      const Index m = width == 1 ? material : material + 1;
      parts->push_back({painted(moved(cap, {x + 0.5 * step, y, z}), m), 20});
    }
    x += step;
  }
}

}  // namespace

Model make_keyboard() {
  constexpr Index kCase = 0, kKey = 1;
  const Vec2 half(0.218, 0.070);
  const auto top = [&](double y) { return 0.0145 + 0.055 * (y + half.y()); };
  auto base = slab(half, 0.010, 0.002, 0, 0.0145, 3);
  deform(&base, [&](const Vec3& p) -> Vec3 {
    return p.z() < 0.010 ? p : Vec3(p.x(), p.y(), p.z() + top(p.y()) - 0.0145);
  });
  std::vector<Part> parts{{painted(skin(base), kCase), 40}};
  const double left = -0.208;
  const auto row = [&](int i, const std::vector<double>& widths) {
    const double y = -0.0475 + kKeyPitch * i + (i == 5 ? 0.005 : 0);
    add_keys(widths, left, y, top(y), kKey, &parts);
  };
  const double g = -0.4;  // the gap before the arrows and before the numbers
  row(0, {1.25, 1.25, 1.25, 6.25, 1.25, 1.25, 1.25, 1.25, g, 1, 1, 1, g, 2, 1, 1});
  row(1, {2.25, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 2.75, g, -1, 1, -1, g, 1, 1, 1, 1});
  row(2, {1.75, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 2.25, g, -1, -1, -1, g, 1, 1, 1, 1});
  row(3, {1.5, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1.5, g, 1, 1, 1, g, 1, 1, 1, 1});
  row(4, {1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 2, g, 1, 1, 1, g, 1, 1, 1, 1});
  row(5, {1, -1, 1, 1, 1, 1, -0.5, 1, 1, 1, 1, -0.5, 1, 1, 1, 1, g, 1, 1, 1});
  return assemble("keyboard", parts,
                  {make_material("keyboard", 0.085f, 0.09f, 0.10f, 0.5f),
                   make_material("key", 0.66f, 0.66f, 0.63f, 0.5f),
                   make_material("wide key", 0.38f, 0.39f, 0.40f, 0.5f)});
}

Model make_mouse() {
  constexpr Index kWheel = 1;
  auto dome = cushion({0.031, 0.056}, 0.0305,
                      flatten({corner({0.0020, 0}), smooth({0, 0.0060}), smooth({0.0015, 0.0160}),
                               smooth({0.0060, 0.0250}), smooth({0.0140, 0.0315}),
                               smooth({0.0230, 0.0350}), smooth({0.0300, 0.0360})},
                              0.0006),
                      6);
  // Lower to the front, higher to the back.
  deform(&dome, [](const Vec3& p) -> Vec3 {
    return {p.x(), p.y(), p.z() * (0.88 - 4.2 * p.y() * p.y() - 2.6 * p.y())};
  });
  const auto rim = flatten({corner({0, -0.0035}), smooth({0.0085, -0.0035}), smooth({0.0100, 0}),
                            smooth({0.0085, 0.0035}), corner({0, 0.0035})},
                           0.0004);
  const Surface wheel = turned(skin(revolve(rim, {18, 18, 0})), Vec3::UnitY(), 90);
  return assemble("mouse",
                  {{skin(dome), 60}, {painted(moved(wheel, {0, 0.026, 0.0222}), kWheel), 50}},
                  {make_material("mouse", 0.085f, 0.09f, 0.10f, 0.35f),
                   make_material("wheel", 0.30f, 0.31f, 0.33f, 0.6f)});
}

namespace {

// The handset: a bow with two round cups that look down. Along y, its middle over the origin.
void add_handset(double x, double z, Index material, std::vector<Part>* parts) {
  const auto bow =
      flatten({smooth({-0.098, 0.004, 0.010, 0.019}), smooth({-0.092, 0.014, 0.012, 0.022}),
               smooth({-0.060, 0.026, 0.010, 0.018}), smooth({0, 0.031, 0.009, 0.017}),
               smooth({0.060, 0.026, 0.010, 0.018}), smooth({0.092, 0.014, 0.012, 0.022}),
               smooth({0.098, 0.004, 0.010, 0.019})},
              0.0010);
  const Surface grip = turned(skin(sweep(bow, 14)), Vec3::UnitZ(), 90);
  parts->push_back({painted(moved(grip, {x, 0, z}), material), 60});
  const auto cup = flatten({corner({0, -0.014}), smooth({0.020, -0.014}), smooth({0.026, -0.008}),
                            smooth({0.025, 0.004}), corner({0.016, 0.012}), corner({0, 0.012})},
                           0.0007);
  for (const double y : {-0.080, 0.080}) {
    const Surface round = moved(skin(revolve(cup, {22, 22, 0})), {x, y, z});
    parts->push_back({painted(round, material), 50});
  }
}

// From the lower end of the handset down to the table and into the case.
Part telephone_cord(double x, Index material) {
  const auto path =
      flatten({smooth({-0.088, 0.066, 0.0028, 0.0028}), smooth({-0.122, 0.050, 0.0028, 0.0028}),
               smooth({-0.140, 0.022, 0.0028, 0.0028}), smooth({-0.128, 0.0045, 0.0028, 0.0028}),
               smooth({-0.085, 0.0085, 0.0028, 0.0028})},
              0.0007);
  return {painted(moved(turned(skin(sweep(path, 8)), Vec3::UnitZ(), 90), {x, 0, 0}), material), 60};
}

}  // namespace

Model make_telephone() {
  constexpr Index kCase = 0, kKey = 1, kDisplay = 2, kDark = 3;
  const auto top = [](double y) { return 0.048 + 0.18 * y; };
  auto body = slab({0.105, 0.100}, 0.014, 0.004, 0, 0.048, 4);
  deform(&body, [&](const Vec3& p) -> Vec3 {
    return p.z() < 0.020 ? p : Vec3(p.x(), p.y(), p.z() + top(p.y()) - 0.048);
  });
  std::vector<Part> parts{{painted(skin(body), kCase), 40}};
  const double slope_deg = 10.2;  // of the top: atan(0.18)
  const auto add_on_top = [&](const Surface& surface, double x, double y, Index material) {
    const Surface tilted = turned(surface, Vec3::UnitX(), slope_deg);
    parts.push_back({painted(moved(tilted, {x, y, top(y)}), material), 40});
  };
  for (int row = 0; row < 4; ++row)
    for (int column = 0; column < 3; ++column)
      add_on_top(key_cap({0.017, 0.013}, 0.0045), 0.020 + 0.023 * column, -0.068 + 0.020 * row,
                 kKey);
  add_on_top(box({-0.038, -0.018, -kDeviceOverlap}, {0.038, 0.018, 0.0020}, 0.0008), 0.043, 0.050,
             kDisplay);
  for (const double y : {-0.080, 0.080})  // the cradle
    parts.push_back(
        {painted(box({-0.088, y - 0.020, 0.020}, {-0.032, y + 0.020, 0.066}, 0.004), kCase), 40});
  add_handset(-0.060, 0.079, kDark, &parts);
  parts.push_back(telephone_cord(-0.060, kDark));
  return assemble("telephone", parts,
                  {make_material("telephone", 0.62f, 0.57f, 0.46f, 0.45f),
                   make_material("telephone key", 0.80f, 0.78f, 0.72f, 0.45f),
                   make_material("display", 0.22f, 0.28f, 0.18f, 0.25f),
                   make_material("handset", 0.48f, 0.43f, 0.33f, 0.4f)});
}

Model make_lamp() {
  constexpr Index kPaint = 0, kMetal = 1, kInside = 2, kBulb = 3;
  const Vec3 foot(-0.030, 0, 0.020), elbow(-0.115, 0, 0.300), head(0.120, 0, 0.435);
  const auto base = flatten({corner({0, 0}), corner({0.086, 0}), smooth({0.088, 0.006}),
                             smooth({0.080, 0.016}), smooth({0.040, 0.023}), corner({0, 0.025})},
                            0.0008);
  const auto ball = flatten({pole(-0.015), smooth({0.0106, -0.0106}), smooth({0.015, 0}),
                             smooth({0.0106, 0.0106}), pole(0.015)},
                            0.0006);
  // Up the outside, over the rim and back inside to the socket.
  const auto shade = flatten(
      {corner({0, 0.062}), corner({0.020, 0.062}), corner({0.026, 0.040}), smooth({0.030, 0.034}),
       smooth({0.055, -0.010}), smooth({0.082, -0.070}), corner({0.083, -0.078}, kInside),
       corner({0.080, -0.078}, kInside), smooth({0.052, -0.014}, kInside),
       smooth({0.028, 0.028}, kInside), corner({0, 0.030}, kInside)},
      0.0008);
  const auto bulb = flatten(
      {pole(-0.052), smooth({0.020, -0.045}), smooth({0.028, -0.025}), smooth({0.020, 0.000}),
       smooth({0.013, 0.015}), corner({0.013, 0.031}), corner({0, 0.031})},
      0.0008);
  const auto at_head = [&](const std::vector<CurveSample>& profile, int segments) {
    return moved(turned(skin(revolve(profile, {segments, segments, 0})), Vec3::UnitY(), -22),
                 head + Vec3(0.020, 0, -0.045));
  };
  std::vector<Part> parts{{painted(skin(revolve(base, {36, 36, 0})), kPaint), 45},
                          {at_head(shade, 36), 45},
                          {painted(at_head(bulb, 18), kBulb), 60}};
  const Vec3 offset(0, 0.006, 0);  // two rods side by side
  for (const double side : {-1.0, 1.0}) {
    const Vec3 d = side * offset;
    parts.push_back({painted(rod(foot + d, elbow + d, 0.0045, 0.0045, 10), kMetal), 60});
    parts.push_back({painted(rod(elbow + d, head + d, 0.0045, 0.0045, 10), kMetal), 60});
  }
  for (const Vec3& joint : {foot, elbow, head})
    parts.push_back({painted(moved(skin(revolve(ball, {16, 16, 0})), joint), kPaint), 60});
  return assemble("lamp", parts,
                  {make_material("lamp red", 0.60f, 0.045f, 0.03f, 0.3f), silver(),
                   make_material("reflector", 0.90f, 0.89f, 0.85f, 0.4f),
                   make_material("bulb", 1.0f, 0.93f, 0.70f, 0.2f)});
}

}  // namespace trivet::shapes
