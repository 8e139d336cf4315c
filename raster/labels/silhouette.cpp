#include "raster/labels/silhouette.h"

#include <algorithm>
#include <bit>

#include "core/base/parallel.h"

namespace trivet {
namespace {

// Bits [from, to] of a word.
std::uint64_t bits(int from, int to) { return (~std::uint64_t{0} >> (63 - (to - from))) << from; }

// Calls f(word, bits) for the words of the pixels [x0, x1], counted from the range's first.
template <class F>
void for_each_word(int x0, int x1, F f) {
  // The first and last word are covered in part, all between them wholly.
  for (int word = x0 / 64; word <= x1 / 64; ++word)
    f(word, bits(std::max(x0 - 64 * word, 0), std::min(x1 - 64 * word, 63)));
}

PixelRange pixels_within(const LabelBox& box, const PixelRange& window) {
  if (box.empty()) return {};
  // A pixel more on each side: the box is rounded.
  const auto from = [](double v, int lower) {
    return v <= lower ? lower : static_cast<int>(v) - 1;
  };
  const auto to = [](double v, int upper) { return v >= upper ? upper : static_cast<int>(v) + 1; };
  return {std::max(window.x0, from(box.x0, window.x0)),
          std::max(window.y0, from(box.y0, window.y0)), std::min(window.x1, to(box.x1, window.x1)),
          std::min(window.y1, to(box.y1, window.y1))};
}

}  // namespace

SeenObject see_object(const PictureObject& object, const PinholeCamera& camera) {
  SeenObject out{object.mesh, {}};
  out.vertices.reserve(object.mesh->vertices.size());
  // About the eye, so that what is far from the origin loses nothing.
  Affine eye_from_object = object.world_from_object;
  eye_from_object.translation -= camera.eye;
  for (const Vec3& p : object.mesh->vertices)
    out.vertices.push_back(camera.rotate(eye_from_object.apply(p)));
  return out;
}

std::vector<SeenObject> seen_objects(const PictureScene& scene, const PinholeCamera& camera) {
  std::vector<SeenObject> out(scene.objects.size());
  in_parallel(out.size(), [&](std::size_t i) { out[i] = see_object(scene.objects[i], camera); });
  return out;
}

PixelRange label_canvas(const PinholeCamera& camera) {
  return {-camera.width, -camera.height, 2 * camera.width - 1, 2 * camera.height - 1};
}

LabelBox whole_box(const SeenObject& object, const PinholeCamera& camera) {
  ImageBox box;
  for (std::size_t f = 0; f < object.mesh->triangles.size(); ++f)
    box.extend(image_box(object.triangle(f), camera));
  if (box.empty()) return {};
  const PixelRange canvas = label_canvas(camera);
  const auto within = [](double v, double lower, double upper) {
    return std::clamp(v, lower - 0.5, upper + 0.5);  // up to the pixels' edges
  };
  return {within(box.x0, canvas.x0, canvas.x1), within(box.y0, canvas.y0, canvas.y1),
          within(box.x1, canvas.x0, canvas.x1), within(box.y1, canvas.y0, canvas.y1)};
}

Silhouette::Silhouette(const PixelRange& range) : m_range(range) {
  if (range.empty()) return;
  m_words = std::size_t(range.x1 - range.x0) / 64 + 1;
  m_bits.resize(m_words * (range.y1 - range.y0 + 1));
}

void Silhouette::add(int y, int x0, int x1) {
  std::uint64_t* const words = row(y);
  for_each_word(x0 - m_range.x0, x1 - m_range.x0,
                [&](int word, std::uint64_t mask) { words[word] |= mask; });
}

bool Silhouette::covers(int x, int y) const {
  if (x < m_range.x0 || x > m_range.x1 || y < m_range.y0 || y > m_range.y1) return false;
  const int i = x - m_range.x0;
  return row(y)[i / 64] >> (i % 64) & 1;
}

std::int64_t Silhouette::count(const PixelRange& within) const {
  const int x0 = std::max(within.x0, m_range.x0), x1 = std::min(within.x1, m_range.x1);
  std::int64_t sum = 0;
  if (x0 > x1) return 0;
  for (int y = std::max(within.y0, m_range.y0); y <= std::min(within.y1, m_range.y1); ++y)
    for_each_word(x0 - m_range.x0, x1 - m_range.x0,
                  [&](int word, std::uint64_t mask) { sum += std::popcount(row(y)[word] & mask); });
  return sum;
}

LabelBox Silhouette::box() const {
  LabelBox out;
  if (m_range.empty()) return out;
  const auto extend = [&](int y, int first, int last) {
    if (out.empty()) out = {double(first), double(y), double(last), double(y)};
    out.x0 = std::min<double>(out.x0, first), out.x1 = std::max<double>(out.x1, last), out.y1 = y;
  };
  // The first and last set bits of a row are found word by word.
  for (int y = m_range.y0; y <= m_range.y1; ++y) {
    const std::uint64_t* const words = row(y);
    std::size_t first = 0, last = m_words;
    while (first < m_words && words[first] == 0) ++first;
    if (first == m_words) continue;
    while (words[last - 1] == 0) --last;
    extend(y, m_range.x0 + int(64 * first) + std::countr_zero(words[first]),
           m_range.x0 + int(64 * last) - 1 - std::countl_zero(words[last - 1]));
  }
  return out;
}

Silhouette draw_silhouette(const SeenObject& object, const PinholeCamera& camera,
                           const PixelRange& window) {
  const PixelRange range = pixels_within(whole_box(object, camera), window);
  Silhouette out(range);
  if (range.empty()) return out;
  for (std::size_t f = 0; f < object.mesh->triangles.size(); ++f) {
    const auto face = view_face(object.triangle(f), camera, range);
    if (!face) continue;
    for (int y = face->box.y0; y <= face->box.y1; ++y)
      if (const auto [x0, x1] = covered_span(*face, y); x0 <= x1) out.add(y, x0, x1);
  }
  return out;
}

}  // namespace trivet
