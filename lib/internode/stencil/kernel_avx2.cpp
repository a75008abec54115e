// SPDX-License-Identifier: MIT

#define INTERNODE_VECTOR_BYTES 32
#include "internode/stencil/kernel_loops.h"
#include "internode/stencil/kernel_sets.h"

namespace internode {

template<>
Kernels<double> avx2_kernel(std::size_t width, std::size_t dimension) {
    return of_width<double>(width, dimension);
}

template<>
Kernels<float> avx2_kernel(std::size_t width, std::size_t dimension) {
    return of_width<float>(width, dimension);
}

} // namespace internode
