#include "apps/trivet/program.h"
#include "core/io/process/standard_streams.h"

int main(int argc, char** argv) {
  trivet::open_standard_streams();
  return trivet::apps::run_program(argc, argv);
}
