// SPDX-License-Identifier: MIT

#include "internode/stencil/kernel.h"

#include "internode/stencil/kernel_sets.h"

#include <stdexcept>

namespace internode {

Isa usable([[maybe_unused]] Isa isa) {
#if defined(INTERNODE_HAS_AVX2)
    if (isa != Isa::Plain && __builtin_cpu_supports("avx2") != 0) return Isa::Avx2;
#endif
    return Isa::Plain;
}

template<typename Scalar>
Kernels<Scalar> kernels(Isa isa, std::size_t width, std::size_t dimension) {
    Kernels<Scalar> chosen;
#if defined(INTERNODE_HAS_AVX2)
    if (usable(isa) == Isa::Avx2) chosen = avx2_kernel<Scalar>(width, dimension);
#else
    (void)isa;
#endif
    if (chosen.direct == nullptr) chosen = plain_kernel<Scalar>(width, dimension);
    if (chosen.direct == nullptr) throw std::invalid_argument("stencils have 2 to 13 weights");
    return chosen;
}

template Kernels<double> kernels(Isa isa, std::size_t width, std::size_t dimension);
template Kernels<float> kernels(Isa isa, std::size_t width, std::size_t dimension);

} // namespace internode
