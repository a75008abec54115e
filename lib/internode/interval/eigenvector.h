// SPDX-License-Identifier: MIT
//
// Exact eigenvectors in K = Q(ρ) without elimination over K.
//
// Let χ be the characteristic polynomial of a c x c block M and p the minimal polynomial of ρ, degree k. Then
// adj(ρI − M) = Σ_t ρ^t u_t where u_{c-1} = I, u_{t-1} = χ_t I + M u_t: integer matrix–vector products by Horner. An
// irreducible block with spectral radius ρ has χ = p h, and a = q(M) h(M) 1, q(x) = p(x) / (x − ρ), is its positive
// eigenvector. It again takes integer products only: the coefficient of ρ^t in a is u_t, with h(M) 1 for I and p for χ.

#pragma once

#include "internode/algebra/perron.h"

#include <vector>

namespace internode {

/// The positive right eigenvector of an irreducible block whose spectral radius generates `field`, some scale.
/// Cost: a characteristic polynomial and c products of the block with an integer vector.
[[nodiscard]] std::vector<Number> perron_vector(const SparseMatrix& block, const NumberField& field);

/// (ρI − M)^{-1} b, where ρ generates `field` and is larger than the block's own spectral radius, b in K.
/// Cost: a characteristic polynomial and c k products.
[[nodiscard]] std::vector<Number> resolvent(const SparseMatrix& block, const NumberField& field,
                                            const std::vector<Number>& b);

} // namespace internode
