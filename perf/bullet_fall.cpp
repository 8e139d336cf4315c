#include "perf/bullet_fall.h"

#include <btBulletDynamicsCommon.h>

#include <cmath>
#include <deque>

#include "perf/report.h"

namespace trivet::perf {
namespace {

constexpr double kDensity = 1000;    // kg/m^3
constexpr double kLightest = 0.001;  // kg; of meshes without a volume
constexpr double kGravity = 9.81;    // m/s^2

btVector3 vector(const Vec3& v) { return {v.x(), v.y(), v.z()}; }

Vec3 vec3(const btVector3& v) { return {v.x(), v.y(), v.z()}; }

// Angle between two rotations.
double angle(const Rotation& a, const Rotation& b) {
  const double cosine = std::abs(a.w * b.w + a.x * b.x + a.y * b.y + a.z * b.z);
  return 2 * std::acos(std::min(1.0, cosine));
}

}  // namespace

const std::vector<ConvexPart>& PartStore::of(const Shape& shape) {
  const auto [entry, is_new] = m_parts.try_emplace(&shape);
  if (is_new) entry->second = convex_parts(shape.mesh, shape.adjacency, m_rule).parts;
  return entry->second;
}

struct BulletFall::World {
  struct Falling {
    std::string name;
    Vec3 centre;  // of mass, as the object stands upright at the origin
    btRigidBody* body;

    Pose pose() const {
      const btQuaternion q = body->getWorldTransform().getRotation();
      const Rotation r = Rotation{q.w(), q.x(), q.y(), q.z()}.normalized();
      return {r, vec3(body->getWorldTransform().getOrigin()) - r.matrix() * centre};
    }
  };

  explicit World(const FallRules& r)
      : rules(r),
        dispatcher(&configuration),
        dynamics(&dispatcher, &broadphase, &solver, &configuration) {
    dynamics.setGravity(btVector3(0, 0, -kGravity));
    dynamics.getSolverInfo().m_numIterations = rules.iterations;
  }
  ~World() {
    for (const auto& body : bodies) dynamics.removeRigidBody(body.get());
  }

  template <class Shape, class... Arguments>
  Shape& make(Arguments&&... arguments) {
    auto shape = std::make_unique<Shape>(std::forward<Arguments>(arguments)...);
    shape->setMargin(rules.margin);
    Shape& out = *shape;
    shapes.push_back(std::move(shape));
    return out;
  }

  btRigidBody& add(double mass, btCollisionShape& shape, const btTransform& at) {
    btVector3 inertia(0, 0, 0);
    if (mass > 0) shape.calculateLocalInertia(mass, inertia);
    btRigidBody::btRigidBodyConstructionInfo info(mass, nullptr, &shape, inertia);
    info.m_startWorldTransform = at;
    info.m_friction = std::sqrt(rules.friction);  // Bullet multiplies both
    info.m_linearDamping = rules.linear_damping;
    info.m_angularDamping = rules.angular_damping;
    bodies.push_back(std::make_unique<btRigidBody>(info));
    dynamics.addRigidBody(bodies.back().get());
    return *bodies.back();
  }

  void add_fixed(const Object& object) {
    auto mesh = std::make_unique<btTriangleMesh>(true, false);
    const Affine world = object.world_from_object();
    const Mesh& faces = object.shape->mesh;
    for (const Index3& t : faces.triangles)
      mesh->addTriangle(vector(world.apply(faces.vertices[t[0]])),
                        vector(world.apply(faces.vertices[t[1]])),
                        vector(world.apply(faces.vertices[t[2]])));
    add(0, make<btBvhTriangleMeshShape>(mesh.get(), true), btTransform::getIdentity());
    meshes.push_back(std::move(mesh));
  }

  void add_falling(const Object& object, const Pose& pose, PartStore& parts) {
    const Affine upright = world_from_object(Pose{}, object.up, object.scale);
    const Vec3 centre = upright.apply(object.shape->mass.centre);
    auto& compound = make<btCompoundShape>();
    for (const ConvexPart& part : parts.of(*object.shape)) {
      auto& hull = make<btConvexHullShape>();
      for (const Vec3& v : part.vertices) hull.addPoint(vector(upright.apply(v) - centre), false);
      hull.recalcLocalAabb();
      compound.addChildShape(btTransform::getIdentity(), &hull);
    }
    const double mass =
        std::max(kLightest, kDensity * object.shape->mass.volume * std::pow(object.scale, 3));
    const Rotation& r = pose.rotation;
    const btTransform at(btQuaternion(r.x, r.y, r.z, r.w),
                         vector(pose.translation + r.matrix() * centre));
    falling.push_back({object.name, centre, &add(mass, compound, at)});
  }

  void run_for(double seconds) {
    const int frames = static_cast<int>(std::lround(seconds * rules.frames_per_s));
    const double frame = 1.0 / rules.frames_per_s;
    for (int i = 0; i < frames; ++i)
      dynamics.stepSimulation(frame, rules.substeps, frame / rules.substeps);
    simulated_s += seconds;
  }

  Poses poses() const {
    Poses out;
    for (const Falling& f : falling) out[f.name] = f.pose();
    return out;
  }

  bool moved(const Poses& from, const Poses& to) const {
    for (const auto& [name, pose] : to)
      if ((pose.translation - from.at(name).translation).norm() > rules.stopped_m ||
          angle(pose.rotation, from.at(name).rotation) > rules.stopped_rad)
        return true;
    return false;
  }

  FallRules rules;
  btDefaultCollisionConfiguration configuration;
  btCollisionDispatcher dispatcher;
  btDbvtBroadphase broadphase;
  btSequentialImpulseConstraintSolver solver;
  btDiscreteDynamicsWorld dynamics;
  std::vector<std::unique_ptr<btTriangleMesh>> meshes;
  std::deque<std::unique_ptr<btCollisionShape>> shapes;
  std::vector<std::unique_ptr<btRigidBody>> bodies;
  std::vector<Falling> falling;
  double simulated_s = 0;
};

BulletFall::BulletFall(const Scene& scene, const Poses& starts, PartStore& parts,
                       const FallRules& rules)
    : m_world(std::make_unique<World>(rules)) {
  if (scene.floor)
    m_world->add(0, m_world->make<btStaticPlaneShape>(btVector3(0, 0, 1), 0),
                 btTransform::getIdentity());
  for (const ObjectId id : scene.ids()) {
    const Object& object = scene.at(id);
    const auto start = starts.find(object.name);
    if (start != starts.end())
      m_world->add_falling(object, start->second, parts);
    else if (object.fixed && object.placed)
      m_world->add_fixed(object);
  }
}

BulletFall::~BulletFall() = default;

bool BulletFall::run() {
  const FallRules& rules = m_world->rules;
  while (m_world->simulated_s < rules.longest_s) {
    const Poses before = m_world->poses();
    m_world->run_for(1);
    if (m_world->simulated_s >= rules.least_s && !m_world->moved(before, m_world->poses()))
      return true;
  }
  return false;
}

bool BulletFall::moves_within(double seconds) {
  const Poses before = m_world->poses();
  m_world->run_for(seconds);
  return m_world->moved(before, m_world->poses());
}

Poses BulletFall::poses() const { return m_world->poses(); }
double BulletFall::simulated_s() const { return m_world->simulated_s; }

std::string bullet_fall_version(const FallRules& rules) {
  return text("Bullet %d.%02d, double precision, %d steps a second of %d iterations, margin %g mm",
              btGetVersion() / 100, btGetVersion() % 100, rules.frames_per_s * rules.substeps,
              rules.iterations, 1e3 * rules.margin);
}

}  // namespace trivet::perf
