#include "apps/trivet/zlist_picture.h"

#include <algorithm>
#include <cmath>

#include "apps/trivet/canvas.h"

namespace trivet::apps {
namespace {

constexpr int kLeastPictureWidth = 160;
// Lengths beyond those of all but this fraction of the lists share the last colour.
constexpr double kLongTail = 0.01;

// Equal lightness and chroma, with hues of neighbouring numbers far apart [Ottosson 2020].
Rgb of_object(std::uint32_t number) {
  const double hue = 2.399963 * number + 0.5;  // the golden angle
  const double lightness = number % 2 == 0 ? 0.72 : 0.6, a = 0.12 * std::cos(hue),
               b = 0.12 * std::sin(hue);
  const double l = std::pow(lightness + 0.3963377774 * a + 0.2158037573 * b, 3);
  const double m = std::pow(lightness - 0.1055613458 * a - 0.0638541728 * b, 3);
  const double s = std::pow(lightness - 0.0894841775 * a - 1.2914855480 * b, 3);
  const double linear[] = {4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s,
                           -1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s,
                           -0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s};
  Rgb out;
  for (int k = 0; k < 3; ++k) {
    const double x = std::clamp(linear[k], 0.0, 1.0);
    const double srgb = x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1 / 2.4) - 0.055;
    out[k] = static_cast<std::uint8_t>(std::lround(255 * srgb));
  }
  return out;
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

// Draws as many numbers as fit; print_names() gives the names.
void draw_numbers(size_t count, int y, int width, Canvas& canvas) {
  int x = Canvas::kMargin;
  for (size_t i = 0; i < count; ++i) {
    const std::string label = std::to_string(i);
    const int end = x + std::max(Canvas::width_of(label), 2 * Canvas::kBarHeight);
    if (end > width - Canvas::kMargin) return;
    canvas.fill(x, y, end - x, Canvas::kBarHeight, of_object(static_cast<std::uint32_t>(i)));
    canvas.write(x, y + Canvas::kBarHeight + Canvas::kMargin, label);
    x = end + Canvas::kMargin;
  }
}

}  // namespace

Image zlists_picture(const ZListsOf& what, ZListShow show) {
  const Projection& view = what.lists->projection();
  const int width = std::max(view.width, kLeastPictureWidth);
  Canvas canvas(width, view.height + Canvas::kScaleHeight + 2 * Canvas::kMargin);
  const int below = view.height + Canvas::kMargin;
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
      if (!std::isnan(value)) canvas.set(x, y, scale_colour((value - shown.low) / range));
    }
  canvas.draw_scale(Canvas::kMargin, below, width - 2 * Canvas::kMargin, shown.low, shown.high,
                    shown.unit, shown.open);
  return canvas.take();
}

}  // namespace trivet::apps
