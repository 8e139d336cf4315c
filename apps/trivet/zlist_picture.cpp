#include "apps/trivet/zlist_picture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace trivet::apps {
namespace {

using Colour = std::array<std::uint8_t, 3>;

constexpr Colour kWhite{255, 255, 255}, kBlack{0, 0, 0};
constexpr int kBarHeight = 12, kMargin = 6, kLeastWidth = 160;
// Lengths beyond those of all but this fraction of the lists share the last colour.
constexpr double kLongTail = 0.01;

// Samples of viridis [van der Walt 2015]: perceptually uniform, also in grey and for the
// colour-blind.
constexpr Colour kScale[] = {
    {68, 1, 84},    {72, 24, 106},  {71, 45, 123},  {66, 64, 134},  {59, 82, 139},  {51, 99, 141},
    {44, 114, 142}, {38, 130, 142}, {33, 145, 140}, {31, 160, 136}, {40, 174, 128}, {63, 188, 115},
    {94, 201, 98},  {132, 212, 75}, {173, 220, 48}, {216, 226, 25}, {253, 231, 37}};

Colour on_scale(double part) {
  constexpr int kLast = static_cast<int>(std::size(kScale)) - 1;
  const double x = std::clamp(part, 0.0, 1.0) * kLast;
  const int i = std::min(static_cast<int>(x), kLast - 1);
  Colour out;
  for (int k = 0; k < 3; ++k)
    out[k] = static_cast<std::uint8_t>(
        std::lround(kScale[i][k] + (x - i) * (kScale[i + 1][k] - kScale[i][k])));
  return out;
}

// Equal lightness and chroma, with hues of neighbouring numbers far apart [Ottosson 2020].
Colour of_object(std::uint32_t number) {
  const double hue = 2.399963 * number + 0.5;  // the golden angle
  const double lightness = number % 2 == 0 ? 0.72 : 0.6, a = 0.12 * std::cos(hue),
               b = 0.12 * std::sin(hue);
  const double l = std::pow(lightness + 0.3963377774 * a + 0.2158037573 * b, 3);
  const double m = std::pow(lightness - 0.1055613458 * a - 0.0638541728 * b, 3);
  const double s = std::pow(lightness - 0.0894841775 * a - 1.2914855480 * b, 3);
  const double linear[] = {4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s,
                           -1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s,
                           -0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s};
  Colour out;
  for (int k = 0; k < 3; ++k) {
    const double x = std::clamp(linear[k], 0.0, 1.0);
    const double srgb = x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1 / 2.4) - 0.055;
    out[k] = static_cast<std::uint8_t>(std::lround(255 * srgb));
  }
  return out;
}

// Letters of 5 x 7 dots, the rows from above; bit 4 is on the left.
struct Glyph {
  char letter;
  std::array<std::uint8_t, 7> rows;
};
constexpr int kGlyphWidth = 6, kGlyphHeight = 7, kDots = 2;  // pixels per dot: kDots x kDots
constexpr Glyph kGlyphs[] = {
    {'0', {14, 17, 19, 21, 25, 17, 14}}, {'1', {4, 12, 4, 4, 4, 4, 14}},
    {'2', {14, 17, 1, 2, 4, 8, 31}},     {'3', {31, 2, 4, 2, 1, 17, 14}},
    {'4', {2, 6, 10, 18, 31, 2, 2}},     {'5', {31, 16, 30, 1, 1, 17, 14}},
    {'6', {6, 8, 16, 30, 17, 17, 14}},   {'7', {31, 1, 2, 4, 8, 8, 8}},
    {'8', {14, 17, 17, 14, 17, 17, 14}}, {'9', {14, 17, 17, 15, 1, 2, 12}},
    {'.', {0, 0, 0, 0, 0, 12, 12}},      {'-', {0, 0, 0, 31, 0, 0, 0}},
    {'+', {0, 4, 4, 31, 4, 4, 0}},       {'e', {0, 0, 14, 17, 31, 16, 14}},
    {'m', {0, 0, 26, 21, 21, 21, 21}},
};

class Canvas {
 public:
  Canvas(int width, int height) {
    m_image.width = width;
    m_image.height = height;
    m_image.rgba.assign(size_t(4) * width * height, 255);
  }
  Image take() { return std::move(m_image); }

  void set(int x, int y, const Colour& colour) {
    if (x < 0 || y < 0 || x >= m_image.width || y >= m_image.height) return;
    std::copy(colour.begin(), colour.end(), &m_image.rgba[4 * (size_t(y) * m_image.width + x)]);
  }
  void fill(int x0, int y0, int width, int height, const Colour& colour) {
    for (int y = y0; y < y0 + height; ++y)
      for (int x = x0; x < x0 + width; ++x) set(x, y, colour);
  }
  void write(int x, int y, const std::string& text) {
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
  static int width_of(const std::string& text) {
    return kDots * (kGlyphWidth * static_cast<int>(text.size()) - 1);
  }

 private:
  Image m_image;
};

std::string number(double x) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g", x);
  return text;
}

// Values shown by colours from the scale.
struct Shown {
  std::vector<double> values;  // by list, rows from above; NaN: no list
  double low = 0, high = 0;
  bool open = false;  // some values are beyond `high`
  const char* unit = "";
};

double value_of(std::span<const ZListItem> list, ZListShow show, const Projection& view) {
  if (list.empty()) return std::nan("");
  return show == ZListShow::Length ? static_cast<double>(list.size())
                                   : view.depth(list.front().lower);
}

Shown values_of(const ZListsOf& what, ZListShow show) {
  const Projection& view = what.lists->projection();
  Shown out;
  std::vector<double> known;
  for (int row = 0; row < view.height; ++row)
    for (int column = 0; column < view.width; ++column) {
      out.values.push_back(value_of(what.at(column, row), show, view));
      if (!std::isnan(out.values.back())) known.push_back(out.values.back());
    }
  if (known.empty()) return out;
  std::sort(known.begin(), known.end());
  out.low = known.front();
  out.high = known.back();
  if (show == ZListShow::Depth) {
    out.unit = "m";
    return out;
  }
  out.low = 0;
  out.high = known[static_cast<size_t>((1 - kLongTail) * static_cast<double>(known.size() - 1))];
  out.open = out.high < known.back();
  return out;
}

void draw_scale(const Shown& shown, int y, int width, Canvas& canvas) {
  const int length = width - 2 * kMargin;
  for (int i = 0; i < length; ++i)
    canvas.fill(kMargin + i, y, 1, kBarHeight, on_scale((i + 0.5) / length));
  const double middle = 0.5 * (shown.low + shown.high);
  const std::string unit = shown.unit;
  const std::string labels[] = {number(shown.low) + unit, number(middle) + unit,
                                number(shown.high) + (shown.open ? "+" : "") + unit};
  for (int i = 0; i < 3; ++i)
    canvas.write(kMargin + i * (length - Canvas::width_of(labels[i])) / 2, y + kBarHeight + kMargin,
                 labels[i]);
}

// Draws as many numbers as fit; print_names() gives the names.
void draw_numbers(size_t count, int y, int width, Canvas& canvas) {
  int x = kMargin;
  for (size_t i = 0; i < count; ++i) {
    const std::string label = std::to_string(i);
    const int end = x + std::max(Canvas::width_of(label), 2 * kBarHeight);
    if (end > width - kMargin) return;
    canvas.fill(x, y, end - x, kBarHeight, of_object(static_cast<std::uint32_t>(i)));
    canvas.write(x, y + kBarHeight + kMargin, label);
    x = end + kMargin;
  }
}

}  // namespace

Image zlists_picture(const ZListsOf& what, ZListShow show) {
  const Projection& view = what.lists->projection();
  const int width = std::max(view.width, kLeastWidth);
  Canvas canvas(width, view.height + kBarHeight + 3 * kMargin + kDots * kGlyphHeight);
  const int below = view.height + kMargin;
  if (show == ZListShow::Objects) {
    for (int y = 0; y < view.height; ++y)
      for (int x = 0; x < view.width; ++x)
        if (const auto list = what.at(x, y); !list.empty())
          canvas.set(x, y, of_object(list.front().body));
    draw_numbers(what.names.size(), below, width, canvas);
    return canvas.take();
  }
  const Shown shown = values_of(what, show);
  const double range = std::max(shown.high - shown.low, 1e-300);
  for (int y = 0; y < view.height; ++y)
    for (int x = 0; x < view.width; ++x) {
      const double value = shown.values[size_t(y) * view.width + x];
      if (!std::isnan(value)) canvas.set(x, y, on_scale((value - shown.low) / range));
    }
  draw_scale(shown, below, width, canvas);
  return canvas.take();
}

}  // namespace trivet::apps
