// Standard streams that the caller of a program has closed.
#pragma once

namespace trivet {

/// Opens those of the descriptors 0 to 2 that are closed on /dev/null, so that no file that is
/// opened later becomes one of them: a journal in place of the standard output would get the
/// answers. What is written to such a standard output still fails, as it did. To be called first of
/// all in main().
void open_standard_streams();

}  // namespace trivet
