// Compiled for processors with AVX2: see CMakeLists.txt.
#ifdef TRIVET_WIDE_KERNELS
#include "core/flex/dense_tiles.h"

namespace trivet::flex {

using Double4 = double __attribute__((vector_size(32)));
constinit const DenseKernels kKernelsOfFour = DenseTiles<Double4>::kernels();

}  // namespace trivet::flex
#endif
