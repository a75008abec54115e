// SPDX-License-Identifier: MIT
//
// The kernels of each instruction set, each in a source compiled for it (kernel.h chooses among them).

#pragma once

#include "internode/stencil/kernel.h"

namespace internode {

template<typename Scalar>
[[nodiscard]] Kernels<Scalar> plain_kernel(std::size_t width, std::size_t dimension);

/// Only where the build has AVX2: INTERNODE_HAS_AVX2.
template<typename Scalar>
[[nodiscard]] Kernels<Scalar> avx2_kernel(std::size_t width, std::size_t dimension);

} // namespace internode
