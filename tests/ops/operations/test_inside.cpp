// Things in a container, and things that only lie on its rim.
#include <gtest/gtest.h>

#include "core/mesh/mesh.h"
#include "core/motion/compose.h"
#include "ops/operations/inside.h"
#include "support/solids.h"

namespace trivet {
namespace {

using namespace trivet::test;

Object object_of(const Triangles& triangles, const Vec3& at) {
  Object out;
  out.shape = make_shape(weld(triangles));
  out.pose.translation = at;
  return out;
}

// 0.4 by 0.4 m, a floor of 10 mm, walls of these heights to the left, right, back and front.
Object tray(double left, double right, double back, double front) {
  Triangles out = box_between({-0.2, -0.2, 0}, {0.2, 0.2, 0.01});
  const auto wall = [&](const Vec3& lower, const Vec3& upper) {
    if (!(upper.z() > lower.z())) return;
    const Triangles one = box_between(lower, upper);
    out.insert(out.end(), one.begin(), one.end());
  };
  wall({-0.2, -0.2, 0.01}, {-0.19, 0.2, left});
  wall({0.19, -0.2, 0.01}, {0.2, 0.2, right});
  wall({-0.19, 0.19, 0.01}, {0.19, 0.2, back});
  wall({-0.19, -0.2, 0.01}, {0.19, -0.19, front});
  return object_of(out, Vec3::Zero());
}

const Triangles kSpoon = box_triangles({0.1, 0.01, 0.005});

TEST(Inside, OnTheFloorOfATray) {
  EXPECT_TRUE(is_inside(object_of(kSpoon, {0, 0, 0.016}), tray(0.1, 0.1, 0.1, 0.1)));
  EXPECT_TRUE(is_inside(object_of(kSpoon, {0.05, 0.17, 0.016}), tray(0.1, 0.1, 0.1, 0.1)));
  EXPECT_TRUE(is_inside(object_of(kSpoon, {0, 0, 0.016}), tray(0.02, 0.02, 0.02, 0.02)));
}

TEST(Inside, ACompartmentMayBeOpenToOneSide) {
  EXPECT_TRUE(is_inside(object_of(kSpoon, {0, 0, 0.016}), tray(0.1, 0.1, 0.1, 0)));
}

TEST(Inside, AFloorAloneIsNoContainer) {
  EXPECT_FALSE(is_inside(object_of(kSpoon, {0, 0, 0.016}), tray(0, 0, 0, 0)));
}

TEST(Inside, WallsMakeAContainer) {
  EXPECT_TRUE(is_container(tray(0.1, 0.1, 0.1, 0.1)));
  EXPECT_TRUE(is_container(tray(0.1, 0.1, 0.1, 0)));
  EXPECT_FALSE(is_container(tray(0, 0, 0, 0)));
  EXPECT_FALSE(is_container(object_of(kSpoon, Vec3::Zero())));
}

TEST(Inside, NotOnTheRim) {
  EXPECT_FALSE(is_inside(object_of(kSpoon, {0.12, 0, 0.106}), tray(0.1, 0.1, 0.1, 0.1)));
  // The front is higher: there is a wall to one side alone.
  EXPECT_FALSE(is_inside(object_of(kSpoon, {0.12, 0, 0.106}), tray(0.1, 0.1, 0.1, 0.15)));
  EXPECT_FALSE(is_inside(object_of(kSpoon, {0, -0.195, 0.156}), tray(0.1, 0.1, 0.1, 0.15)));
}

// A pencil that leans out has its lower end inside.
TEST(Inside, WhatSticksOutIsInside) {
  Object pencil = object_of(box_triangles({0.004, 0.004, 0.15}), {0.1, 0, 0.16});
  pencil.pose.rotation = turn_about(Vec3::UnitY(), 30);
  EXPECT_TRUE(is_inside(pencil, tray(0.1, 0.1, 0.1, 0.1)));
}

}  // namespace
}  // namespace trivet
