// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs/quality/hexa20_tangents.h"

#include "nmgs/element/hexa20.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace nmgs::curved {
namespace {

constexpr std::size_t controls = Hexa20Tangents::controls;
constexpr std::size_t nodes_of_cell = 20;
constexpr std::size_t grid = hexa20_grid;

// Coefficients along each coordinate of the tangent in a direction.
constexpr std::array<std::size_t, 3> counts(std::size_t direction) {
    std::array<std::size_t, 3> n{3, 3, 3};
    n[direction] = 2;
    return n;
}

// [direction][node][coefficient]: what a node adds to a coefficient, times its place.
using Table = std::array<std::array<std::array<double, controls>, nodes_of_cell>, 3>;

// Values at 0, 1/2, 1 -> Bernstein coefficients of degree 2, along one coordinate.
void to_quadratic(std::array<double, controls> &values, std::size_t stride) {
    for (std::size_t first = 0; first < controls; ++first) {
        if (first / stride % 3 == 0) {
            double &middle = values[first + stride];
            middle = 2 * middle - 0.5 * (values[first] + values[first + 2 * stride]);
        }
    }
}

Table make_table() {
    Table table{};
    for (std::size_t direction = 0; direction < 3; ++direction) {
        const auto n = counts(direction);
        for (std::size_t c = 0; c < controls; ++c) {
            const std::array<std::size_t, 3> at{c % n[0], c / n[0] % n[1], c / n[0] / n[1]};
            std::array<double, 3> natural{};
            for (std::size_t d = 0; d < 3; ++d) {
                natural[d] = 2.0 * static_cast<double>(at[d]) / static_cast<double>(n[d] - 1) - 1;
            }
            const auto d = hexa20::derivatives(natural[0], natural[1], natural[2]);
            const auto &slopes = direction == 0 ? d.xi : direction == 1 ? d.eta : d.zeta;
            for (std::size_t i = 0; i < nodes_of_cell; ++i) {
                table[direction][i][c] = slopes[i];
            }
        }
        for (auto &values : table[direction]) {
            std::size_t stride = 1;
            for (std::size_t d = 0; d < 3; ++d) {
                if (d != direction) {
                    to_quadratic(values, stride);
                }
                stride *= n[d];
            }
        }
    }
    return table;
}

// Values of the Bernstein polynomials of degree count - 1 at the grid's points:
// [polynomial][point].
template <std::size_t count>
constexpr std::array<std::array<double, grid>, count> basis() {
    std::array<std::array<double, grid>, count> values{};
    for (std::size_t p = 0; p < grid; ++p) {
        const double t = static_cast<double>(p) / (grid - 1);
        if constexpr (count == 2) {
            values[0][p] = 1 - t;
            values[1][p] = t;
        } else {
            values[0][p] = (1 - t) * (1 - t);
            values[1][p] = 2 * t * (1 - t);
            values[2][p] = t * t;
        }
    }
    return values;
}

// One coordinate after the other; the innermost loops run over neighbours in memory.
template <std::size_t n0, std::size_t n1, std::size_t n2>
void expand(const std::array<double, controls> &c, double *out) {
    constexpr auto b0 = basis<n0>();
    constexpr auto b1 = basis<n1>();
    constexpr auto b2 = basis<n2>();
    std::array<double, grid * n1 * n2> first{};
    for (std::size_t line = 0; line < n1 * n2; ++line) {
        for (std::size_t i = 0; i < n0; ++i) {
            for (std::size_t p = 0; p < grid; ++p) {
                first[line * grid + p] += b0[i][p] * c[line * n0 + i];
            }
        }
    }
    std::array<double, grid * grid * n2> second{};
    for (std::size_t k = 0; k < n2; ++k) {
        for (std::size_t j = 0; j < n1; ++j) {
            for (std::size_t q = 0; q < grid; ++q) {
                for (std::size_t p = 0; p < grid; ++p) {
                    second[(k * grid + q) * grid + p] += b1[j][q] * first[(k * n1 + j) * grid + p];
                }
            }
        }
    }
    for (std::size_t r = 0; r < grid; ++r) {
        for (std::size_t s = 0; s < grid * grid; ++s) {
            double sum = 0;
            for (std::size_t k = 0; k < n2; ++k) {
                sum += b2[k][r] * second[k * grid * grid + s];
            }
            out[r * grid * grid + s] = sum;
        }
    }
}

} // namespace

Vec3 Hexa20Tangents::at_corner(std::size_t direction, std::size_t corner) const {
    const auto n = counts(direction);
    const auto at = [&](std::size_t d) { return (corner >> d & 1U) * (n[d] - 1); };
    return control(direction, at(0) + n[0] * (at(1) + n[1] * at(2)));
}

Hexa20Tangents hexa20_tangents(const Vec3 *nodes) {
    static const Table table = make_table();
    Hexa20Tangents tangents{};
    // From the first node: derivatives do not see it, and cells far off lose no digits.
    for (std::size_t direction = 0; direction < 3; ++direction) {
        auto *c = &tangents.coefficients[3 * direction];
        for (std::size_t i = 1; i < nodes_of_cell; ++i) {
            const Vec3 q = nodes[i] - nodes[0];
            const auto &row = table[direction][i];
            for (std::size_t k = 0; k < controls; ++k) {
                c[0][k] += row[k] * q.x;
                c[1][k] += row[k] * q.y;
                c[2][k] += row[k] * q.z;
            }
        }
    }
    return tangents;
}

void sample(const Hexa20Tangents &tangents, std::span<double, 9 * 216> out) {
    for (std::size_t coordinate = 0; coordinate < 3; ++coordinate) {
        expand<2, 3, 3>(tangents.coefficients[coordinate], &out[coordinate * 216]);
        expand<3, 2, 3>(tangents.coefficients[3 + coordinate], &out[(3 + coordinate) * 216]);
        expand<3, 3, 2>(tangents.coefficients[6 + coordinate], &out[(6 + coordinate) * 216]);
    }
}

ScaledJacobianBounds scaled_jacobian_bounds(const Hexa20Tangents &tangents) {
    std::array<Vec3, 3> mean{};
    std::array<double, 3> radius{};
    std::array<double, 3> length{};
    for (std::size_t d = 0; d < 3; ++d) {
        for (std::size_t i = 0; i < controls; ++i) {
            mean[d] += tangents.control(d, i);
        }
        mean[d] = (1.0 / controls) * mean[d];
        for (std::size_t i = 0; i < controls; ++i) {
            radius[d] = std::max(radius[d], norm2(tangents.control(d, i) - mean[d]));
        }
        radius[d] = std::sqrt(radius[d]);
        length[d] = norm(mean[d]);
    }
    // The determinant of mean plus difference, expanded; each term at its worst.
    const auto [ra, rb, rc] = radius;
    const auto [a, b, c] = length;
    const double least = determinant(mean[0], mean[1], mean[2]) -
                         (ra * norm(cross(mean[1], mean[2])) + rb * norm(cross(mean[2], mean[0])) +
                          rc * norm(cross(mean[0], mean[1])) + ra * rb * c + rb * rc * a +
                          rc * ra * b + ra * rb * rc);
    const double longest = (a + ra) * (b + rb) * (c + rc);
    ScaledJacobianBounds bounds{least > 0 && longest > 0 ? least / longest : -1.0,
                                std::numeric_limits<double>::infinity()};
    for (std::size_t corner = 0; corner < 8; ++corner) {
        const Vec3 u = tangents.at_corner(0, corner);
        const Vec3 v = tangents.at_corner(1, corner);
        const Vec3 w = tangents.at_corner(2, corner);
        const double product = norm(u) * norm(v) * norm(w);
        bounds.upper = std::min(bounds.upper, product > 0 ? determinant(u, v, w) / product : 0.0);
    }
    return bounds;
}

} // namespace nmgs::curved
