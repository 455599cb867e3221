// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs/quality/bernstein.h"

#include <algorithm>
#include <cmath>
#include <type_traits>
#include <utility>

namespace nmgs {
namespace {

using Barycentric = std::array<double, 4>;
using Powers = std::array<std::size_t, 4>;

// n! / (i! j! k! l!) times the barycentric coordinates to these powers.
double bernstein(const Powers &powers, const Barycentric &at) {
    double value = 1;
    double n = 0;
    for (std::size_t d = 0; d < 4; ++d) {
        for (std::size_t p = 1; p <= powers[d]; ++p) {
            value *= at[d] * ++n / static_cast<double>(p);
        }
    }
    return value;
}

std::vector<Powers> powers_of(std::size_t dimension, std::size_t degree) {
    std::vector<Powers> all;
    for (std::size_t l = 0; l <= (dimension > 2 ? degree : 0); ++l) {
        for (std::size_t k = 0; k + l <= (dimension > 1 ? degree : l); ++k) {
            for (std::size_t j = 0; j + k + l <= degree; ++j) {
                all.push_back({degree - j - k - l, j, k, l});
            }
        }
    }
    return all;
}

Barycentric sample(const Powers &powers, std::size_t degree) {
    Barycentric at{};
    for (std::size_t d = 0; d < 4; ++d) {
        at[d] = static_cast<double>(powers[d]) / static_cast<double>(degree);
    }
    return at;
}

std::vector<double> invert(std::vector<double> a, std::size_t n) {
    std::vector<double> inverse(n * n, 0);
    for (std::size_t i = 0; i < n; ++i) {
        inverse[i * n + i] = 1;
    }
    for (std::size_t c = 0; c < n; ++c) {
        std::size_t pivot = c;
        for (std::size_t r = c + 1; r < n; ++r) {
            pivot = std::abs(a[r * n + c]) > std::abs(a[pivot * n + c]) ? r : pivot;
        }
        for (std::size_t k = 0; k < n; ++k) {
            std::swap(a[c * n + k], a[pivot * n + k]);
            std::swap(inverse[c * n + k], inverse[pivot * n + k]);
        }
        const double scale = 1 / a[c * n + c];
        for (std::size_t k = 0; k < n; ++k) {
            a[c * n + k] *= scale;
            inverse[c * n + k] *= scale;
        }
        for (std::size_t r = 0; r < n; ++r) {
            const double factor = r == c ? 0.0 : a[r * n + c];
            for (std::size_t k = 0; k < n; ++k) {
                a[r * n + k] -= factor * a[c * n + k];
                inverse[r * n + k] -= factor * inverse[c * n + k];
            }
        }
    }
    return inverse;
}

// Corners of the parts: corners of the whole (equal numbers) or the middles between two.
using Part = std::vector<std::array<std::size_t, 2>>;

std::vector<Part> halves_of(std::size_t dimension) {
    switch (dimension) {
    case 1:
        return {{{0, 0}, {0, 1}}, {{0, 1}, {1, 1}}};
    case 2:
        return {{{0, 0}, {0, 1}, {0, 2}},
                {{0, 1}, {1, 1}, {1, 2}},
                {{0, 2}, {1, 2}, {2, 2}},
                {{1, 2}, {0, 2}, {0, 1}}};
    default: // Bey's red refinement, the inner octahedron cut along 02-13
        return {{{0, 0}, {0, 1}, {0, 2}, {0, 3}}, {{0, 1}, {1, 1}, {1, 2}, {1, 3}},
                {{0, 2}, {1, 2}, {2, 2}, {2, 3}}, {{0, 3}, {1, 3}, {2, 3}, {3, 3}},
                {{0, 1}, {0, 2}, {0, 3}, {1, 3}}, {{0, 1}, {0, 2}, {1, 2}, {1, 3}},
                {{0, 2}, {0, 3}, {1, 3}, {2, 3}}, {{0, 2}, {1, 2}, {1, 3}, {2, 3}}};
    }
}

Barycentric in_part(const Part &part, const Barycentric &at) {
    Barycentric result{};
    for (std::size_t c = 0; c < part.size(); ++c) {
        result[part[c][0]] += 0.5 * at[c];
        result[part[c][1]] += 0.5 * at[c];
    }
    return result;
}

// Multiplies all lines of values along the direction of the stride by an n x n matrix.
template <class Count>
void multiply(const std::vector<double> &rows, const std::vector<double> &columns, Count n,
              std::size_t stride, std::span<double> values) {
    std::array<double, 256> result{};
    if (stride == 1 && n < values.size()) {
        // Lines in a row, each a matrix times a vector, column by column.
        for (std::size_t outer = 0; outer < values.size(); outer += n) {
            std::fill_n(result.begin(), n, 0.0);
            for (std::size_t j = 0; j < n; ++j) {
                const double factor = values[outer + j];
                for (std::size_t i = 0; i < n; ++i) {
                    result[i] += columns[j * n + i] * factor;
                }
            }
            std::copy_n(result.begin(), n, values.begin() + static_cast<long>(outer));
        }
        return;
    }
    for (std::size_t outer = 0; outer < values.size(); outer += stride * n) {
        // All lines that start in this slab at once: the inner loop runs over neighbours.
        std::fill_n(result.begin(), stride * n, 0.0);
        for (std::size_t i = 0; i < n; ++i) {
            for (std::size_t j = 0; j < n; ++j) {
                const double factor = rows[i * n + j];
                const double *from = values.data() + outer + j * stride;
                double *to = result.data() + i * stride;
                for (std::size_t s = 0; s < stride; ++s) {
                    to[s] += factor * from[s];
                }
            }
        }
        std::copy_n(result.begin(), stride * n, values.begin() + static_cast<long>(outer));
    }
}

} // namespace

BernsteinBasis BernsteinBasis::simplex(std::size_t dimension, std::size_t degree) {
    const auto powers = powers_of(dimension, degree);
    const std::size_t n = powers.size();
    BernsteinBasis basis;
    basis.count_ = n;
    Matrix values(n * n);
    for (std::size_t i = 0; i < n; ++i) {
        const auto at = sample(powers[i], degree);
        basis.samples_.push_back({at[1], at[2], at[3]});
        if (*std::max_element(powers[i].begin(), powers[i].end()) == degree) {
            basis.corners_.push_back(i);
        }
        for (std::size_t j = 0; j < n; ++j) {
            values[i * n + j] = bernstein(powers[j], at);
        }
    }
    std::vector<Matrix> in_halves;
    for (const Part &part : halves_of(dimension)) {
        Matrix there(n * n);
        for (std::size_t i = 0; i < n; ++i) {
            const auto at = in_part(part, sample(powers[i], degree));
            for (std::size_t j = 0; j < n; ++j) {
                there[i * n + j] = bernstein(powers[j], at);
            }
        }
        in_halves.push_back(std::move(there));
    }
    basis.finish(values, in_halves);
    return basis;
}

BernsteinBasis BernsteinBasis::box(std::size_t directions, std::size_t degree) {
    BernsteinBasis basis = simplex(1, degree);
    const auto line = basis.samples_;
    const std::size_t n = line.size();
    basis.directions_ = directions;
    basis.samples_.clear();
    basis.corners_.clear();
    const std::size_t total = directions == 2 ? n * n : n * n * n;
    for (std::size_t i = 0; i < total; ++i) {
        const std::array<std::size_t, 3> at{i % n, i / n % n, i / n / n};
        std::array<double, 3> natural{};
        bool corner = true;
        for (std::size_t d = 0; d < directions; ++d) {
            natural[d] = line[at[d]][0];
            corner = corner && (at[d] == 0 || at[d] == n - 1);
        }
        basis.samples_.push_back(natural);
        if (corner) {
            basis.corners_.push_back(i);
        }
    }
    return basis;
}

void BernsteinBasis::finish(const Matrix &values_of_basis,
                            const std::vector<Matrix> &values_in_halves) {
    const std::size_t n = count_;
    const Matrix inverse = invert(values_of_basis, n);
    for (const Matrix &values : values_in_halves) {
        Matrix product(n * n, 0);
        for (std::size_t i = 0; i < n; ++i) {
            for (std::size_t k = 0; k < n; ++k) {
                for (std::size_t j = 0; j < n; ++j) {
                    product[i * n + j] += inverse[i * n + k] * values[k * n + j];
                }
            }
        }
        halves_.push_back(operator_of(std::move(product)));
    }
    inverse_ = operator_of(inverse);
}

BernsteinBasis::Operator BernsteinBasis::operator_of(Matrix rows) const {
    const std::size_t n = count_;
    Matrix columns(n * n);
    for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t j = 0; j < n; ++j) {
            columns[j * n + i] = rows[i * n + j];
        }
    }
    return {std::move(rows), std::move(columns)};
}

void BernsteinBasis::apply(const Operator &matrix, std::size_t direction,
                           std::span<double> values) const {
    std::size_t stride = 1;
    for (std::size_t d = 0; d < direction; ++d) {
        stride *= count_;
    }
    // The loops are worth most for the most expensive basis: there the compiler knows their length.
    if (count_ == 6 && directions_ == 3) {
        multiply(matrix.rows, matrix.columns, std::integral_constant<std::size_t, 6>(), stride,
                 values);
    } else {
        multiply(matrix.rows, matrix.columns, count_, stride, values);
    }
}

void BernsteinBasis::to_coefficients(std::span<double> values) const {
    for (std::size_t d = 0; d < directions_; ++d) {
        apply(inverse_, d, values);
    }
}

void BernsteinBasis::restrict_to(std::size_t part, std::size_t depth, std::span<const double> whole,
                                 std::span<double> out) const {
    std::copy(whole.begin(), whole.end(), out.begin());
    apply(halves_[part], depth % directions_, out);
}

} // namespace nmgs
