// SPDX-License-Identifier: MIT

#include "bench/peers/sparse.h"

#include <Eigen/SparseCore>

namespace internode::bench {

struct SparseRefinement::Impl {
    Eigen::SparseMatrix<double, Eigen::RowMajor> matrix;
};

SparseRefinement::SparseRefinement(const CubicRows& rows, std::size_t coarse_count)
    : impl_(std::make_unique<Impl>()) {
    const auto count = static_cast<Eigen::Index>(rows.first.size());
    impl_->matrix.resize(count, static_cast<Eigen::Index>(coarse_count));
    impl_->matrix.reserve(Eigen::VectorXi::Constant(count, 4));
    for (std::size_t j = 0; j < rows.first.size(); ++j)
        for (std::size_t k = 0; k < 4; ++k)
            impl_->matrix.insert(static_cast<Eigen::Index>(j), static_cast<Eigen::Index>(rows.first[j] + k)) =
                rows.weights[4 * j + k];
    impl_->matrix.makeCompressed();
}

SparseRefinement::~SparseRefinement() = default;

void SparseRefinement::apply(std::span<const double> points, std::span<double> out) const {
    using Rows = Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>;
    const Eigen::Map<const Rows> coarse(points.data(), impl_->matrix.cols(), 3);
    Eigen::Map<Rows> fine(out.data(), impl_->matrix.rows(), 3);
    fine.noalias() = impl_->matrix * coarse;
}

} // namespace internode::bench
