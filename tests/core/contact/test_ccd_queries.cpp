// Published continuous-collision queries with ground truth [Wang 2021, Sample-Queries]:
// queries in which each side moves by a single vector are translations of one side against the
// other.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <optional>
#include <sstream>

#include "core/contact/pair_contact.h"
#include "support/shared_data.h"

namespace trivet {
namespace {

struct CcdQuery {
  bool edges;             // edge-edge, else vertex-face
  std::array<Vec3, 8> p;  // four points at t = 0, the same at t = 1
  bool truth;
};

// xnum,xden,ynum,yden,znum,zden,truth; every quotient is exactly a double.
bool read_row(std::istream& in, Vec3& point, bool& truth) {
  std::string line;
  if (!std::getline(in, line)) return false;
  std::istringstream cells(line);
  std::string cell;
  double value[7] = {};
  for (double& v : value) {
    if (!std::getline(cells, cell, ',')) return false;
    v = std::stod(cell);
  }
  point = {value[0] / value[1], value[2] / value[3], value[4] / value[5]};
  truth = value[6] != 0;
  return true;
}

std::vector<CcdQuery> read_queries(const std::filesystem::path& path) {
  std::vector<CcdQuery> out;
  std::ifstream in(path);
  CcdQuery q{path.parent_path().filename() == "edge-edge", {}, false};
  for (;;) {
    for (Vec3& p : q.p)
      if (!read_row(in, p, q.truth)) return out;
    out.push_back(q);
  }
}

std::vector<CcdQuery> read_all(const std::string& folder) {
  std::vector<std::filesystem::path> paths;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
    if (entry.path().extension() == ".csv") paths.push_back(entry.path());
  std::sort(paths.begin(), paths.end());
  std::vector<CcdQuery> out;
  for (const auto& path : paths)
    for (const CcdQuery& q : read_queries(path)) out.push_back(q);
  return out;
}

/// The two sides as triangles without area, and the displacement of the first relative to the
/// second.
struct RelativeTranslation {
  Triangle moving, fixed;
  Vec3 by;
};

std::optional<RelativeTranslation> as_translation(const CcdQuery& q) {
  const auto& p = q.p;
  const Vec3 d[4] = {p[4] - p[0], p[5] - p[1], p[6] - p[2], p[7] - p[3]};
  if (q.edges) {
    if (d[0] != d[1] || d[2] != d[3]) return std::nullopt;
    return RelativeTranslation{{p[0], p[1], p[1]}, {p[2], p[3], p[3]}, d[0] - d[2]};
  }
  if (d[1] != d[2] || d[1] != d[3]) return std::nullopt;
  return RelativeTranslation{{p[0], p[0], p[0]}, {p[1], p[2], p[3]}, d[0] - d[1]};
}

// A false positive is an approach to within the clearance, which should be as small as rounding
// allows: positions at contact are rounded to 1e-16 of the largest coordinate, and the clearance is
// 1e4 times that.
double clearance_for(const RelativeTranslation& r) {
  double largest = r.by.cwiseAbs().maxCoeff();
  for (int k = 0; k < 3; ++k)
    largest =
        std::max({largest, r.moving[k].cwiseAbs().maxCoeff(), r.fixed[k].cwiseAbs().maxCoeff()});
  return 1e-12 * largest;
}

PairContact::Status collide(const RelativeTranslation& r) {
  const double length = r.by.norm();
  const Vec3 direction = length > 0 ? Vec3(r.by / length) : Vec3::UnitX();
  return first_contact(r.moving, r.fixed, Motion::translation(direction, length),
                       {clearance_for(r)})
      .status;
}

struct Score {
  int queries = 0, positive = 0, false_negative = 0, false_positive = 0, stalled = 0;
};

std::array<Score, 2> score_all() {
  std::array<Score, 2> score;  // vertex-face, edge-edge
  for (const CcdQuery& q : read_all(test::shared_data("ccd"))) {
    const auto translation = as_translation(q);
    if (!translation) continue;
    const PairContact::Status status = collide(*translation);
    const bool hit = status != PairContact::Status::Free;
    Score& s = score[q.edges];
    ++s.queries;
    s.positive += q.truth;
    s.false_negative += q.truth && !hit;
    s.false_positive += !q.truth && hit;
    s.stalled += status == PairContact::Status::Stalled;
  }
  for (const bool edges : {false, true})
    std::printf(
        "%s: %d translations, %d collide; %d false negatives, %d false positives, %d "
        "stalled\n",
        edges ? "edge-edge" : "vertex-face", score[edges].queries, score[edges].positive,
        score[edges].false_negative, score[edges].false_positive, score[edges].stalled);
  return score;
}

TEST(CcdQueries, HasNoFalseNegativeOnTranslations) {
  TRIVET_NEEDS_DATA("ccd");
  const auto [vertex_face, edge_edge] = score_all();
  EXPECT_EQ(vertex_face.queries, 1323);
  EXPECT_EQ(edge_edge.queries, 54);
  EXPECT_EQ(vertex_face.positive + edge_edge.positive, 230);
  EXPECT_EQ(vertex_face.false_negative + edge_edge.false_negative, 0);
}

TEST(CcdQueries, HasFewFalsePositivesOnTranslations) {
  TRIVET_NEEDS_DATA("ccd");
  const auto [vertex_face, edge_edge] = score_all();
  EXPECT_LE(vertex_face.false_positive + edge_edge.false_positive, 43);
  EXPECT_EQ(vertex_face.stalled + edge_edge.stalled, 0);
}

}  // namespace
}  // namespace trivet
