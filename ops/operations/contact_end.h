// End of a contact while the object slides.
#pragma once

#include "core/contact/body.h"
#include "core/contact/contact.h"

namespace trivet {

/// The time until a contact's features no longer meet, when `moving` goes straight on with
/// `velocity`: until the vertex is over the end of the face (it goes on over faces in the same
/// plane), until an edge ends; the gap is not looked at. Where only ends and parallel edges meet:
/// until the faces are farther than `tolerance`. On the floor contacts last for ever.
/// @param fixed  null: the floor. @return >= 0; infinity: for ever.
double contact_end(const Body& moving, const Body* fixed, const ContactPoint& contact,
                   const Vec3& velocity, double tolerance);

}  // namespace trivet
