#include "support/random_queries.h"

#include <bit>
#include <sstream>

namespace trivet::test {
namespace {

std::vector<Triangle> make_mesh(MeshKind kind, Random& random) {
  const auto seed = static_cast<unsigned>(random.integer(0, 1 << 30));
  switch (kind) {
    case MeshKind::Box:
      return box_triangles(random.integer(0, 1) ? Vec3(0.5, 0.5, 0.5)
                                                : Vec3(random.uniform(0.1, 1), 0.5, 0.25));
    case MeshKind::Sphere:
      return bumpy_sphere(random.integer(3, 6), random.integer(4, 8), random.uniform(0, 0.3), seed);
    case MeshKind::Terrain:
      return terrain(random.integer(1, 5), 1, random.uniform(0, 0.5), seed);
    default:
      return soup(random.integer(2, 20), static_cast<int>(kind), random);
  }
}

// Quarter turns, so that faces of boxes and grids stay aligned.
Rotation aligned_rotation(Random& random) {
  Rotation out;
  for (int k = 0; k < 3; ++k)
    if (random.integer(0, 1)) out = Rotation::about_axis(Vec3::Unit(k), 1) * out;
  return out.normalized();
}

Pose random_pose(bool aligned, const Vec3& place, Random& random) {
  if (!aligned) return {random.rotation(), place};
  const Vec3 on_grid = (4 * place).array().round() / 4;
  return {aligned_rotation(random), on_grid};
}

Vec3 random_vertex(const PosedShape& body, Random& random) {
  const auto& vertices = body.shape->mesh.vertices;
  const int i = random.integer(0, static_cast<int>(vertices.size()) - 1);
  return body.body().vertex(i);
}

// A point and a direction prone to degenerate cases: vertices, edges, coordinate axes.
Vec3 special_direction(const RandomQuery& q, Random& random) {
  const PosedShape& body = random.integer(0, 1) ? q.moving[0] : q.fixed[0];
  const Vec3 d = random_vertex(body, random) - random_vertex(body, random);
  if (random.integer(0, 1) || d.norm() < 1e-9)
    return (random.integer(0, 1) ? 1 : -1) * Vec3::Unit(random.integer(0, 2));
  return d.normalized();
}

Motion make_motion(const RandomQuery& q, bool rotation, Random& random) {
  const Vec3 centre = q.moving[0].pose.translation;
  const Vec3 towards = q.fixed[0].pose.translation - centre;
  Motion motion = random_motion(rotation, centre, 1, random);
  const int style = random.integer(0, 3);
  if (style == 0) motion.axis = special_direction(q, random);
  if (rotation) {
    if (style < 2)
      motion.centre = random_vertex(random.integer(0, 1) ? q.moving[0] : q.fixed[0], random);
    if (random.integer(0, 3) == 0) motion.limit = 1;
  } else if (style > 1 && towards.norm() > 0.1) {
    motion.axis = (towards.normalized() + random.in_cube(0.4)).normalized();
  }
  return motion;
}

double random_clearance(Random& random) { return std::pow(10.0, random.uniform(-7, -3)); }

// Starts at the contact of another motion, if it has one.
void start_near(RandomQuery& q, Random& random) {
  for (int attempt = 0; attempt < 4 && !q.starts_near; ++attempt) {
    q.motion = make_motion(q, random.integer(0, 1), random);
    const FirstContact found = q.fast();
    if (found.status != FirstContact::Status::Contact) continue;
    q.advance(found.time);
    q.starts_near = true;
  }
}

}  // namespace

const char* to_string(MeshKind kind) {
  constexpr const char* kNames[kNumMeshKinds] = {"any",  "needles", "degenerate", "grid",
                                                 "tiny", "box",     "sphere",     "terrain"};
  return kNames[static_cast<int>(kind)];
}

FirstContact RandomQuery::fast() const {
  return ask([](const FirstContactQuery& q) { return first_contact(q); });
}

FirstContact RandomQuery::brute_force() const {
  return ask([](const FirstContactQuery& q) { return first_contact_brute_force(q); });
}

FirstContact RandomQuery::with_stage(CandidateFinder& stage, CandidatePairs* proposal) const {
  return ask([&](const FirstContactQuery& q) { return first_contact(q, stage, proposal); });
}

void RandomQuery::advance(double time) {
  for (PosedShape& m : moving) m.pose = moved_pose(m.pose, motion, time);
}

std::string RandomQuery::describe() const {
  std::ostringstream out;
  out.precision(17);
  const bool turning = motion.kind == Motion::Kind::Rotation;
  out << to_string(kind_moving) << " against " << to_string(kind_fixed)
      << (starts_near ? ", from contact, " : ", ") << (turning ? "turn about " : "along ")
      << motion.axis.transpose() << " at " << motion.centre.transpose() << " to " << motion.limit
      << ", clearance " << clearance.distance;
  for (const auto* list : {&moving, &fixed})
    for (const PosedShape& m : *list)
      out << "\n  " << (list == &moving ? "moving" : "fixed") << " w x y z " << m.pose.rotation.w
          << ' ' << m.pose.rotation.x << ' ' << m.pose.rotation.y << ' ' << m.pose.rotation.z
          << " at " << m.pose.translation.transpose();
  return out.str();
}

MeshPool::MeshPool(unsigned seed, int num_each) {
  Random random(seed);
  for (int k = 0; k < kNumMeshKinds; ++k)
    for (int i = 0; i < num_each; ++i)
      m_shapes[k].push_back(shape_of(make_mesh(static_cast<MeshKind>(k), random)));
}

const std::shared_ptr<const Shape>& MeshPool::pick(MeshKind kind, Random& random) const {
  const auto& shapes = m_shapes[static_cast<int>(kind)];
  return shapes[random.integer(0, static_cast<int>(shapes.size()) - 1)];
}

RandomQuery random_query(const MeshPool& pool, unsigned seed, int index) {
  Random random(seed + static_cast<unsigned>(index));
  RandomQuery q;
  q.kind_moving = static_cast<MeshKind>(index % kNumMeshKinds);
  q.kind_fixed = static_cast<MeshKind>(index / kNumMeshKinds % kNumMeshKinds);
  const bool aligned = random.integer(0, 3) == 0;
  const Vec3 place = random.uniform(0.9, 3) * random.direction();
  q.fixed.push_back({pool.pick(q.kind_fixed, random), random_pose(aligned, Vec3::Zero(), random)});
  q.moving.push_back({pool.pick(q.kind_moving, random), random_pose(aligned, place, random)});
  q.clearance.distance = random_clearance(random);
  if (index % 3 == 0) start_near(q, random);
  q.motion = make_motion(q, index / (kNumMeshKinds * kNumMeshKinds) % 2, random);
  return q;
}

RandomQuery random_group_query(const MeshPool& pool, unsigned seed, int index) {
  Random random(seed + static_cast<unsigned>(index));
  RandomQuery q;
  q.kind_moving = static_cast<MeshKind>(index % kNumMeshKinds);
  q.kind_fixed = static_cast<MeshKind>(index / kNumMeshKinds % kNumMeshKinds);
  q.floor = random.integer(0, 3) != 0;
  const int num_moving = random.integer(1, 3), num_fixed = random.integer(0, 4);
  for (int i = 0; i < num_fixed; ++i)
    q.fixed.push_back({pool.pick(q.kind_fixed, random),
                       random_pose(i == 0, random.in_cube(3) + Vec3(0, 0, 4), random),
                       random.uniform(0.3, 1)});
  for (int i = 0; i < num_moving; ++i)
    q.moving.push_back({pool.pick(q.kind_moving, random),
                        random_pose(i == 0, random.in_cube(2) + Vec3(0, 0, 3), random),
                        random.uniform(0.3, 1)});
  q.clearance.distance = random_clearance(random);
  q.motion = random_motion(index / (kNumMeshKinds * kNumMeshKinds) % 2,
                           q.moving[0].pose.translation, 2, random);
  return q;
}

bool same_answer(const FirstContact& a, const FirstContact& b) {
  const auto bits = [](double x) { return std::bit_cast<std::uint64_t>(x); };
  const auto same = [&](const Vec3& x, const Vec3& y) {
    return bits(x.x()) == bits(y.x()) && bits(x.y()) == bits(y.y()) && bits(x.z()) == bits(y.z());
  };
  return a.status == b.status && bits(a.time) == bits(b.time) && a.moving == b.moving &&
         a.fixed == b.fixed && a.face_moving == b.face_moving && a.face_fixed == b.face_fixed &&
         same(a.point, b.point) && same(a.normal, b.normal) && bits(a.gap) == bits(b.gap) &&
         a.stalled == b.stalled;
}

std::string describe(const FirstContact& c) {
  constexpr const char* kStatus[] = {"free", "contact", "crossing"};
  std::ostringstream out;
  out.precision(17);
  out << kStatus[static_cast<int>(c.status)] << " at time " << c.time << ", bodies " << c.moving
      << ' ' << c.fixed << ", faces " << c.face_moving << ' ' << c.face_fixed << ", gap " << c.gap
      << ", point " << c.point.transpose() << ", normal " << c.normal.transpose()
      << (c.stalled ? ", stalled" : "");
  return out.str();
}

}  // namespace trivet::test
