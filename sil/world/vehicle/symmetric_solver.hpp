// Symmetric solver: a positive definite system of six equations, unrolled; it is solved in every step.
#pragma once

#include <array>

#include "sil/world/vehicle/vector.hpp"

namespace sil {

// Lower triangle only: row >= column.
template <typename Real>
class SymmetricMatrix6 {
 public:
    Real& operator()(int row, int column) { return entries_[index(row, column)]; }
    const Real& operator()(int row, int column) const { return entries_[index(row, column)]; }

    // Less a b^T, which must be symmetric in sum with what else is subtracted.
    void subtract_product(const Vector6Of<Real>& a, const Vector6Of<Real>& b) {
#pragma GCC unroll 6
        for (int row = 0; row < 6; ++row) {
#pragma GCC unroll 6
            for (int column = 0; column <= row; ++column) {
                (*this)(row, column) -= a[row] * b[column];
            }
        }
    }

 private:
    static constexpr std::size_t index(int row, int column) {
        return static_cast<std::size_t>(row * (row + 1) / 2 + column);
    }
    std::array<Real, 21> entries_{};
};

// Square-root-free Cholesky factorisation L D L^T.
template <typename Real>
Vector6Of<Real> solve_positive_definite(SymmetricMatrix6<Real> matrix, Vector6Of<Real> x) {
    std::array<Real, 6> inverse_pivot;
#pragma GCC unroll 6
    for (int k = 0; k < 6; ++k) {
        inverse_pivot[static_cast<std::size_t>(k)] = 1.0 / matrix(k, k);
#pragma GCC unroll 6
        for (int row = k + 1; row < 6; ++row) {
            const Real factor = matrix(row, k) * inverse_pivot[static_cast<std::size_t>(k)];
#pragma GCC unroll 6
            for (int column = row; column < 6; ++column) {
                matrix(column, row) -= factor * matrix(column, k);
            }
            x[row] -= factor * x[k];
        }
    }
#pragma GCC unroll 6
    for (int k = 5; k >= 0; --k) {
#pragma GCC unroll 6
        for (int row = k + 1; row < 6; ++row) {
            x[k] -= matrix(row, k) * x[row];
        }
        x[k] *= inverse_pivot[static_cast<std::size_t>(k)];
    }
    return x;
}

}  // namespace sil
