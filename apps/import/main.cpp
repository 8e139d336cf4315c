// trivet-import: reads one triangle model and sends it to the parent process.
#include "apps/import/importer.h"

int main(int argc, char** argv) {
  const auto read = [](const std::string& path, const trivet::ImportLimits& limits,
                       const trivet::Tessellation&) { return trivet::read_model(path, limits); };
  trivet::apps::import_and_exit(argc, argv, read);
}
