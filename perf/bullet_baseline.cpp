// Bullet, in double precision: the saucer as a static triangle mesh, the spoon as a compound of
// convex hulls or as a GImpact mesh.
#include <BulletCollision/Gimpact/btGImpactCollisionAlgorithm.h>
#include <BulletCollision/Gimpact/btGImpactShape.h>
#include <btBulletDynamicsCommon.h>

#include "perf/report.h"
#include "perf/settling.h"

namespace trivet::perf {
namespace {

constexpr double kStep = 1.0 / 240;  // s
constexpr double kMargin = 0.0005;   // m; the default of 40 mm is made for objects of metres

enum class Form { Compound, GImpact };

btVector3 vector(const Vec3& v) { return {v.x(), v.y(), v.z()}; }

btTransform transform(const Pose& pose) {
  const Rotation& r = pose.rotation;
  return btTransform(btQuaternion(r.x, r.y, r.z, r.w), vector(pose.translation));
}

Pose pose_of(const btTransform& t) {
  const btQuaternion r = t.getRotation();
  const btVector3& p = t.getOrigin();
  return {Rotation{r.w(), r.x(), r.y(), r.z()}.normalized(), Vec3(p.x(), p.y(), p.z())};
}

std::unique_ptr<btTriangleMesh> triangles_of(const Mesh& mesh) {
  auto out = std::make_unique<btTriangleMesh>(true, false);
  for (const Index3& t : mesh.triangles)
    out->addTriangle(vector(mesh.vertices[t[0]]), vector(mesh.vertices[t[1]]),
                     vector(mesh.vertices[t[2]]));
  return out;
}

// The moving shape with its component shapes.
class MovingShape {
 public:
  MovingShape(const SettleTask& task, Form form) {
    if (form == Form::GImpact) {
      m_triangles = triangles_of(task.moving);
      auto mesh = std::make_unique<btGImpactMeshShape>(m_triangles.get());
      mesh->setMargin(kMargin);
      mesh->updateBound();
      m_shape = std::move(mesh);
      return;
    }
    auto compound = std::make_unique<btCompoundShape>();
    for (const Piece& piece : task.moving_pieces) {
      auto hull = std::make_unique<btConvexHullShape>();
      for (const Vec3& p : piece) hull->addPoint(vector(p), false);
      hull->optimizeConvexHull();
      hull->recalcLocalAabb();
      hull->setMargin(kMargin);
      compound->addChildShape(btTransform::getIdentity(), hull.get());
      m_hulls.push_back(std::move(hull));
    }
    m_shape = std::move(compound);
  }
  btCollisionShape* shape() const { return m_shape.get(); }

 private:
  std::unique_ptr<btTriangleMesh> m_triangles;
  std::vector<std::unique_ptr<btConvexHullShape>> m_hulls;
  std::unique_ptr<btCollisionShape> m_shape;
};

// State between two steps; created anew for each run, so that runs are independent.
class World {
 public:
  World(const SimulationRules& rules, btCollisionShape* fixed, btCollisionShape* floor,
        const SettleTask& task, btCollisionShape* moving, const Pose& body)
      : m_dispatcher(&m_configuration),
        m_world(&m_dispatcher, &m_broadphase, &m_solver, &m_configuration) {
    btGImpactCollisionAlgorithm::registerAlgorithm(&m_dispatcher);
    m_world.setGravity(btVector3(0, 0, -rules.gravity));
    add(0, fixed, btVector3(0, 0, 0), btTransform::getIdentity(), rules);
    add(0, floor, btVector3(0, 0, 0), btTransform::getIdentity(), rules);
    add(task.mass, moving, vector(task.inertia), transform(body), rules);
    m_bodies.back()->setActivationState(DISABLE_DEACTIVATION);
  }
  ~World() {
    for (const auto& body : m_bodies) m_world.removeRigidBody(body.get());
  }

  void step() { m_world.stepSimulation(kStep, 1, kStep); }
  const btRigidBody& moving() const { return *m_bodies.back(); }

 private:
  void add(double mass, btCollisionShape* shape, const btVector3& inertia, const btTransform& at,
           const SimulationRules& rules) {
    btRigidBody::btRigidBodyConstructionInfo info(mass, nullptr, shape, inertia);
    info.m_startWorldTransform = at;
    info.m_friction = std::sqrt(rules.friction);  // Bullet multiplies both
    m_bodies.push_back(std::make_unique<btRigidBody>(info));
    m_world.addRigidBody(m_bodies.back().get());
  }

  btDefaultCollisionConfiguration m_configuration;
  btCollisionDispatcher m_dispatcher;
  btDbvtBroadphase m_broadphase;
  btSequentialImpulseConstraintSolver m_solver;
  btDiscreteDynamicsWorld m_world;
  std::vector<std::unique_ptr<btRigidBody>> m_bodies;
};

class BulletSimulator : public Simulator {
 public:
  BulletSimulator(const SettleTask& task, const SimulationRules& rules, Form form)
      : m_task(task),
        m_rules(rules),
        m_form(form),
        m_moving(task, form),
        m_fixed_triangles(triangles_of(task.fixed)),
        m_fixed(m_fixed_triangles.get(), true),
        m_floor(btVector3(0, 0, 1), 0) {
    m_fixed.setMargin(kMargin);
    m_floor.setMargin(kMargin);
  }

  std::string name() const override {
    if (m_form == Form::GImpact) return "Bullet, GImpact mesh on triangle mesh";
    return text("Bullet, %zu hulls on triangle mesh", m_task.moving_pieces.size());
  }

  Settled settle(const Pose& start) override {
    World world(m_rules, &m_fixed, &m_floor, m_task, m_moving.shape(), m_task.body_pose(start));
    RestClock clock(m_rules);
    Settled out;
    while (!out.at_rest && out.simulated_s < m_rules.longest) {
      world.step();
      out.simulated_s += kStep;
      out.speed = world.moving().getLinearVelocity().length();
      out.spin = world.moving().getAngularVelocity().length();
      out.at_rest = clock.step(kStep, out.speed, out.spin);
    }
    out.pose = m_task.object_pose(pose_of(world.moving().getWorldTransform()));
    return out;
  }

 private:
  const SettleTask& m_task;
  SimulationRules m_rules;
  Form m_form;
  MovingShape m_moving;
  std::unique_ptr<btTriangleMesh> m_fixed_triangles;
  btBvhTriangleMeshShape m_fixed;
  btStaticPlaneShape m_floor;
};

}  // namespace

std::vector<std::unique_ptr<Simulator>> bullet_simulators(const SettleTask& task,
                                                          const SimulationRules& rules) {
  std::vector<std::unique_ptr<Simulator>> out;
  for (const Form form : {Form::Compound, Form::GImpact})
    out.push_back(std::make_unique<BulletSimulator>(task, rules, form));
  return out;
}

std::string bullet_version() {
  return text("%d.%02d, double precision, step 1/240 s, margin %g mm, default solver",
              btGetVersion() / 100, btGetVersion() % 100, 1e3 * kMargin);
}

}  // namespace trivet::perf
