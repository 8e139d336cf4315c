#include "apps/edit_document/boxes.h"

#include <fstream>

namespace trivet::edit::test {

void write_boxes(const std::string& file, const std::vector<Aabb>& boxes) {
  static constexpr int kFaces[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                       {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  std::ofstream out(file);
  out.precision(17);
  for (size_t b = 0; b < boxes.size(); ++b) {
    for (int corner = 0; corner < 8; ++corner) {
      out << "v";
      for (int k = 0; k < 3; ++k)
        out << " " << ((corner >> k) & 1 ? boxes[b].upper[k] : boxes[b].lower[k]);
      out << "\n";
    }
    for (const auto& face : kFaces) {
      out << "f";
      for (const int corner : face) out << " " << 8 * b + static_cast<size_t>(corner) + 1;
      out << "\n";
    }
  }
}

std::vector<Aabb> shelf_boxes() {
  return {{{-0.5, -0.2, 0}, {0.5, 0.2, 0.02}},   {{-0.5, -0.2, 0.4}, {0.5, 0.2, 0.42}},
          {{-0.5, -0.2, 0.8}, {0.5, 0.2, 0.82}}, {{-0.52, -0.2, 0}, {-0.5, 0.2, 0.82}},
          {{0.5, -0.2, 0}, {0.52, 0.2, 0.82}},   {{-0.5, 0.2, 0}, {0.5, 0.22, 0.82}}};
}

}  // namespace trivet::edit::test
