// trivet-import-cad: the same for STEP, IGES and BREP. A separate program, as loading Open CASCADE
// takes longer than reading most models.
#include "apps/import/importer.h"
#include "core/io/cad/model.h"

int main(int argc, char** argv) {
  trivet::apps::import_and_exit(argc, argv, trivet::read_cad_model);
}
