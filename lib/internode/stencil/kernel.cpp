// SPDX-License-Identifier: MIT

#include "internode/stencil/kernel.h"

#include "internode/stencil/kernel_sets.h"

#include <stdexcept>

namespace internode {
namespace {

bool machine_has_avx2() {
#if defined(INTERNODE_HAS_AVX2)
    return __builtin_cpu_supports("avx2") != 0;
#else
    return false;
#endif
}

} // namespace

Isa usable(Isa isa) {
    return isa != Isa::Plain && machine_has_avx2() ? Isa::Avx2 : Isa::Plain;
}

template<typename Scalar>
Kernel<Scalar> kernel(Isa isa, std::size_t width, std::size_t dimension) {
    Kernel<Scalar> chosen = nullptr;
#if defined(INTERNODE_HAS_AVX2)
    if (usable(isa) == Isa::Avx2) chosen = avx2_kernel<Scalar>(width, dimension);
#else
    (void)isa;
#endif
    if (chosen == nullptr) chosen = plain_kernel<Scalar>(width, dimension);
    if (chosen == nullptr) throw std::invalid_argument("stencils have 2 to 13 weights");
    return chosen;
}

template Kernel<double> kernel(Isa isa, std::size_t width, std::size_t dimension);
template Kernel<float> kernel(Isa isa, std::size_t width, std::size_t dimension);

} // namespace internode
