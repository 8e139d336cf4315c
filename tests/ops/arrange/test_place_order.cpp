// Places in the order in which they are asked for, beside all places judged and sorted.
#include <algorithm>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "ops/arrange/angles.h"
#include "ops/arrange/arrange_testing.h"
#include "ops/arrange/noise.h"
#include "ops/arrange/place_order.h"
#include "support/random_shapes.h"

namespace trivet::test {
namespace {

constexpr double kTemperature = 0.2;
constexpr double kNogoodRadius = 6e-3;
constexpr size_t kFreeTurns = 8, kFewTurns = 3, kSoftSights = 256, kMaxSights = 2048;

/// The order that PlaceOrder promises, by judging every place and sorting.
class SortedPlaces {
 public:
  SortedPlaces(World& world, std::uint64_t seed, Noise noise, Obstacles which,
               const std::vector<Vec2>& nogoods)
      : m_world(world),
        m_placer(world, 0, seed, noise),
        m_seed(seed),
        m_temperature(noise == Noise::On ? kTemperature : 0),
        m_which(which),
        m_nogoods(nogoods) {}

  std::vector<PlaceCandidate> all() {
    const bool are_free = turns_are_free();
    std::vector<PlaceCandidate> out;
    for (const bool few : {true, false}) {
      std::vector<PlaceCandidate> group;
      for (size_t c = 0; c < m_placer.combinations().size(); ++c)
        if (are_free ? is_of_few(c) == few : few) judge(c, group);
      sort(group);
      if (has_sights(false)) add_sights(group);
      give(group, out);
    }
    return out;
  }
  size_t num_too_close() const { return m_num_too_close; }
  size_t num_hidden() const { return m_num_hidden; }

 private:
  const Arrangement& arrangement() const { return m_world.arrangement(); }
  const std::string& name() const { return m_world.things().front().thing->object; }

  bool turns_are_free() const {
    if (m_temperature == 0 || !m_world.things().front().thing->yaws_deg.empty()) return false;
    const auto& all = arrangement().relations;
    return std::none_of(all.begin(), all.end(),
                        [](const Relation& r) { return r.as<relations::Facing>(); });
  }

  bool is_of_few(size_t combination) const {
    const auto key = [&](size_t t) { return scrambled(m_seed ^ scrambled(~t)); };
    const size_t turn = m_placer.combinations()[combination].turn;
    size_t rank = 0;
    for (size_t t = 0; t < kFreeTurns; ++t) rank += key(t) < key(turn) ? 1 : 0;
    return rank < kFewTurns;
  }

  std::vector<ObjectId> others(const Landing& landing) const {
    std::vector<ObjectId> out;
    for (const ObjectId id : m_world.standing())
      if (!std::count(landing.supports.begin(), landing.supports.end(), Support(id)) &&
          (m_which == Obstacles::All || m_world.thing_of(m_world.scene().at(id).name) < 0))
        out.push_back(id);
    return out;
  }

  // Cost of hard or soft relations by outlines: the worst of those, the weighted squares of these.
  double cost(const Outline& here, bool hard) const {
    double out = 0;
    for (const Relation& r : arrangement().relations) {
      if (r.is_support() || r.is_of_sight() || r.is_hard() != hard) continue;
      std::optional<Outline> other;
      if (!r.b.empty()) other = m_world.outline(r.b);
      const double cost = relation_cost(r, here, other ? &*other : nullptr);
      out = hard ? std::max(out, cost) : out + *r.weight * (cost * cost);
    }
    return out;
  }

  void judge(size_t c, std::vector<PlaceCandidate>& out) const {
    const Combination& combination = m_placer.combinations()[c];
    const PlaceField field = m_placer.field(combination);
    const std::vector<ObjectId> others = this->others(combination.landing);
    const std::vector<char> clear = field.clear_of(others, m_world.keep(name(), "desk"));
    const auto floor = field.obstruction_of_floor();
    for (size_t place = 0; place < field.size(); ++place) {
      const Vec2& at = field.at(place);
      const bool is_nogood = std::any_of(m_nogoods.begin(), m_nogoods.end(), [&](const Vec2& p) {
        return (p - at).norm() < kNogoodRadius;
      });
      const Outline here = moved(combination.outline, at);
      if (is_nogood || cost(here, true) > 1 || !field.is_over_support(place) || !clear[place] ||
          !floor->is_clear(place))
        continue;
      PlaceCandidate found;
      found.energy = cost(here, false);
      const std::uint64_t counter = scrambled(scrambled(m_seed ^ scrambled(c)) ^ place);
      found.key = found.energy - m_temperature * gumbel_noise(counter);
      found.combination = c, found.start_z = field.met_at(place);
      found.at = at, found.pixel = field.pixel();
      out.push_back(found);
    }
  }

  static void sort(std::vector<PlaceCandidate>& places) {
    std::stable_sort(places.begin(), places.end(),
                     [](const auto& a, const auto& b) { return a.key < b.key; });
  }

  SightTrial trial(const PlaceCandidate& c, Obstacles which) const {
    const Vec3 at(c.at.x(), c.at.y(), c.start_z);
    return {m_world,
            0,
            {m_placer.combinations()[c.combination].rotation, at},
            which == Obstacles::Immovable};
  }

  bool has_sights(bool hard) const {
    const auto& relations = arrangement().relations;
    return std::any_of(relations.begin(), relations.end(),
                       [&](const Relation& r) { return r.is_of_sight() && r.is_hard() == hard; });
  }

  // The best ones come first, whatever soft sights add; the others follow as they were.
  void add_sights(std::vector<PlaceCandidate>& places) const {
    const auto end = places.begin() + std::min(places.size(), kSoftSights);
    std::vector<PlaceCandidate> best(places.begin(), end);
    for (PlaceCandidate& c : best) {
      double more = 0;
      for (const Relation& r : arrangement().relations) {
        if (!r.is_of_sight() || r.is_hard()) continue;
        const double cost = sight_cost(trial(c, Obstacles::All), r);
        more += *r.weight * (cost * cost);
      }
      c.energy += more, c.key += more;
    }
    sort(best);
    std::copy(best.begin(), best.end(), places.begin());
  }

  void give(const std::vector<PlaceCandidate>& places, std::vector<PlaceCandidate>& out) {
    size_t num_sights = 0;
    for (const PlaceCandidate& c : places) {
      if (num_sights >= kMaxSights) return;
      const bool is_close = std::any_of(out.begin(), out.end(), [&](const PlaceCandidate& o) {
        return o.combination == c.combination && (o.at - c.at).norm() < 2 * c.pixel;
      });
      m_num_too_close += is_close ? 1 : 0;
      if (is_close) continue;
      if (has_sights(true)) {
        ++num_sights;
        if (!meets_sights(c)) continue;
      }
      out.push_back(c);
    }
  }

  bool meets_sights(const PlaceCandidate& c) {
    for (const Relation& r : arrangement().relations)
      if (r.is_of_sight() && r.is_hard() && sight_cost(trial(c, m_which), r) > 1) {
        ++m_num_hidden;
        return false;
      }
    return true;
  }

  World& m_world;
  Placer m_placer;
  std::uint64_t m_seed;
  double m_temperature;
  Obstacles m_which;
  const std::vector<Vec2>& m_nogoods;
  size_t m_num_too_close = 0, m_num_hidden = 0;
};

/// A cup that is to be put somewhere on a desk with posts, and a box that may move.
class Desk : public Stage {
 public:
  Desk(Random& random, int num_posts) {
    fix("desk", box_between(Vec3(-0.3, -0.2, 0), Vec3(0.3, 0.2, 0.7)), Vec3(0, 0, 1e-5));
    for (int i = 0; i < num_posts; ++i)
      fix("post_" + std::to_string(i), box_between(Vec3(-0.02, -0.01, 0), Vec3(0.02, 0.01, 0.2)),
          Vec3(random.uniform(-0.3, 0.3), random.uniform(-0.2, 0.2), 0.70002));
    add("cup", box_between(Vec3(-0.04, -0.03, 0), Vec3(0.04, 0.03, 0.1)));
    add("box", box_between(Vec3(-0.05, -0.02, 0), Vec3(0.05, 0.02, 0.06)));
    relate<relations::On>("cup", "desk");
  }
  /// From in front of the desk, past a screen that ends at x.
  void look_past(double x, double part, bool is_hard) {
    fix("screen", box_between(Vec3(-0.15, -0.002, 0), Vec3(0.15, 0.002, 0.25)),
        Vec3(x - 0.15, -0.19, 0.70002));
    Relation& view = relate<relations::View>("cup");
    view.as<relations::View>()->eye = Vec3(x, -1, 0.85), view.as<relations::View>()->part = part,
    view.tolerance = 0.1;
    if (!is_hard) view.weight = 0.5;
  }
};

struct Count {
  size_t num_given = 0, num_too_close = 0, num_hidden = 0;
};

// Compares both lists of places.
Count expect_sorted(Desk& desk, std::uint64_t seed, Noise noise, Obstacles which,
                    const std::vector<Vec2>& nogoods = {}) {
  Transaction transaction(desk.scene);
  World world(transaction, desk.arrangement, {});
  PutOperation put;
  put.object = "box";
  put.start.translation = Vec3(0.02, 0.03, 1);
  EXPECT_TRUE(world.perform(put).ok());
  SortedPlaces sorted(world, seed, noise, which, nogoods);
  const std::vector<PlaceCandidate> wanted = sorted.all();
  const Placer placer(world, 0, seed, noise);
  PlaceOrder places(placer, which, nogoods);
  Count out{0, sorted.num_too_close(), sorted.num_hidden()};
  const auto values = [](const PlaceCandidate& c) {
    return std::tuple(c.key, c.energy, c.combination, c.at.x(), c.at.y(), c.start_z, c.pixel);
  };
  for (; const auto next = places.next(); ++out.num_given) {
    if (out.num_given >= wanted.size()) break;
    EXPECT_EQ(values(*next), values(wanted[out.num_given])) << "place " << out.num_given;
    if (::testing::Test::HasFailure()) break;
  }
  EXPECT_EQ(out.num_given, wanted.size());
  EXPECT_FALSE(places.next());
  return out;
}

// Free turns, turns that are asked for, soft costs, lines of sight, with and without noise.
TEST(PlaceOrder, IsThatOfAllPlacesSorted) {
  Random random(31);
  Count all;
  for (int round = 0; round < 20 && !HasFailure(); ++round) {
    SCOPED_TRACE(round);
    Desk desk(random, random.integer(0, 5));
    if (round % 4 == 1) desk.arrangement.things.front().yaws_deg = {0, 30};
    const Vec2 middle(random.uniform(-0.15, 0.15), random.uniform(-0.1, 0.1));
    const Vec2 half(random.uniform(0.06, 0.1), random.uniform(0.06, 0.1));
    Relation& within = desk.relate<relations::Within>("cup");
    for (const Vec2& corner : {Vec2(-1, -1), Vec2(1, -1), Vec2(1, 1), Vec2(-1, 1)})
      within.as<relations::Within>()->region.emplace_back(middle + half.cwiseProduct(corner));
    if (round % 5 == 1 || round % 5 == 2) {
      relations::At at;
      relations::Facing facing;
      at.point = facing.point = middle + Vec2(0.01, 0.02);
      Relation& soft = round % 5 == 1 ? desk.relate("cup", at) : desk.relate("cup", facing);
      soft.tolerance = round % 5 == 1 ? 0.02 : 30, soft.weight = 0.3;
    }
    if (round % 5 > 2) desk.look_past(middle.x(), random.uniform(0.7, 1), round % 5 == 3);
    if (round % 4 == 2) {
      desk.fix("tile", box_between(Vec3(-0.02, -0.02, 0), Vec3(0.02, 0.02, 0.01)),
               Vec3(middle.x(), middle.y(), 0.70002));
      Relation& beside = desk.relate<relations::RightOf>("cup", "tile");
      beside.as<relations::RightOf>()->lower = -0.01, beside.as<relations::RightOf>()->upper = 0.05,
      beside.as<relations::RightOf>()->overlap = 0.2;
      desk.relate<relations::Near>("cup", "tile").as<relations::Near>()->upper = 0.03;
    }
    if (round % 3 == 0) desk.arrangement.keeps.push_back({{"cup"}, 0.01, {}});
    const std::vector<Vec2> nogoods(round % 3, middle + Vec2(0.01, 0));
    const Count count =
        expect_sorted(desk, round, round % 2 ? Noise::On : Noise::Off,
                      round % 7 < 4 ? Obstacles::All : Obstacles::Immovable, nogoods);
    all.num_given += count.num_given;
    all.num_too_close += count.num_too_close;
    all.num_hidden += count.num_hidden;
  }
  EXPECT_GT(all.num_given, 1000);
  EXPECT_GT(all.num_too_close, 1000);
  EXPECT_GT(all.num_hidden, 50);
}

TEST(PlaceOrder, OfOnePlaceIsThatOne) {
  Random random(1);
  for (const Noise noise : {Noise::On, Noise::Off}) {
    Desk desk(random, 0);
    desk.arrangement.things.front().yaws_deg = {0};
    Relation& at = desk.relate<relations::At>("cup");
    at.as<relations::At>()->point = Vec2(-0.15, -0.1), at.tolerance = 1e-6;
    EXPECT_EQ(expect_sorted(desk, 4, noise, Obstacles::All).num_given, 1);
  }
}

TEST(PlaceOrder, OfNoneIsNone) {
  Random random(1);
  const auto count = [&](const Vec2& point, const std::vector<Vec2>& nogoods) {
    Desk desk(random, 0);
    Relation& at = desk.relate<relations::At>("cup");
    at.as<relations::At>()->point = point, at.tolerance = 1e-6;
    return expect_sorted(desk, 4, Noise::On, Obstacles::All, nogoods).num_given;
  };
  EXPECT_EQ(count(Vec2(0.02, 0.03), {}), 0);                      // the box is there
  EXPECT_EQ(count(Vec2(-0.15, -0.1), {Vec2(-0.15, -0.099)}), 0);  // a nogood is
  EXPECT_EQ(count(Vec2(-1.15, -0.1), {}), 0);                     // beside the desk
  EXPECT_GT(count(Vec2(-0.15, -0.1), {}), 0);
}

}  // namespace
}  // namespace trivet::test
