#include "apps/trivet/program.h"

int main(int argc, char** argv) { return trivet::apps::run_program(argc, argv); }
