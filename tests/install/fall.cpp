// A client program that uses geometry alone: how far a triangle falls onto the floor.
#include <cstdio>

#include "core/contact/first_contact.h"

int main() {
  const trivet::Triangle triangle = {trivet::Vec3(0, 0, 1.5), trivet::Vec3(1, 0, 1),
                                     trivet::Vec3(0, 1, 2)};
  const auto shape = trivet::make_shape(trivet::weld(std::vector<trivet::Triangle>{triangle}));
  const trivet::Body body(*shape, trivet::Affine{});
  trivet::FirstContactQuery query;
  query.moving = {&body, 1};
  query.floor = true;
  query.clearance.distance = 1e-6;
  query.motion = trivet::Motion::translation(-trivet::Vec3::UnitZ(), 3);
  const trivet::FirstContact contact = trivet::first_contact(query);
  std::printf("It falls %.9f m.\n", contact.time);
  const bool is_contact = contact.status == trivet::FirstContact::Status::Contact;
  return is_contact && contact.time <= 1 && contact.time > 0.999 ? 0 : 1;
}
