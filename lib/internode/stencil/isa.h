// SPDX-License-Identifier: MIT
//
// The instruction sets that the kernel (stencil/kernel.h) is compiled for.

#pragma once

namespace internode {

/// Which instructions the kernels may use; the results are the same.
enum class Isa {
    Best,  ///< the widest that this machine has
    Plain, ///< instructions that every machine of this architecture has
    Avx2   ///< AVX2, or plain where the machine has none
};

/// Best resolved: Plain or Avx2.
[[nodiscard]] Isa usable(Isa isa);

} // namespace internode
