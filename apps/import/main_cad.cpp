// trivet-import-cad: the same for STEP, IGES and BREP. A program of its own, as loading Open
// CASCADE takes longer than most models.
#include "apps/import/importer.h"
#include "core/io/cad/cad_model.h"

int main(int argc, char** argv) {
  trivet::apps::import_and_exit(argc, argv, trivet::read_cad_model);
}
