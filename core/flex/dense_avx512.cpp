// Compiled for processors with AVX-512: see CMakeLists.txt.
#ifdef TRIVET_WIDE_KERNELS
#include "core/flex/dense_tiles.h"

namespace trivet::flex {

using Double8 = double __attribute__((vector_size(64)));
constinit const DenseKernels kKernelsOfEight = DenseTiles<Double8>::kernels();

}  // namespace trivet::flex
#endif
