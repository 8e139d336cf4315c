#include "apps/trivet/program.h"
#include "core/io/process/freed_memory.h"
#include "core/io/process/standard_streams.h"

int main(int argc, char** argv) {
  trivet::open_standard_streams();
  trivet::keep_freed_memory();
  return trivet::apps::run_program(argc, argv);
}
