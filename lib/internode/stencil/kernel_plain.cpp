// SPDX-License-Identifier: MIT

#define INTERNODE_VECTOR_BYTES 16 // every x86-64 and every ARMv8 has registers of 16 bytes
#include "internode/stencil/kernel_loops.h"
#include "internode/stencil/kernel_sets.h"

namespace internode {

template<>
Kernels<double> plain_kernel(std::size_t width, std::size_t dimension) {
    return of_width<double>(width, dimension);
}

template<>
Kernels<float> plain_kernel(std::size_t width, std::size_t dimension) {
    return of_width<float>(width, dimension);
}

} // namespace internode
