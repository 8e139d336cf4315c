// Exported scenes at rest in Bullet: bullet_rest SECONDS [--starts FILE] SCENE.xml...
// Reads Trivet's MJCF, as scene.mjs does. See rest.h.
#include <btBulletDynamicsCommon.h>
#include <tinyxml2.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <sstream>

#include "interop/simulators/rest.h"

namespace {

using Element = const tinyxml2::XMLElement;
using rest::Json;

constexpr btScalar kStep = 1e-3;  // seconds; of longer ones heavy things crush light ones
constexpr btScalar kUnit = 100;  // per metre: the engine's thresholds of contacts are absolute
constexpr int kIterations = 100;

std::vector<double> numbers(Element* element, const char* attribute) {
  std::istringstream text(element->Attribute(attribute));
  std::vector<double> out;
  for (double value = 0; text >> value;) out.push_back(value);
  return out;
}

btVector3 vector(const std::vector<double>& v) { return {v[0], v[1], v[2]}; }
btQuaternion quaternion(const std::vector<double>& q) { return {q[1], q[2], q[3], q[0]}; }

template <class Use>
void for_each(Element* parent, const char* tag, Use use) {
  for (Element* e = parent->FirstChildElement(tag); e; e = e->NextSiblingElement(tag)) use(e);
}

std::vector<btVector3> vertices(const std::string& file) {
  std::ifstream in(file);
  if (!in) throw std::runtime_error(file + ": no such file");
  std::vector<btVector3> out;
  for (std::string line; std::getline(in, line);) {
    double x, y, z;
    if (std::sscanf(line.c_str(), "v %lf %lf %lf", &x, &y, &z) == 3) out.emplace_back(x, y, z);
  }
  return out;
}

// The smaller one of two coefficients is meant.
btScalar smaller_friction(const btCollisionObject* a, const btCollisionObject* b) {
  return std::min(a->getFriction(), b->getFriction());
}

struct Body {
  std::string name;
  bool fixed = false;
  btTransform start, link_from_principal;
  std::vector<btVector3> points;  // link frame
  std::unique_ptr<btCompoundShape> shape = std::make_unique<btCompoundShape>();
  std::unique_ptr<btRigidBody> rigid;

  btTransform pose() const { return rigid->getWorldTransform() * link_from_principal.inverse(); }
};

btTransform start_of(const std::vector<double>& rotation, const std::vector<double>& position) {
  return btTransform(quaternion(rotation), kUnit * vector(position));
}

Json moved(const Body& body) {
  const btTransform now = body.pose();
  double farthest = 0;
  for (const btVector3& point : body.points)
    farthest = std::max<double>(farthest, (now * point - body.start * point).length());
  const btVector3 p = now.getOrigin() / kUnit;
  const btQuaternion q = now.getRotation();
  const double angle = q.angleShortestPath(body.start.getRotation());
  return {{"name", body.name},
          {"moved", farthest / kUnit},
          {"turned_deg", angle * 180 / SIMD_PI},
          {"position", {p.x(), p.y(), p.z()}},
          {"rotation", {q.w(), q.x(), q.y(), q.z()}}};
}

class World {
 public:
  World(const std::string& file, const rest::Starts& starts) : m_starts(starts) {
    gCalculateCombinedFrictionCallback = smaller_friction;
    if (m_document.LoadFile(file.c_str()) != tinyxml2::XML_SUCCESS)
      throw std::runtime_error(file + ": " + m_document.ErrorStr());
    Element* const root = m_document.RootElement();
    m_folder = std::filesystem::path(file).parent_path() /
               root->FirstChildElement("compiler")->Attribute("meshdir");
    m_dynamics.setGravity(kUnit * vector(numbers(root->FirstChildElement("option"), "gravity")));

    // With one direction of friction, the default, things creep across it.
    m_dynamics.getSolverInfo().m_solverMode |= SOLVER_USE_2_FRICTION_DIRECTIONS;
    m_dynamics.getSolverInfo().m_numIterations = kIterations;
    // By default a hull on a plane gets one contact a step, and narrow feet tip: see
    // bullet_foot.cpp.
    m_configuration.setPlaneConvexMultipointIterations();
    for_each(root->FirstChildElement("asset"), "mesh", [this](Element* mesh) {
      m_files[mesh->Attribute("name")] = (m_folder / mesh->Attribute("file")).string();
    });
    Element* const world = root->FirstChildElement("worldbody");
    for_each(world, "geom", [this](Element* geom) { add_floor(geom); });
    for_each(world, "body", [this](Element* body) { add_body(body); });
    for (const auto& [name, start] : starts) check_body(name);
    for (const auto& body : m_bodies) m_dynamics.addRigidBody(body->rigid.get());
  }
  ~World() {
    for (const auto& body : m_bodies) m_dynamics.removeRigidBody(body->rigid.get());
    if (m_floor) m_dynamics.removeRigidBody(m_floor.get());
  }
  World(const World&) = delete;
  World& operator=(const World&) = delete;

  static std::string simulator() {
    return "Bullet " + std::to_string(btGetVersion() / 100) + "." +
           std::to_string(btGetVersion() % 100);
  }
  static double timestep() { return kStep; }
  static int warnings() { return 0; }
  size_t num_hulls() const { return m_hulls.size(); }
  Json objects() const {
    Json out = Json::array();
    for (const auto& body : m_bodies)
      if (!body->fixed) out.push_back(moved(*body));
    return out;
  }
  void step() { m_dynamics.stepSimulation(kStep, 0); }

  double penetration() {
    m_dynamics.performDiscreteCollisionDetection();
    double deepest = 0;
    for (int i = 0; i < m_dispatcher.getNumManifolds(); ++i) {
      const btPersistentManifold* const manifold = m_dispatcher.getManifoldByIndexInternal(i);
      for (int k = 0; k < manifold->getNumContacts(); ++k)
        deepest = std::max<double>(deepest, -manifold->getContactPoint(k).getDistance());
    }
    return deepest / kUnit;
  }

 private:
  void check_body(const std::string& name) const {
    for (const auto& body : m_bodies)
      if (body->name == name) return;
    throw std::runtime_error("no body \"" + name + "\"");
  }

  static double friction(Element* geom) { return numbers(geom, "friction")[0]; }

  void add_floor(Element* geom) {
    m_floor = std::make_unique<btRigidBody>(0, nullptr, &m_plane);
    m_floor->setFriction(friction(geom));
    m_dynamics.addRigidBody(m_floor.get());
  }

  void add_body(Element* element) {
    auto body = std::make_unique<Body>();
    body->name = element->Attribute("name");
    body->fixed = !element->FirstChildElement("freejoint");
    const auto given = m_starts.find(body->name);
    body->start = given != m_starts.end()
                      ? start_of(given->second.rotation, given->second.position)
                      : start_of(numbers(element, "quat"), numbers(element, "pos"));
    Element* const inertial = element->FirstChildElement("inertial");
    const std::vector<double> i = numbers(inertial, "fullinertia");
    btMatrix3x3 inertia(i[0], i[3], i[4], i[3], i[1], i[5], i[4], i[5], i[2]), axes;
    inertia.diagonalize(axes, btScalar(1e-12), 50);
    body->link_from_principal = btTransform(axes, kUnit * vector(numbers(inertial, "pos")));
    double mu = 0;
    for_each(element, "geom", [&](Element* geom) {
      if (std::string(geom->Attribute("class")) != "collision") return;
      add_hull(*body, geom->Attribute("mesh"));
      mu = friction(geom);
    });
    const btVector3 diagonal =
        kUnit * kUnit * btVector3(inertia[0][0], inertia[1][1], inertia[2][2]);
    btRigidBody::btRigidBodyConstructionInfo info(body->fixed ? 0 : numbers(inertial, "mass")[0],
                                                  nullptr, body->shape.get(), diagonal);
    info.m_startWorldTransform = body->start * body->link_from_principal;
    info.m_friction = mu;
    body->rigid = std::make_unique<btRigidBody>(info);
    m_bodies.push_back(std::move(body));
  }

  void add_hull(Body& body, const std::string& mesh) {
    const btTransform principal_from_link = body.link_from_principal.inverse();
    auto hull = std::make_unique<btConvexHullShape>();
    for (const btVector3& v : vertices(m_files.at(mesh))) {
      body.points.push_back(kUnit * v);
      hull->addPoint(principal_from_link * body.points.back(), false);
    }
    hull->recalcLocalAabb();
    hull->setMargin(0);
    body.shape->addChildShape(btTransform::getIdentity(), hull.get());
    m_hulls.push_back(std::move(hull));
  }

  const rest::Starts& m_starts;
  tinyxml2::XMLDocument m_document;
  std::filesystem::path m_folder;
  std::map<std::string, std::string> m_files;
  std::vector<std::unique_ptr<btConvexHullShape>> m_hulls;
  btStaticPlaneShape m_plane{btVector3(0, 0, 1), 0};
  btDefaultCollisionConfiguration m_configuration;
  btCollisionDispatcher m_dispatcher{&m_configuration};
  btDbvtBroadphase m_broadphase;
  btSequentialImpulseConstraintSolver m_solver;
  btDiscreteDynamicsWorld m_dynamics{&m_dispatcher, &m_broadphase, &m_solver, &m_configuration};
  std::unique_ptr<btRigidBody> m_floor;
  std::vector<std::unique_ptr<Body>> m_bodies;
};

}  // namespace

int main(int count, char** arguments) { return rest::run<World>(count, arguments); }
