// Books, binder, sheets of paper and a ball of it. Books stand upright, their spine at -y.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "apps/demo/shapes/models.h"
#include "apps/demo/shapes/palette.h"
#include "apps/demo/shapes/parts.h"

namespace trivet::shapes {
namespace {

constexpr Index kCover = 0, kPages = 1, kTitle = 2;
constexpr double kPaperOverlap = 0.0003;  // how deep parts go into each other

// Thickness, width and height of the closed book.
struct BookSize {
  double x, y, z;
};

// A coloured stripe of the spine, in shares of its height.
struct Stripe {
  double from, to;
};

// The spine, rounded outwards by `round`: its outline from below to above, with stripes.
Surface spine(const BookSize& size, double board, double round,
              const std::vector<Stripe>& stripes) {
  constexpr int kAcross = 8;
  const auto ring = [&](double z, Index material) {
    Ring out{{}, material};
    for (int k = 0; k <= kAcross; ++k) {
      const double u = -1 + 2.0 * k / kAcross;
      out.points.emplace_back(0.5 * size.x * u, -round * (1 - u * u), z);
    }
    for (int k = 0; k <= kAcross; ++k)
      out.points.emplace_back(0.5 * size.x * (1 - 2.0 * k / kAcross), board, z);
    return out;
  };
  std::vector<Ring> rings{ring(0, kCover)};
  for (const Stripe& stripe : stripes) {
    rings.push_back(ring(stripe.from * size.z, kTitle));
    rings.push_back(ring(stripe.to * size.z, kCover));
  }
  rings.push_back(ring(size.z, kCover));
  return skin(rings);
}

// Two boards, the spine, and the pages a little behind their edges.
std::vector<Part> book_parts(const BookSize& size, double board, double round,
                             const std::vector<Stripe>& stripes) {
  const double half = 0.5 * size.x, margin = 0.0035;
  std::vector<Part> parts{{spine(size, board, round, stripes), 40}};
  for (const double side : {-1.0, 1.0}) {
    const double inner = side * (half - board), outer = side * half;
    parts.push_back({box({std::min(inner, outer), board - kPaperOverlap, 0},
                         {std::max(inner, outer), size.y, size.z}, 0.2 * board),
                     40});
  }
  const double pages = half - board + kPaperOverlap;
  parts.push_back({painted(box({-pages, board - kPaperOverlap, margin},
                               {pages, size.y - margin, size.z - margin}),
                           kPages),
                   40});
  return parts;
}

Model book(const std::string& name, const BookSize& size, const std::vector<Stripe>& stripes,
           const Material& cover, const Material& title) {
  return assemble(name, book_parts(size, 0.0028, 0.004, stripes), {cover, white_paper(), title});
}

}  // namespace

Model make_book_red() {
  return book("book_red", {0.034, 0.165, 0.240}, {{0.08, 0.10}, {0.62, 0.84}, {0.90, 0.92}},
              make_material("red cloth", 0.36f, 0.025f, 0.03f, 0.7f),
              make_material("gold", 0.70f, 0.46f, 0.12f, 0.35f));
}

Model make_book_blue() {
  return book("book_blue", {0.026, 0.150, 0.215}, {{0.12, 0.22}, {0.55, 0.58}, {0.80, 0.83}},
              make_material("blue cloth", 0.03f, 0.10f, 0.30f, 0.7f),
              make_material("silver print", 0.70f, 0.71f, 0.72f, 0.4f));
}

Model make_book_green() {
  return book("book_green", {0.042, 0.175, 0.255}, {{0.06, 0.075}, {0.66, 0.88}, {0.925, 0.94}},
              make_material("green cloth", 0.035f, 0.19f, 0.09f, 0.7f),
              make_material("cream print", 0.80f, 0.73f, 0.55f, 0.6f));
}

Model make_book_yellow() {
  return book("book_yellow", {0.020, 0.135, 0.205}, {{0.10, 0.16}, {0.40, 0.86}},
              make_material("yellow cover", 0.80f, 0.47f, 0.04f, 0.5f),
              make_material("black print", 0.03f, 0.03f, 0.035f, 0.5f));
}

Model make_binder() {
  constexpr Index kSteel = 3;
  const BookSize size{0.075, 0.285, 0.318};
  std::vector<Part> parts = book_parts(size, 0.0026, 0.0004, {{0.42, 0.86}});
  // The hole for the finger, with its steel rim.
  const auto hole = flatten(
      {corner({0, 0}, kSteel), corner({0.0160, 0}, kSteel), corner({0.0150, 0.0034}, kSteel),
       corner({0.0115, 0.0034}, kSteel), corner({0.0110, 0.0016}), corner({0, 0.0016})},
      0.0004);
  const Surface round = turned(skin(revolve(hole, {24, 24, 0})), Vec3::UnitX(), 90);
  parts.push_back({moved(round, {0, 0.0008, 0.22 * size.z}), 40});
  return assemble("binder", parts,
                  {make_material("binder", 0.05f, 0.05f, 0.06f, 0.6f), white_paper(),
                   make_material("label", 0.86f, 0.85f, 0.80f, 0.7f), silver()});
}

namespace {

// A sheet of A4, or a few; one corner bends up. Lines of text are stripes between the columns.
Model sheet(const std::string& name, double thickness, const std::vector<double>& line_ends,
            const std::vector<Material>& materials) {
  constexpr Index kInk = 1;
  const Vec2 half(0.105, 0.1485);
  std::vector<double> columns{-half.x(), -0.080};
  for (double x = -0.060; x < 0.085; x += 0.020) columns.push_back(x);
  columns.push_back(half.x());
  const double pitch = 0.0105, ink = 0.0035;
  std::vector<double> stations{-half.y()};
  for (double y = -0.125; y < 0.128; y += pitch) {
    stations.push_back(y);
    stations.push_back(y + ink);
  }
  stations.push_back(half.y());
  const auto bend = [&](double x, double y) {
    const double far = std::max(0.0, x - y - 0.185);
    return 5.0 * far * far;
  };
  std::vector<Ring> rings;
  for (const double y : stations) {
    Ring ring;
    for (const double x : columns) ring.points.emplace_back(x, y, bend(x, y));
    for (auto x = columns.rbegin(); x != columns.rend(); ++x)
      ring.points.emplace_back(*x, y, bend(*x, y) + thickness);
    rings.push_back(std::move(ring));
  }
  const auto is_ink = [&](const Vec3& p) {
    const double from_top = half.y() - 0.0235 - p.y();
    const auto line = static_cast<size_t>(std::max(0.0, std::floor((p.y() + 0.125) / pitch)));
    const double within = p.y() + 0.125 - pitch * static_cast<double>(line);
    return from_top > 0 && p.y() > -0.125 && p.z() > 0.5 * thickness && within < ink &&
           line < line_ends.size() && p.x() > -0.080 && p.x() < line_ends[line];
  };
  return assemble(name, {{painted(skin(rings), kInk, is_ink), 40}}, materials);
}

}  // namespace

Model make_letter() {
  return sheet("letter", 0.0006,
               {-1,   -1,   -0.02, -0.04, -1, 0.06, 0.08, 0.08, 0.08, -0.02, -1,    0.08,
                0.08, 0.06, 0.08,  0.02,  -1, 0.08, 0.08, -1,   -1,   -0.04, -0.02, -1},
               {white_paper(), make_material("ink", 0.12f, 0.12f, 0.14f, 0.8f)});
}

Model make_report() {
  return sheet("report", 0.0045,
               {0.08, 0.08, 0.04, -1,   0.08, 0.08, 0.08,  0.08, 0.06, -1,   0.08, 0.08,
                0.08, 0.00, -1,   0.08, 0.08, 0.08, -0.04, -1,   -1,   0.04, 0.06, -1},
               {make_material("report paper", 0.80f, 0.77f, 0.68f, 0.8f),
                make_material("report ink", 0.10f, 0.12f, 0.30f, 0.8f)});
}

namespace {

// A number in [0, 1) that is the same everywhere; [Steele, Lea and Flood 2014].
double scattered(std::uint64_t seed) {
  std::uint64_t z = (seed + 1) * 0x9e3779b97f4a7c15ull;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ull;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebull;
  return static_cast<double>((z ^ (z >> 31)) >> 11) * 0x1p-53;
}

}  // namespace

Model make_paper_ball() {
  constexpr int kRings = 9, kAround = 13;
  std::uint64_t count = 0;
  const auto radius = [&] { return 0.028 + 0.010 * scattered(count++); };
  std::vector<Ring> rings{{{Vec3(0, 0, -radius())}, 0}};
  for (int i = 1; i < kRings; ++i) {
    const double polar = std::numbers::pi * i / kRings;
    Ring ring;
    for (int k = 0; k < kAround; ++k) {
      const double angle = 2 * std::numbers::pi * (k + 0.5 * (i % 2)) / kAround;
      const Vec3 direction(std::sin(polar) * std::cos(angle), std::sin(polar) * std::sin(angle),
                           -std::cos(polar));
      ring.points.push_back(radius() * direction);
    }
    rings.push_back(std::move(ring));
  }
  rings.push_back({{Vec3(0, 0, radius())}, 0});
  return assemble("paper_ball", {{skin(rings), 12}}, {white_paper()});
}

}  // namespace trivet::shapes
