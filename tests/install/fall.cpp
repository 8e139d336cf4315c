// A client program that uses geometry alone: how far a triangle falls onto the floor.
#include <trivet/geometry.h>

#include <cstdio>

int main() {
  const trivet::Shape shape(trivet::Mesh{{{0, 0, 1.5}, {1, 0, 1}, {0, 1, 2}}, {{0, 1, 2}}});
  const auto contact =
      trivet::first_contact_with_floor({shape, {}}, {.direction = {0, 0, -1}, .distance = 3}, 1e-6);
  if (!contact) return 1;
  std::printf("The triangle falls %.9f m.\n", contact->amount);
  return contact->amount > 0.999998 && contact->amount < 1 ? 0 : 1;
}
