#include "gpu/zlist/pairs.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <tuple>

namespace trivet {
namespace {

/// Candidate pair limit; beyond, BVHs are faster. Pairs are counted before any is written: the
/// lists of a large flat contact have hundreds of millions.
constexpr std::size_t kMaxPairs = 1 << 21;

struct Pair {
  std::uint32_t moving, fixed;
  double gap;

  bool operator<(const Pair& other) const {
    return std::tie(moving, fixed, gap) < std::tie(other.moving, other.fixed, other.gap);
  }
};

void merge(std::vector<Pair>& pairs) {
  // Pairs are met in many pixels; sorted, the least gap of each comes first, and stays.
  std::sort(pairs.begin(), pairs.end());
  const auto same = [](const Pair& a, const Pair& b) {
    return a.moving == b.moving && a.fixed == b.fixed;
  };
  pairs.erase(std::unique(pairs.begin(), pairs.end(), same), pairs.end());
}

using Entries = std::span<const ZListEntry>;

// Travel of a moving interval until it meets a fixed one; negative if they overlap, infinity if the
// fixed one is behind.
double gap_between(const ZListEntry& a, const ZListEntry& b, double period) {
  const double rear = a.low, front = a.high;
  // A turn's fixed interval comes again every period: the first one that is not behind counts.
  if (period == 0) return b.high < rear ? kInfinity : b.low - front;
  return b.low + period * std::ceil((rear - b.high) / period - 1e-6) - front;
}

/// Number of pairs that add_pairs() visits.
std::size_t num_pairs(Entries moving, Entries fixed, const ZListView& view, double upper) {
  // Turns have no order of depths to halve: all pairs count.
  if (view.period != 0) return moving.size() * fixed.size();
  std::size_t out = 0;
  for (const ZListEntry& a : moving)
    out += static_cast<std::size_t>(
        std::partition_point(fixed.begin(), fixed.end(),
                             [&](const ZListEntry& b) { return double(b.low) - a.high <= upper; }) -
        fixed.begin());
  return out;
}

/// Processes one pixel: moving entries, and fixed ones by their nearest depth.
void add_pairs(Entries moving, Entries fixed, const ZListView& view, double upper,
               std::vector<Pair>& pairs) {
  for (const ZListEntry& a : moving)
    for (const ZListEntry& b : fixed) {
      // Fixed entries come by their nearest depth: after the first that is too far, all are.
      if (view.period == 0 && double(b.low) - a.high > upper) break;
      const double gap = gap_between(a, b, view.period);
      if (gap <= upper) pairs.push_back({a.face, b.face, std::max(0.0, gap)});
    }
}

struct Pixel {
  Entries moving, fixed;
};

std::vector<Pixel> pixels_of(Entries all, std::uint32_t first_fixed) {
  std::vector<Pixel> out;
  // Entries of a pixel follow each other, moving faces first.
  for (std::size_t first = 0, fixed = 0, end = 0; first < all.size(); first = end) {
    const auto in_pixel = [&](std::size_t i) {
      return i < all.size() && all[i].pixel == all[first].pixel;
    };
    for (fixed = first; in_pixel(fixed) && all[fixed].face < first_fixed;) ++fixed;
    for (end = fixed; in_pixel(end);) ++end;
    if (first < fixed && fixed < end)
      out.push_back({all.subspan(first, fixed - first), all.subspan(fixed, end - fixed)});
  }
  return out;
}

/// Maps a face of the view to its body, and to its number there.
class FaceNames {
 public:
  explicit FaceNames(const std::vector<ZListBody>& bodies) : m_bodies(bodies) {}
  std::pair<Index, Index> operator()(std::uint32_t face) const {
    // Faces of all bodies are numbered in one row; the body's first face gives the number in it.
    const auto next = std::upper_bound(
        m_bodies.begin(), m_bodies.end(), face,
        [](std::uint32_t f, const ZListBody& body) { return f < body.first_face; });
    const ZListBody& body = *std::prev(next);
    return {body.body, static_cast<Index>(face - body.first_face)};
  }

 private:
  const std::vector<ZListBody>& m_bodies;
};

std::vector<FacePair> named(const ZListView& view, const std::vector<Pair>& pairs,
                            const ZListFrame& frame) {
  const FaceNames moving(view.moving), fixed(view.fixed);
  std::vector<FacePair> out;
  out.reserve(pairs.size());
  for (const Pair& p : pairs) {
    const auto [a, face_a] = moving(p.moving);
    const auto [b, face_b] = fixed(p.fixed);
    out.push_back({a, b, face_a, face_b, frame.time_before(p.gap)});
  }
  // Pairs that may meet first come first; names decide between equal times, so that the order is
  // always the same.
  std::sort(out.begin(), out.end(), [](const FacePair& x, const FacePair& y) {
    return std::tie(x.not_before, x.moving, x.fixed, x.face_moving, x.face_fixed) <
           std::tie(y.not_before, y.moving, y.fixed, y.face_moving, y.face_fixed);
  });
  return out;
}

}  // namespace

bool make_pairs(const ZListView& view, ZLists& lists, const ZListFrame& frame,
                std::vector<FacePair>& pairs) {
  const std::uint32_t first_fixed = view.fixed.front().first_face;
  const auto key = [first_fixed](const ZListEntry& e) {
    return std::tuple(e.pixel, e.face >= first_fixed, e.low, e.face);
  };
  // One sort brings pixels, sides and depths in order.
  std::sort(lists.entries.begin(), lists.entries.end(),
            [&](const ZListEntry& a, const ZListEntry& b) { return key(a) < key(b); });
  const std::vector<Pixel> pixels = pixels_of(lists.entries, first_fixed);
  // Pairs are counted before any is written.
  std::size_t count = 0;
  for (const Pixel& p : pixels) {
    count += num_pairs(p.moving, p.fixed, view, lists.upper);
    if (count > kMaxPairs) return false;
  }
  std::vector<Pair> found;
  for (const Pixel& p : pixels) add_pairs(p.moving, p.fixed, view, lists.upper, found);
  merge(found);
  pairs = named(view, found, frame);
  return true;
}

}  // namespace trivet
