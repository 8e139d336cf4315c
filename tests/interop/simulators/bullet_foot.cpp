// A fault of an engine's default, alone: a faceted ball on three corners, half a millimetre from
// where it would tip, on Bullet's plane. The engine finds one contact a step, and the ball tips
// before it has three; with several contacts a step it stays. Exit status 0: both are so.
#include <btBulletDynamicsCommon.h>

#include <cmath>
#include <cstdio>

namespace {

constexpr btScalar kUnit = 100, kStep = 1.0 / 240;  // of a metre; seconds
constexpr btScalar kGap = 3.3e-6;                   // metres, as of a contact of Trivet
constexpr btScalar kRadius = 0.0335, kMass = 0.143, kInertia = 6.1e-5;
constexpr btScalar kFoot[3][2] = {{0.0163, 0.0007}, {-0.0079, -0.0119}, {0.0078, 0.0137}};

/// Degrees by which it has turned after 2 seconds.
double tipped(bool several_contacts) {
  btDefaultCollisionConfiguration configuration;
  if (several_contacts) configuration.setPlaneConvexMultipointIterations();
  btCollisionDispatcher dispatcher(&configuration);
  btDbvtBroadphase broadphase;
  btSequentialImpulseConstraintSolver solver;
  btDiscreteDynamicsWorld world(&dispatcher, &broadphase, &solver, &configuration);
  world.setGravity(btVector3(0, 0, -9.80665 * kUnit));
  btStaticPlaneShape plane(btVector3(0, 0, 1), 0);
  btRigidBody floor(0, nullptr, &plane);
  btConvexHullShape hull;
  for (const auto& corner : kFoot) {
    hull.addPoint(kUnit * btVector3(corner[0], corner[1], -kRadius));
    hull.addPoint(kUnit * btVector3(corner[0], corner[1], kRadius));
  }
  for (int i = 0; i < 8; ++i) {
    const btScalar angle = SIMD_PI * i / 4;
    hull.addPoint(kUnit * kRadius * btVector3(btCos(angle), btSin(angle), 0));
  }
  hull.setMargin(0);
  const btScalar inertia = kInertia * kUnit * kUnit;
  btRigidBody::btRigidBodyConstructionInfo info(kMass, nullptr, &hull,
                                                btVector3(inertia, inertia, inertia));
  info.m_startWorldTransform.setIdentity();
  info.m_startWorldTransform.setOrigin(btVector3(0, 0, kUnit * (kRadius + kGap)));
  btRigidBody solid(info);
  world.addRigidBody(&floor);
  world.addRigidBody(&solid);
  for (int i = 0; i < 480; ++i) world.stepSimulation(kStep, 0);
  const double turned =
      solid.getWorldTransform().getRotation().angleShortestPath(btQuaternion::getIdentity());
  world.removeRigidBody(&solid);
  world.removeRigidBody(&floor);
  return turned * 180 / SIMD_PI;
}

}  // namespace

int main() {
  const double by_default = tipped(false), several = tipped(true);
  std::printf("Bullet, 2 s: turned by %.2f degrees with one contact a step, %.3f with several\n",
              by_default, several);
  return by_default > 5 && several < 1 ? 0 : 1;
}
