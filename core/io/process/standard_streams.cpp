#include "core/io/process/standard_streams.h"

#include <fcntl.h>
#include <unistd.h>

#include <cstdlib>

namespace trivet {

void open_standard_streams() {
  for (int descriptor = 0; descriptor <= 2; ++descriptor) {
    if (fcntl(descriptor, F_GETFD) >= 0) continue;
    // The lowest number that is free is this one. Nobody reads messages on standard error; that
    // results are lost must not go unnoticed: the standard output can be read, not written.
    if (open("/dev/null", descriptor == 2 ? O_WRONLY : O_RDONLY) != descriptor) std::abort();
  }
}

}  // namespace trivet
