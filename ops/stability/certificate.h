// The vertical certificate: each object's weight, with what its loads give it, passed down through
// contacts that can carry a vertical force.
#pragma once

#include "ops/stability/free_bodies.h"

namespace trivet {

struct Certificate {
  struct Body {
    bool certified = false;
    double margin = 0;  // metres that the resultant is inside the hull of its supports' points
  };
  std::vector<Body> bodies;
  std::vector<double> forces;  // vertical, newtons, of each touch: on its body `on`, upwards;
                               // negative: `on` lies on top and presses `from` up
};

/// Bodies are visited from top to bottom. One is certified when all its loads are and the resultant
/// of its own weight and theirs passes through the hull of the contact points that can carry; it is
/// then shared among them. Sufficient, not necessary: arches and what leans need more.
/// Cost O(touches log touches).
/// @param factor  of all coefficients of friction.
Certificate vertical_certificate(const FreeBodies& all, double factor = 1);

/// Adds to the bodies of `rest` what certified bodies press on them.
/// @param all  of the certificate.
/// @param rest  bodies of `all`, none of them certified.
void add_certified_loads(const FreeBodies& all, const Certificate& certificate, FreeBodies& rest);

/// Non-negative parts, summing up to 1, of points whose weighted mean is `target`: the mean over
/// the corners of the hull of the parts that the fan of triangles about that corner gives, so that
/// symmetry is kept. Empty: `target` is outside by more than `slack`.
std::vector<double> shares(const std::vector<Vec2>& points, const Vec2& target, double slack);

}  // namespace trivet
