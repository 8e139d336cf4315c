#include "core/flex/drape.h"

#include <algorithm>

#include "core/flex/elasticity.h"
#include "core/flex/levels.h"

namespace trivet::flex {
namespace {

constexpr double kBearing = 0.01;      // of a vertex's weight: what counts for friction's use
constexpr double kLayerOfCell = 0.25;  // largest layer, of a cell

/// One level: its body among the obstacles.
class Level {
 public:
  Level(const DrapeProblem& problem, const Obstacles& obstacles, const DrapeOptions& options,
        int above, int levels)
      : m_settings(level_settings(problem, options, above, levels)),
        m_body(made_of(problem, m_settings.material)),
        m_surroundings(m_body, obstacles),
        m_model(m_body, m_surroundings, {contact_layer(m_settings.layer, m_body), options.pressure},
                options.slip),
        m_minimiser(m_body, m_surroundings, m_model, minimiser_options(options)) {}

  Ending run(Points x, const Watch& watch, int number) {
    m_state.x = std::move(x);
    m_model.contact().keep_distances_of(m_state.x);
    return m_minimiser.run(m_state, watch, number);
  }
  const Points& x() const { return m_state.x; }
  int num_steps() const { return m_minimiser.num_steps(); }

  void report(DrapeResult& out) {
    const NodalForces forces = m_model.forces(m_state, true);
    RestCertificate& c = out.certificate;
    int at = 0;
    c.net_force = m_model.residual(m_state.gradient, &at);
    c.net_force_at = m_state.x[at];
    c.friction_used =
        m_model.friction().largest_use(m_state.x, forces, kBearing * m_body.mean_weight());
    c.stretch = largest_stretch(m_body, m_state.x);
    c.stable = m_minimiser.is_stable();
    c.num_vertices = static_cast<int>(m_body.size());
    c.num_contacts = static_cast<int>(m_state.pairs.size());
    c.num_own_contacts =
        static_cast<int>(std::count_if(m_state.pairs.begin(), m_state.pairs.end(),
                                       [](const ContactPair& p) { return p.pair.is_own(); }));
    share_weight(forces, out);
    out.layer = m_model.contact().layer();
    out.friction.assign(m_body.size(), Vec3::Zero());
    // Friction at rest is stored, as positions alone do not tell it.
    Total slope{&out.friction, nullptr, Curvature::Exact};
    m_model.friction().energy(m_state.x, slope);
    for (Vec3& force : out.friction) force = -force;
  }

 private:
  static Body made_of(const DrapeProblem& problem, const FlexMaterial& material) {
    // Only the finest level has the material itself; others are softened.
    DrapeProblem level = problem;
    level.material = material;
    return body_of(level);
  }
  MinimiserOptions minimiser_options(const DrapeOptions& options) const {
    MinimiserOptions out = options.minimiser;
    out.tolerance = m_settings.tolerance;
    // Cables always use exact derivatives.
    if (m_body.is_cable) out.exact_below = kInfinity;
    return out;
  }

  // Friction at a vertex counts for the obstacle that pushes most there, upwards or not.
  void share_weight(const NodalForces& forces, DrapeResult& out) const {
    // The vertical force of each obstacle, in parts of the weight, says who carries how much.
    const double weight = m_body.weight();
    out.shares.assign(m_surroundings.obstacles().num_owners(), 0);
    out.touches.assign(out.shares.size(), false);
    out.pin_shares.assign(m_body.size(), 0);
    for (const ContactPair& p : m_state.pairs)
      if (!p.pair.is_own())
        out.touches[m_surroundings.obstacles().owner_of_vertex(p.points.fixed[0])] = true;
    double up = 0;
    for (size_t v = 0; v < m_body.size(); ++v) {
      const auto& by = forces.by[v];
      for (size_t o = 0; o < by.size(); ++o) out.shares[o] += by[o].up / weight, up += by[o].up;
      const double friction = m_model.friction().force(m_state.x, v)[2];
      const auto less = [](const Borne& a, const Borne& b) { return a.size < b.size; };
      const auto most = std::max_element(by.begin(), by.end(), less) - by.begin();
      if (friction != 0) out.shares[most] += friction / weight, up += friction;
      // A pin carries the force that is left at its vertex.
      if (!m_body.pinned[v]) continue;
      out.pin_shares[v] = m_state.gradient[v][2] / weight;
      out.pin_share += out.pin_shares[v];
    }
    out.certificate.balance = up / weight + out.pin_share;
  }

  LevelSettings m_settings;
  Body m_body;
  Surroundings m_surroundings;
  EnergyModel m_model;
  Minimiser m_minimiser;
  State m_state;
};

}  // namespace

double contact_layer(double layer, const Body& body) {
  return std::min(layer, kLayerOfCell * body.cell);
}

Body body_of(const DrapeProblem& problem) {
  Body body = problem.grid ? make_sheet(*problem.grid, problem.material)
              : problem.num_segments > 0
                  ? make_cable(problem.num_segments, problem.length, problem.material)
                  : make_mesh(problem.start, problem.faces, problem.material);
  body.pinned = problem.pinned;
  for (size_t v = 0; v < problem.loads.size(); ++v) body.mass[v] += problem.loads[v];
  return body;
}

DrapeResult drape(const DrapeProblem& problem, const Obstacles& obstacles,
                  const DrapeOptions& options, const Watch& watch) {
  // The coarsest level turns flaps and finds its place in few steps; each finer one begins where it
  // ended.
  const int levels = num_levels(problem, options);
  std::vector<DrapeProblem> all{problem};  // the finest first
  while (static_cast<int>(all.size()) < levels) all.push_back(coarser(all.back()));
  DrapeResult out;
  out.x = all.back().start;
  for (int above = levels - 1; above >= 0; --above) {
    Level level(all[above], obstacles, options, above, levels);
    out.ending = level.run(out.x, watch, levels - 1 - above);
    out.x = level.x();
    out.certificate.num_steps += level.num_steps();
    if (above == 0) level.report(out);
    if (out.ending == Ending::Stopped) return out;
    // Cells are halved along straight lines, so that no crossing appears.
    if (above > 0) out.x = refined(all[above], out.x);
  }
  return out;
}

std::optional<StartContact> start_contact(const DrapeProblem& problem, const Obstacles& obstacles) {
  // The start has to be clear of everything, as no step may undo a crossing.
  const Body body = body_of(problem);
  Surroundings surroundings(body, obstacles);
  std::vector<Aabb> boxes(body.size());
  for (size_t v = 0; v < body.size(); ++v) boxes[v].extend(problem.start[v]);
  const double offset = problem.material.thickness / 2, own = body.is_cable ? offset : 0;
  std::vector<NearPair> near;
  surroundings.find(boxes, offset, own, near);
  for (const NearPair& pair : near) {
    const PairPoints points = surroundings.points(pair, problem.start);
    if (points.distance > (pair.is_own() ? own : offset)) continue;
    StartContact out;
    out.at = problem.start[points.vertices[0]];
    if (!pair.is_own()) out.owner = obstacles.owner_of_vertex(points.fixed[0]);
    return out;
  }
  return std::nullopt;
}

}  // namespace trivet::flex
