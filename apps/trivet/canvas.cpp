#include "apps/trivet/canvas.h"

#include <algorithm>
#include <cstdio>

namespace trivet::apps {
namespace {

// Letters of 5 x 7 dots, the rows from above; bit 4 is on the left.
struct Glyph {
  char letter;
  std::array<std::uint8_t, 7> rows;
};
constexpr int kGlyphWidth = 6, kGlyphHeight = 7, kDots = 2;  // pixels per dot: kDots x kDots
static_assert(kDots * kGlyphHeight == Canvas::kTextHeight);
constexpr Glyph kGlyphs[] = {
    {'0', {14, 17, 19, 21, 25, 17, 14}}, {'1', {4, 12, 4, 4, 4, 4, 14}},
    {'2', {14, 17, 1, 2, 4, 8, 31}},     {'3', {31, 2, 4, 2, 1, 17, 14}},
    {'4', {2, 6, 10, 18, 31, 2, 2}},     {'5', {31, 16, 30, 1, 1, 17, 14}},
    {'6', {6, 8, 16, 30, 17, 17, 14}},   {'7', {31, 1, 2, 4, 8, 8, 8}},
    {'8', {14, 17, 17, 14, 17, 17, 14}}, {'9', {14, 17, 17, 15, 1, 2, 12}},
    {'.', {0, 0, 0, 0, 0, 12, 12}},      {'-', {0, 0, 0, 31, 0, 0, 0}},
    {'+', {0, 4, 4, 31, 4, 4, 0}},       {'a', {0, 0, 14, 1, 15, 17, 15}},
    {'d', {1, 1, 13, 19, 17, 17, 15}},   {'e', {0, 0, 14, 17, 31, 16, 14}},
    {'f', {6, 9, 8, 28, 8, 8, 8}},       {'g', {0, 0, 15, 17, 15, 1, 14}},
    {'i', {4, 0, 12, 4, 4, 4, 14}},      {'m', {0, 0, 26, 21, 21, 21, 21}},
    {'n', {0, 0, 22, 25, 17, 17, 17}},   {'o', {0, 0, 14, 17, 17, 17, 14}},
    {'p', {0, 0, 30, 17, 30, 16, 16}},   {'r', {0, 0, 22, 25, 16, 16, 16}},
    {'t', {8, 8, 28, 8, 8, 9, 6}},       {'v', {0, 0, 17, 17, 17, 10, 4}},
    {'x', {0, 0, 17, 10, 4, 10, 17}},
};

std::string number(double x) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g", x);
  return text;
}

}  // namespace

Canvas::Canvas(int width, int height) {
  m_image.width = width;
  m_image.height = height;
  m_image.rgba.assign(size_t(4) * width * height, 255);
}

void Canvas::set(int x, int y, const Rgb& colour) {
  if (x < 0 || y < 0 || x >= m_image.width || y >= m_image.height) return;
  std::copy(colour.begin(), colour.end(), &m_image.rgba[4 * (size_t(y) * m_image.width + x)]);
}

void Canvas::fill(int x0, int y0, int width, int height, const Rgb& colour) {
  for (int y = y0; y < y0 + height; ++y)
    for (int x = x0; x < x0 + width; ++x) set(x, y, colour);
}

void Canvas::write(int x, int y, const std::string& text) {
  for (const char letter : text) {
    const auto glyph = std::find_if(std::begin(kGlyphs), std::end(kGlyphs),
                                    [&](const Glyph& g) { return g.letter == letter; });
    if (glyph != std::end(kGlyphs))
      for (int j = 0; j < kGlyphHeight; ++j)
        for (int i = 0; i < kGlyphWidth - 1; ++i)
          if (glyph->rows[j] >> (kGlyphWidth - 2 - i) & 1)
            fill(x + kDots * i, y + kDots * j, kDots, kDots, kBlack);
    x += kDots * kGlyphWidth;
  }
}

int Canvas::width_of(const std::string& text) {
  return kDots * (kGlyphWidth * static_cast<int>(text.size()) - 1);
}

void Canvas::draw_scale(int x, int y, int width, double low, double high, const std::string& unit,
                        bool open) {
  for (int i = 0; i < width; ++i) fill(x + i, y, 1, kBarHeight, scale_colour((i + 0.5) / width));
  const std::string labels[] = {number(low) + unit, number(0.5 * (low + high)) + unit,
                                number(high) + (open ? "+" : "") + unit};
  for (int i = 0; i < 3; ++i)
    write(x + i * (width - width_of(labels[i])) / 2, y + kBarHeight + kMargin, labels[i]);
}

}  // namespace trivet::apps
