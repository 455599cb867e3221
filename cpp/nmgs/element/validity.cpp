// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs/element/validity.h"

#include "nmgs/element/hexa20.h"
#include "nmgs/element/quad8.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace nmgs {
namespace {

constexpr double zero = 1e-9;
constexpr int deepest = 8;

template <std::size_t N>
using Matrix = std::array<std::array<double, N>, N>;

// Values at N equally spaced points of [0, 1] -> Bernstein coefficients of degree N - 1, by
// Gauss-Jordan elimination of the collocation matrix, which is totally positive and so needs no
// pivots (de Boor and Pinkus, Backward error analysis for totally positive linear systems, 1977).
template <std::size_t N>
Matrix<N> make_to_bernstein() {
    Matrix<N> a{};
    Matrix<N> inverse{};
    for (std::size_t i = 0; i < N; ++i) {
        const double t = static_cast<double>(i) / (N - 1);
        double binomial = 1;
        for (std::size_t j = 0; j < N; ++j) {
            a[i][j] = binomial * std::pow(t, static_cast<double>(j)) *
                      std::pow(1 - t, static_cast<double>(N - 1 - j));
            binomial = binomial * static_cast<double>(N - 1 - j) / static_cast<double>(j + 1);
        }
        inverse[i][i] = 1;
    }
    for (std::size_t c = 0; c < N; ++c) {
        const double scale = 1 / a[c][c];
        for (std::size_t k = 0; k < N; ++k) {
            a[c][k] *= scale;
            inverse[c][k] *= scale;
        }
        for (std::size_t r = 0; r < N; ++r) {
            const double factor = r == c ? 0.0 : a[r][c];
            for (std::size_t k = 0; k < N; ++k) {
                a[r][k] -= factor * a[c][k];
                inverse[r][k] -= factor * inverse[c][k];
            }
        }
    }
    return inverse;
}

template <std::size_t N>
const Matrix<N> &to_bernstein() {
    static const auto matrix = make_to_bernstein<N>();
    return matrix;
}

// Tensor-product coefficients over a box of natural coordinates; N a direction, D directions.
template <class T, std::size_t N, std::size_t D>
struct Piece {
    static constexpr std::size_t size = D == 2 ? N * N : N * N * N;
    std::array<T, size> c;
    std::array<double, 3> low{-1, -1, D == 3 ? -1.0 : 0.0};
    double width = 2;
    int depth = 0;

    static constexpr std::size_t stride(std::size_t d) { return d == 0 ? 1 : d == 1 ? N : N * N; }
    // Calls f(first) for each line of coefficients along direction d.
    template <class F>
    static void lines(std::size_t d, F f) {
        const std::size_t s = stride(d);
        for (std::size_t outer = 0; outer < size; outer += s * N) {
            for (std::size_t inner = 0; inner < s; ++inner) {
                f(outer + inner);
            }
        }
    }
    void convert() {
        for (std::size_t d = 0; d < D; ++d) {
            const std::size_t s = stride(d);
            lines(d, [this, s](std::size_t first) {
                std::array<T, N> line{};
                T *value = c.data() + first;
                for (std::size_t j = 0; j < N; ++j) {
                    for (std::size_t i = 0; i < N; ++i) {
                        line[i] += to_bernstein<N>()[i][j] * *value;
                    }
                    value += s;
                }
                value = c.data() + first;
                for (std::size_t i = 0; i < N; ++i) {
                    *value = line[i];
                    value += s;
                }
            });
        }
    }
    // De Casteljau's halving along direction d: this becomes the low half, the high one is given.
    Piece halve(std::size_t d) {
        Piece high = *this;
        const std::size_t s = stride(d);
        lines(d, [&](std::size_t first) {
            for (std::size_t level = 1; level < N; ++level) {
                // high holds the shrinking triangle; its first entries pass to the low half.
                for (std::size_t i = 0; i + level < N; ++i) {
                    high.c[first + i * s] =
                        0.5 * (high.c[first + i * s] + high.c[first + (i + 1) * s]);
                }
                c[first + level * s] = high.c[first];
            }
        });
        high.low[d] += 0.5 * width;
        return high;
    }
    [[nodiscard]] std::array<double, 3> middle() const {
        auto m = low;
        for (std::size_t d = 0; d < D; ++d) {
            m[d] += 0.5 * width;
        }
        return m;
    }
    // The 2^D corner coefficients are values of the polynomial itself.
    template <class F>
    void corners(F f) const {
        for (std::size_t corner = 0; corner < (std::size_t{1} << D); ++corner) {
            std::size_t at = 0;
            auto natural = low;
            for (std::size_t d = 0; d < D; ++d) {
                if ((corner >> d & 1U) != 0) {
                    at += (N - 1) * stride(d);
                    natural[d] += width;
                }
            }
            f(c[at], natural);
        }
    }
    // Halves in all directions.
    void split(std::vector<Piece> &out) const {
        std::vector<Piece> parts{*this};
        for (std::size_t d = 0; d < D; ++d) {
            const std::size_t count = parts.size();
            for (std::size_t i = 0; i < count; ++i) {
                const Piece high = parts[i].halve(d);
                parts.push_back(high);
            }
        }
        for (Piece &part : parts) {
            part.width *= 0.5;
            ++part.depth;
            out.push_back(part);
        }
    }
};

using Hexa = Piece<double, 6, 3>;
using Patch = Piece<Vec3, 4, 2>;

// Value at the corner where the piece is least.
std::pair<double, std::array<double, 3>> least_corner(const Hexa &piece) {
    std::pair<double, std::array<double, 3>> best{INFINITY, {}};
    piece.corners([&](double value, const std::array<double, 3> &natural) {
        if (value < best.first) {
            best = {value, natural};
        }
    });
    return best;
}

} // namespace

ValidityResult check_validity(std::span<const Vec3, 20> nodes) {
    Hexa whole;
    for (std::size_t i = 0; i < Hexa::size; ++i) {
        const auto at = [&](std::size_t d) {
            return -1 + 0.4 * static_cast<double>(i / Hexa::stride(d) % 6);
        };
        whole.c[i] = hexa20::jacobian(nodes, at(0), at(1), at(2));
    }
    whole.convert();
    double scale = 0;
    bool any_positive = false;
    for (const double c : whole.c) {
        scale = std::max(scale, std::abs(c));
    }
    const double limit = zero * scale;
    if (!(scale > 0)) {
        return {Validity::collapsed, {0, 0, 0}};
    }
    whole.corners([&](double v, const auto &) { any_positive = any_positive || v > limit; });
    if (std::all_of(whole.c.begin(), whole.c.end(), [&](double c) { return c < -limit; })) {
        return {Validity::mirrored, {0, 0, 0}};
    }
    ValidityResult result{Validity::valid, {0, 0, 0}};
    std::vector<Hexa> stack{whole};
    std::size_t visited = 0;
    while (!stack.empty()) {
        const Hexa piece = stack.back();
        stack.pop_back();
        if (std::all_of(piece.c.begin(), piece.c.end(), [&](double c) { return c > limit; })) {
            continue;
        }
        const auto [value, natural] = least_corner(piece);
        if (value < -limit) {
            return {Validity::folded, natural};
        }
        const bool zero_here = value <= limit;
        if (zero_here && result.validity == Validity::valid) {
            result = {Validity::collapsed, natural};
        }
        // No coefficient is negative: the piece is at worst collapsed.
        const bool never_negative =
            std::all_of(piece.c.begin(), piece.c.end(), [&](double c) { return c >= -limit; });
        if (zero_here && never_negative) {
            continue;
        }
        if (piece.depth >= deepest || ++visited > 4000) {
            // Nearer to zero than halving can tell.
            if (result.validity == Validity::valid) {
                result = {Validity::collapsed, piece.middle()};
            }
            continue;
        }
        piece.split(stack);
    }
    // A block turned inside out as a whole but for a spot is folded.
    if (result.validity == Validity::collapsed && !any_positive) {
        bool all_negative = true;
        whole.corners([&](double v, const auto &) { all_negative = all_negative && v <= limit; });
        if (all_negative && hexa20::jacobian(nodes, 0, 0, 0) < -limit) {
            result.validity = Validity::folded;
        }
    }
    return result;
}

ValidityResult check_validity(std::span<const Vec3, 8> nodes) {
    Patch whole;
    double scale = 0;
    for (std::size_t i = 0; i < Patch::size; ++i) {
        const auto at = [&](std::size_t d) {
            return -1 + 2.0 / 3 * static_cast<double>(i / Patch::stride(d) % 4);
        };
        const auto t = quad8::tangents(nodes, at(0), at(1));
        whole.c[i] = cross(t.xi, t.eta);
    }
    whole.convert();
    for (const Vec3 c : whole.c) {
        scale = std::max(scale, norm(c));
    }
    if (!(scale > 0)) {
        return {Validity::collapsed, {0, 0, 0}};
    }
    const double limit = zero * scale;
    ValidityResult result{Validity::valid, {0, 0, 0}};
    std::vector<Patch> stack{whole};
    while (!stack.empty()) {
        const Patch piece = stack.back();
        stack.pop_back();
        Vec3 sum{0, 0, 0};
        for (const Vec3 c : piece.c) {
            sum += c;
        }
        const double length = norm(sum);
        const Vec3 mean = length > 0 ? (1 / length) * sum : Vec3{0, 0, 0};
        double least = INFINITY;
        double backward = 0;
        for (const Vec3 c : piece.c) {
            least = std::min(least, dot(c, mean));
            backward = std::min(backward, dot(c, mean));
        }
        if (length > 0 && least > limit) {
            continue;
        }
        double smallest = INFINITY;
        std::array<double, 3> natural{};
        piece.corners([&](Vec3 value, const std::array<double, 3> &at) {
            if (norm(value) < smallest) {
                smallest = norm(value);
                natural = at;
            }
        });
        if (smallest <= limit && backward >= -limit) {
            if (result.validity == Validity::valid) {
                result = {Validity::collapsed, natural};
            }
            continue;
        }
        if (piece.depth >= deepest) {
            return {Validity::folded, piece.middle()};
        }
        piece.split(stack);
    }
    return result;
}

} // namespace nmgs
