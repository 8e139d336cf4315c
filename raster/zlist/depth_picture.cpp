#include "raster/zlist/depth_picture.h"

#include <algorithm>
#include <cmath>

namespace trivet {
namespace {

// Samples of viridis.
constexpr Rgb kScale[] = {
    {68, 1, 84},    {72, 24, 106},  {71, 45, 123},  {66, 64, 134},  {59, 82, 139},  {51, 99, 141},
    {44, 114, 142}, {38, 130, 142}, {33, 145, 140}, {31, 160, 136}, {40, 174, 128}, {63, 188, 115},
    {94, 201, 98},  {132, 212, 75}, {173, 220, 48}, {216, 226, 25}, {253, 231, 37}};

constexpr int kLargeSquare = 6;  // an outline within it is seen

// -1, 0 or 1: before, in or past a square.
int beside(int i, int magnify) { return i < 0 ? -1 : i >= magnify; }

}  // namespace

Rgb scale_colour(double part) {
  constexpr int kLast = static_cast<int>(std::size(kScale)) - 1;
  const double x = std::clamp(part, 0.0, 1.0) * kLast;
  const int i = std::min(static_cast<int>(x), kLast - 1);
  Rgb out;
  for (int k = 0; k < 3; ++k)
    out[k] = static_cast<std::uint8_t>(
        std::lround(kScale[i][k] + (x - i) * (kScale[i + 1][k] - kScale[i][k])));
  return out;
}

DepthPicture::DepthPicture(const MotionDepths& depths) : m_depths(depths) {
  const ZListFrame& frame = depths.frame;
  m_width = frame.width, m_height = frame.height;
  const Vec3 u = frame.image_from_world.row(0), v = frame.image_from_world.row(1);
  if (depths.turns()) {
    m_right = u, m_up = frame.image_from_world.row(2);
    return;
  }
  // The rows are right-handed with the motion behind the image: the four views along the motion are
  // transposed, or have one side flipped.
  struct Turned {
    Vec3 right, up;
    bool transposed, flip_column, flip_row;
  };
  const Turned turned[] = {{v, u, true, false, false},
                           {-u, v, false, true, false},
                           {u, -v, false, false, true},
                           {-v, -u, true, true, true}};
  // The view that shows z, then y, upwards is the one that people know.
  const auto upright = [](const Turned& t) { return t.up.z() + 1e-3 * t.up.y(); };
  const Turned* const best =
      std::max_element(std::begin(turned), std::end(turned),
                       [&](const Turned& a, const Turned& b) { return upright(a) < upright(b); });
  m_right = best->right, m_up = best->up;
  m_transposed = best->transposed, m_flip_column = best->flip_column, m_flip_row = best->flip_row;
  if (m_transposed) std::swap(m_width, m_height);
}

size_t DepthPicture::pixel(int x, int y) const {
  // Pictures count rows from above, z-lists from below.
  const ZListFrame& frame = m_depths.frame;
  const int from_below = m_height - 1 - y;
  int column = m_transposed ? from_below : x, row = m_transposed ? x : from_below;
  if (m_flip_column) column = frame.width - 1 - column;
  if (m_flip_row) row = frame.height - 1 - row;
  return static_cast<size_t>(row) * frame.width + column;
}

std::optional<std::array<int, 2>> DepthPicture::seen_at(const Vec3& world) const {
  const auto found = m_depths.pixel_of(world);
  if (!found) return std::nullopt;
  const ZListFrame& frame = m_depths.frame;
  int column = static_cast<int>(*found % frame.width), row = static_cast<int>(*found / frame.width);
  if (m_flip_column) column = frame.width - 1 - column;
  if (m_flip_row) row = frame.height - 1 - row;
  const int x = m_transposed ? row : column, from_below = m_transposed ? column : row;
  return {{x, m_height - 1 - from_below}};
}

std::optional<double> DepthPicture::value(DepthShow show, int x, int y) const {
  const size_t i = pixel(x, y);
  switch (show) {
    case DepthShow::Moving:
      return m_depths.has_moving(i) ? std::optional(m_depths.shown(m_depths.moving_front[i]))
                                    : std::nullopt;
    case DepthShow::Fixed:
      return m_depths.has_fixed(i) ? std::optional(m_depths.shown(m_depths.fixed_front[i]))
                                   : std::nullopt;
    case DepthShow::Gap:
      break;
  }
  return m_depths.has_both(i) ? std::optional(m_depths.shown(m_depths.gap(i))) : std::nullopt;
}

std::optional<std::array<double, 2>> DepthPicture::range(DepthShow show) const {
  std::optional<std::array<double, 2>> out;
  // The scale spans what is shown; gaps begin at zero.
  for (int y = 0; y < m_height; ++y)
    for (int x = 0; x < m_width; ++x)
      if (const auto depth = value(show, x, y))
        out = out ? std::array{std::min((*out)[0], *depth), std::max((*out)[1], *depth)}
                  : std::array{*depth, *depth};
  if (out && show == DepthShow::Gap) (*out)[0] = 0;
  return out;
}

bool DepthPicture::is_doubtful(int x, int y) const {
  return x >= 0 && y >= 0 && x < m_width && y < m_height && m_depths.doubtful[pixel(x, y)] != 0;
}

void DepthPicture::paint_square(int x, int y, int magnify, const Rgb& colour,
                                std::vector<std::uint8_t>& out) const {
  for (int j = 0; j < magnify; ++j) {
    const size_t row = static_cast<size_t>(y) * magnify + j;
    for (int i = 0; i < magnify; ++i) {
      std::uint8_t* const at = &out[4 * ((row * m_width + x) * magnify + i)];
      std::copy(colour.begin(), colour.end(), at);
      at[3] = 255;
    }
  }
}

// The sides of a doubtful pixel towards others that are not; where pixels are small, also around
// it.
void DepthPicture::outline(int x, int y, int magnify, std::vector<std::uint8_t>& out) const {
  // The outline is a third of a pixel wide, and drawn outside of small ones.
  const int inside = std::max(1, magnify / 3), outside = magnify < kLargeSquare ? 1 : 0;
  const bool left = !is_doubtful(x - 1, y), right = !is_doubtful(x + 1, y);
  const bool above = !is_doubtful(x, y - 1), below = !is_doubtful(x, y + 1);
  for (int j = -outside; j < magnify + outside; ++j)
    for (int i = -outside; i < magnify + outside; ++i) {
      const bool on = (left && i < inside) || (right && i >= magnify - inside) ||
                      (above && j < inside) || (below && j >= magnify - inside);
      const int at_x = x + beside(i, magnify), at_y = y + beside(j, magnify);
      const bool in_another = (at_x != x || at_y != y) && is_doubtful(at_x, at_y);
      const bool in_picture = at_x >= 0 && at_y >= 0 && at_x < m_width && at_y < m_height;
      if (!on || in_another || !in_picture) continue;
      const size_t row = static_cast<size_t>(y * magnify + j);
      std::uint8_t* const to = &out[4 * (row * m_width * magnify + x * magnify + i)];
      std::copy(kDoubtfulColour.begin(), kDoubtfulColour.end(), to);
      to[3] = 255;
    }
}

std::vector<std::uint8_t> DepthPicture::paint(DepthShow show, int magnify) const {
  std::vector<std::uint8_t> out(4 * static_cast<size_t>(m_width) * m_height * magnify * magnify);
  const auto shown = range(show);
  if (!shown) return out;
  const double span = std::max((*shown)[1] - (*shown)[0], 1e-300);
  for (int y = 0; y < m_height; ++y)
    for (int x = 0; x < m_width; ++x) {
      const auto depth = value(show, x, y);
      if (!depth) continue;
      paint_square(x, y, magnify, scale_colour((*depth - (*shown)[0]) / span), out);
    }
  // Outlines are drawn over all squares.
  for (int y = 0; y < m_height; ++y)
    for (int x = 0; x < m_width; ++x)
      if (is_doubtful(x, y)) outline(x, y, magnify, out);
  return out;
}

}  // namespace trivet
