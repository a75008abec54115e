// SPDX-License-Identifier: MIT

#include "bench/peers/sisl.h"

#include <sisl.h>

#include <stdexcept>

namespace internode::bench {

struct SislRefinement::Impl {
    std::vector<double> knots;
    std::vector<double> points;
    std::vector<double> inserted;
    SISLCurve* coarse = nullptr;
    SISLCurve* fine = nullptr;
};

SislRefinement::SislRefinement(std::vector<double> knots, std::vector<double> points, std::vector<double> inserted)
    : impl_(std::make_unique<Impl>(Impl{std::move(knots), std::move(points), std::move(inserted)})) {
    const int polynomial = 1;
    const int borrow = 0;
    impl_->coarse = newCurve(static_cast<int>(impl_->points.size() / 3), 4, impl_->knots.data(), impl_->points.data(),
                             polynomial, 3, borrow);
    if (impl_->coarse == nullptr) throw std::runtime_error("SISL makes no curve");
}

SislRefinement::~SislRefinement() {
    release();
    freeCurve(impl_->coarse);
}

std::span<const double> SislRefinement::refine() {
    release();
    int status = 0;
    s1018(impl_->coarse, impl_->inserted.data(), static_cast<int>(impl_->inserted.size()), &impl_->fine, &status);
    if (status < 0 || impl_->fine == nullptr) throw std::runtime_error("SISL refuses to insert the knots");
    return {impl_->fine->ecoef, 3 * static_cast<std::size_t>(impl_->fine->in)};
}

void SislRefinement::release() {
    if (impl_->fine != nullptr) freeCurve(impl_->fine);
    impl_->fine = nullptr;
}

} // namespace internode::bench
