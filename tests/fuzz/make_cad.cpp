// Generates CAD files for tests of the program: make_cad FOLDER writes ball, ring, spoon and
// bottle, each as STEP, IGES and BREP.
#include <iostream>

#include "support/cad_shapes.h"

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "make_cad FOLDER\n";
    return 2;
  }
  using namespace trivet::test;
  const std::pair<const char*, TopoDS_Shape> shapes[] = {
      {"ball", ball()}, {"ring", ring()}, {"spoon", lofted_spoon()}, {"bottle", bottle()}};
  for (const auto& [name, shape] : shapes)
    for (const char* const extension : {".step", ".igs", ".brep"})
      if (!write_cad(shape, std::string(argv[1]) + "/" + name + extension)) return 1;
  return 0;
}
