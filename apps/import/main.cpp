// trivet-import: reads one model of triangles and sends it to the process that started it.
#include "apps/import/importer.h"

int main(int argc, char** argv) {
  const auto read = [](const std::string& path, const trivet::ImportLimits& limits,
                       const trivet::Tessellation&) { return trivet::read_model(path, limits); };
  trivet::apps::import_and_exit(argc, argv, read);
}
