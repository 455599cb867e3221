// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs/quality/curved_metrics.h"

#include "nmgs/element/hexa20.h"
#include "nmgs/element/quad8.h"
#include "nmgs/mesh/cell_topology.h"
#include "nmgs/quality/bernstein.h"
#include "nmgs/quality/hexa20_tangents.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <queue>
#include <span>
#include <utility>
#include <vector>

namespace nmgs::curved {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

using Gradient = std::array<double, 3>;

// Derivatives of the shape functions of a quadratic simplex (Lagrange), by r, s, t.
std::vector<Gradient> simplex_gradients(CellType type, const Gradient &at) {
    const std::size_t corners = type == CellType::triangle6 ? 3 : 4;
    const std::array<double, 4> l{1 - at[0] - at[1] - at[2], at[0], at[1], at[2]};
    const auto slope = [](std::size_t i, std::size_t d) {
        return i == 0 ? -1.0 : i == d + 1 ? 1.0 : 0.0;
    };
    std::vector<Gradient> g(static_cast<std::size_t>(node_count(type)));
    for (std::size_t d = 0; d < corners - 1; ++d) {
        for (std::size_t i = 0; i < corners; ++i) {
            g[i][d] = (4 * l[i] - 1) * slope(i, d);
        }
        for (const LocalEdge &edge : edges(type)) {
            const auto a = static_cast<std::size_t>(edge.a);
            const auto b = static_cast<std::size_t>(edge.b);
            g[static_cast<std::size_t>(edge.mid)][d] =
                4 * (slope(a, d) * l[b] + l[a] * slope(b, d));
        }
    }
    return g;
}

// Derivatives by natural coordinates; `at` in [0, 1] also for quads and hexahedra.
std::vector<Gradient> gradients(CellType type, const Gradient &at) {
    std::vector<Gradient> g(static_cast<std::size_t>(node_count(type)));
    if (type == CellType::quad8) {
        const auto d = quad8::derivatives(2 * at[0] - 1, 2 * at[1] - 1);
        for (std::size_t i = 0; i < g.size(); ++i) {
            g[i] = {d.xi[i], d.eta[i], 0};
        }
        return g;
    }
    if (type == CellType::hexahedron20) {
        const auto d = hexa20::derivatives(2 * at[0] - 1, 2 * at[1] - 1, 2 * at[2] - 1);
        for (std::size_t i = 0; i < g.size(); ++i) {
            g[i] = {d.xi[i], d.eta[i], d.zeta[i]};
        }
        return g;
    }
    return simplex_gradients(type, at);
}

// What the metrics need to know of a type.
struct Kind {
    CellType type;
    BernsteinBasis basis;
    double reference;                               // volume or area of the reference cell
    double factor;                                  // Verdict's, of the scaled Jacobian
    std::vector<std::array<int, 3>> directions;     // combinations of the tangents
    std::vector<std::vector<std::size_t>> products; // of lengths along these; the largest counts
    std::vector<double> table;                      // [direction][node][sample] of gradients

    Kind(CellType t, BernsteinBasis b, double r, double f, std::vector<std::array<int, 3>> d,
         std::vector<std::vector<std::size_t>> p)
        : type(t), basis(std::move(b)), reference(r), factor(f), directions(std::move(d)),
          products(std::move(p)) {
        const auto k = static_cast<std::size_t>(node_count(type));
        const std::size_t n = basis.size();
        table.resize(3 * k * n);
        for (std::size_t s = 0; s < n; ++s) {
            const auto g = gradients(type, basis.samples()[s]);
            for (std::size_t i = 0; i < k; ++i) {
                for (std::size_t dir = 0; dir < 3; ++dir) {
                    table[(dir * k + i) * n + s] = g[i][dir];
                }
            }
        }
    }
    [[nodiscard]] std::size_t dimension() const {
        return static_cast<std::size_t>(nmgs::dimension(type));
    }
};

const Kind &kind_of(CellType type) {
    static const Kind triangle(CellType::triangle6, BernsteinBasis::simplex(2, 2), 0.5,
                               2 / std::numbers::sqrt3, {{1, 0, 0}, {0, 1, 0}, {-1, 1, 0}},
                               {{0, 1}, {0, 2}, {1, 2}});
    static const Kind quad(CellType::quad8, BernsteinBasis::box(2, 4), 4, 1, {{1, 0, 0}, {0, 1, 0}},
                           {{0, 1}});
    static const Kind tetra(CellType::tetra10, BernsteinBasis::simplex(3, 3), 1.0 / 6,
                            std::numbers::sqrt2,
                            {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {-1, 1, 0}, {-1, 0, 1}, {0, -1, 1}},
                            {{0, 1, 2}, {0, 3, 4}, {1, 3, 5}, {2, 4, 5}});
    static const Kind hexahedron(CellType::hexahedron20, BernsteinBasis::box(3, 5), 8, 1,
                                 {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 1, 2}});
    switch (type) {
    case CellType::triangle6:
        return triangle;
    case CellType::quad8:
        return quad;
    case CellType::tetra10:
        return tetra;
    default:
        return hexahedron;
    }
}

// The tangents of a cell at all samples: [direction][coordinate][sample].
std::vector<double> tangents(const Kind &kind, const Vec3 *p) {
    const std::size_t n = kind.basis.size();
    const auto k = static_cast<std::size_t>(node_count(kind.type));
    std::vector<double> t(9 * n, 0.0);
    if (kind.type == CellType::hexahedron20) { // 216 samples: a quicker way to the same values
        sample(hexa20_tangents(p), std::span<double, std::size_t{9} * 216>(t));
        return t;
    }
    for (std::size_t dir = 0; dir < kind.dimension(); ++dir) {
        for (std::size_t i = 0; i < k; ++i) {
            // From the first node: derivatives do not see it, and cells far off lose no digits.
            const Vec3 q = p[i] - p[0];
            const double *g = kind.table.data() + (dir * k + i) * n;
            double *x = t.data() + 3 * dir * n;
            for (std::size_t s = 0; s < n; ++s) {
                x[s] += g[s] * q.x;
                x[n + s] += g[s] * q.y;
                x[2 * n + s] += g[s] * q.z;
            }
        }
    }
    return t;
}

Vec3 tangent(const std::vector<double> &t, std::size_t n, std::size_t direction, std::size_t s) {
    const double *x = t.data() + 3 * direction * n + s;
    return {x[0], x[n], x[2 * n]};
}

// Coefficients of the Jacobian.
std::vector<double> jacobian(const Kind &kind, const std::vector<double> &t) {
    const std::size_t n = kind.basis.size();
    std::vector<double> j(n);
    if (kind.dimension() == 3) {
        for (std::size_t s = 0; s < n; ++s) {
            j[s] = determinant(tangent(t, n, 0, s), tangent(t, n, 1, s), tangent(t, n, 2, s));
        }
        kind.basis.to_coefficients(j);
        return j;
    }
    std::array<std::vector<double>, 3> normal{std::vector<double>(n), std::vector<double>(n),
                                              std::vector<double>(n)};
    for (std::size_t s = 0; s < n; ++s) {
        const Vec3 c = cross(tangent(t, n, 0, s), tangent(t, n, 1, s));
        normal[0][s] = c.x;
        normal[1][s] = c.y;
        normal[2][s] = c.z;
    }
    // The mean of Bernstein coefficients is the mean of the polynomial.
    Vec3 mean{0, 0, 0};
    for (auto &component : normal) {
        kind.basis.to_coefficients(component);
    }
    for (std::size_t s = 0; s < n; ++s) {
        mean += Vec3{normal[0][s], normal[1][s], normal[2][s]};
    }
    const double length = norm(mean);
    mean = length > 0 ? (1 / length) * mean : Vec3{0, 0, 0};
    for (std::size_t s = 0; s < n; ++s) {
        j[s] = dot(mean, {normal[0][s], normal[1][s], normal[2][s]});
    }
    return j;
}

// Coefficients of the squared lengths along a direction.
std::vector<double> length2(const Kind &kind, const std::vector<double> &t,
                            const std::array<int, 3> &direction) {
    const std::size_t n = kind.basis.size();
    std::vector<double> values(n, 0.0);
    std::array<double, 216> sum{};
    for (std::size_t coordinate = 0; coordinate < 3; ++coordinate) {
        std::fill_n(sum.begin(), n, 0.0);
        for (std::size_t d = 0; d < 3; ++d) {
            const double factor = direction[d];
            const double *x = t.data() + (3 * d + coordinate) * n;
            for (std::size_t s = 0; factor != 0 && s < n; ++s) {
                sum[s] += factor * x[s];
            }
        }
        for (std::size_t s = 0; s < n; ++s) {
            values[s] += sum[s] * sum[s];
        }
    }
    kind.basis.to_coefficients(values);
    return values;
}

// The polynomials over one part of a cell.
struct Piece {
    std::vector<double> jacobian;
    std::vector<std::vector<double>> lengths2; // none where only the Jacobian is looked for
    std::size_t depth = 0;
};

Piece part_of(const Kind &kind, const Piece &whole, std::size_t part) {
    Piece result{std::vector<double>(whole.jacobian.size()), whole.lengths2, whole.depth + 1};
    kind.basis.restrict_to(part, whole.depth, whole.jacobian, result.jacobian);
    for (std::size_t d = 0; d < whole.lengths2.size(); ++d) {
        kind.basis.restrict_to(part, whole.depth, whole.lengths2[d], result.lengths2[d]);
    }
    return result;
}

// Largest of the products of lengths, given the squares.
double largest_product(const Kind &kind, const std::vector<double> &squares) {
    double most = 0;
    for (const auto &product : kind.products) {
        double value = 1;
        for (const std::size_t d : product) {
            value *= std::max(0.0, squares[d]);
        }
        most = std::max(most, value);
    }
    return std::sqrt(most);
}

// A number that the quotient of the Jacobian and the product of these lengths does not fall below
// in the piece, where all coefficients of the Jacobian are positive. Each squared length is divided
// by its mean; the product of the roots is at most the power of the arithmetic mean m of what is
// left, and that at most a polynomial P: m itself for two lengths, for three the chord of m^(3/2)
// over the range of m. Then J - q P has no negative coefficient for q the least quotient of theirs:
// J and P are compared where they are, not the least of one with the largest of the other.
double least_quotient(const Piece &piece, const std::vector<std::size_t> &product) {
    const std::size_t n = piece.jacobian.size();
    std::array<double, 3> weight{};
    double scale = 1;
    for (std::size_t d = 0; d < product.size(); ++d) {
        double mean = 0;
        for (const double c : piece.lengths2[product[d]]) {
            mean += c;
        }
        mean /= static_cast<double>(n);
        if (!(mean > 0)) {
            return 0;
        }
        weight[d] = 1 / (mean * static_cast<double>(product.size()));
        scale *= std::sqrt(mean);
    }
    std::array<double, 216> m{};
    double low = infinity;
    double high = 0;
    for (std::size_t c = 0; c < n; ++c) {
        for (std::size_t d = 0; d < product.size(); ++d) {
            m[c] += weight[d] * piece.lengths2[product[d]][c];
        }
        low = std::min(low, m[c]);
        high = std::max(high, m[c]);
    }
    if (!(low > 0)) {
        return 0;
    }
    double start = 0; // of the chord, and its slope
    double slope = 1;
    if (product.size() == 3) {
        const double at_low = low * std::sqrt(low);
        slope = high > low * (1 + 1e-9) ? (high * std::sqrt(high) - at_low) / (high - low)
                                        : 1.5 * std::sqrt(high) + 1e-6;
        start = at_low - slope * low;
    }
    double least = infinity;
    for (std::size_t c = 0; c < n; ++c) {
        least = std::min(least, piece.jacobian[c] / (scale * (start + slope * m[c])));
    }
    return std::max(0.0, least);
}

// A value that the metric does not fall below in the piece.
double lower_bound(const Kind &kind, const Piece &piece) {
    const double least = *std::min_element(piece.jacobian.begin(), piece.jacobian.end());
    if (piece.lengths2.empty()) {
        return least;
    }
    std::vector<double> squares;
    for (const auto &lengths : piece.lengths2) {
        squares.push_back(least > 0 ? *std::max_element(lengths.begin(), lengths.end())
                                    : *std::min_element(lengths.begin(), lengths.end()));
    }
    if (least > 0) {
        double quotient = infinity;
        for (const auto &product : kind.products) {
            quotient = std::min(quotient, least_quotient(piece, product));
        }
        return kind.factor * std::max(quotient, least / largest_product(kind, squares));
    }
    const double product = largest_product(kind, squares);
    // |J| is at most the product of the lengths (Hadamard).
    return kind.factor * (product > 0 ? std::max(-1.0, least / product) : least < 0 ? -1.0 : 0.0);
}

// The least value that the metric takes at a corner of the piece.
double least_value(const Kind &kind, const Piece &piece) {
    double least = infinity;
    for (const std::size_t c : kind.basis.corners()) {
        double value = piece.jacobian[c];
        if (!piece.lengths2.empty()) {
            std::vector<double> squares;
            for (const auto &lengths : piece.lengths2) {
                squares.push_back(lengths[c]);
            }
            const double product = largest_product(kind, squares);
            value = product > 0 ? kind.factor * value / product : 0;
        }
        least = std::min(least, value);
    }
    return least;
}

// A bound below the metric over the whole cell, within the tolerance of its minimum; where the
// number of pieces runs out, as on the edge of a fold, it is still a bound.
double bound_below(const Kind &kind, Piece whole, double absolute, double relative = 0) {
    constexpr std::size_t most_pieces = 1000;
    constexpr std::size_t most_of_folded = 64; // a cell that is unusable anyway
    double taken = least_value(kind, whole);   // the minimum is not above
    double lower = lower_bound(kind, whole);
    const auto close = [&](double bound) {
        return bound >= taken - absolute - relative * std::max(0.0, taken);
    };
    if (close(lower)) {
        return lower;
    }
    // The piece with the lowest bound first: only it keeps the whole bound down.
    std::vector<Piece> pieces{std::move(whole)};
    using Entry = std::pair<double, std::size_t>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
    open.emplace(lower, 0);
    while (!close(open.top().first) && pieces.size() < (taken < 0 ? most_of_folded : most_pieces)) {
        const std::size_t at = open.top().second;
        open.pop();
        const Piece piece = std::move(pieces[at]);
        for (std::size_t part = 0; part < kind.basis.parts(); ++part) {
            const std::size_t place = part == 0 ? at : pieces.size();
            Piece child = part_of(kind, piece, part);
            taken = std::min(taken, least_value(kind, child));
            open.emplace(lower_bound(kind, child), place);
            if (part == 0) {
                pieces[at] = std::move(child);
            } else {
                pieces.push_back(std::move(child));
            }
        }
    }
    return open.top().first;
}

constexpr std::array<double, 6> gauss_points{0.03376524289842398, 0.16939530676686776,
                                             0.38069040695840156, 0.6193095930415985,
                                             0.8306046932331322,  0.9662347571015760};
constexpr std::array<double, 6> gauss_weights{0.08566224618958517, 0.18038078652406930,
                                              0.23395696728634552, 0.23395696728634552,
                                              0.18038078652406930, 0.08566224618958517};

double largest(const std::vector<double> &values) {
    double most = 0;
    for (const double v : values) {
        most = std::max(most, std::abs(v));
    }
    return most;
}

} // namespace

bool has_metrics(CellType type) {
    return type == CellType::triangle6 || type == CellType::quad8 || type == CellType::tetra10 ||
           type == CellType::hexahedron20;
}

double min_jacobian(CellType type, const Vec3 *p) {
    const Kind &kind = kind_of(type);
    Piece piece{jacobian(kind, tangents(kind, p)), {}, 0};
    const double tolerance = 1e-3 * largest(piece.jacobian);
    return kind.reference * bound_below(kind, std::move(piece), tolerance);
}

double jacobian_ratio(CellType type, const Vec3 *p) {
    const Kind &kind = kind_of(type);
    Piece piece{jacobian(kind, tangents(kind, p)), {}, 0};
    const double tolerance = 1e-3 * largest(piece.jacobian);
    Piece negative = piece;
    for (double &v : negative.jacobian) {
        v = -v;
    }
    const double least = bound_below(kind, std::move(piece), tolerance);
    const double most = -bound_below(kind, std::move(negative), tolerance);
    // The quotient of a negative one is on the safe side with the largest Jacobian's other bound. A
    // cell that is inside out everywhere has no positive Jacobian to compare with.
    const double divisor = least > 0 ? most : most - tolerance;
    return divisor > 0 ? least / divisor : -infinity;
}

double scaled_jacobian(CellType type, const Vec3 *p) {
    const Kind &kind = kind_of(type);
    constexpr double absolute = 0.01;
    constexpr double relative = 0.05;
    if (type == CellType::hexahedron20) {
        const auto [lower, upper] = scaled_jacobian_bounds(hexa20_tangents(p));
        if (lower > 0 && lower >= upper - absolute - relative * upper) {
            return lower;
        }
    }
    const auto t = tangents(kind, p);
    Piece piece{jacobian(kind, t), {}, 0};
    for (const auto &direction : kind.directions) {
        piece.lengths2.push_back(length2(kind, t, direction));
    }
    return bound_below(kind, std::move(piece), absolute, relative);
}

double volume(CellType type, const Vec3 *p) {
    const Kind &kind = kind_of(type);
    const auto j = jacobian(kind, tangents(kind, p));
    double sum = 0;
    for (const double c : j) {
        sum += c;
    }
    return kind.reference * sum / static_cast<double>(j.size());
}

double area(CellType type, const Vec3 *p) {
    struct Point {
        double weight;
        std::vector<Gradient> gradient;
    };
    const auto make = [](CellType of) {
        std::vector<Point> points;
        for (std::size_t i = 0; i < 6; ++i) {
            for (std::size_t j = 0; j < 6; ++j) {
                const double r = gauss_points[i];
                const double s = gauss_points[j];
                const double w = gauss_weights[i] * gauss_weights[j];
                // The square folded onto the triangle (Duffy).
                const bool triangle = of == CellType::triangle6;
                points.push_back({triangle ? w * (1 - r) : 4 * w,
                                  gradients(of, {r, triangle ? s * (1 - r) : s, 0})});
            }
        }
        return points;
    };
    static const auto triangle = make(CellType::triangle6);
    static const auto quad = make(CellType::quad8);
    double sum = 0;
    for (const Point &point : type == CellType::triangle6 ? triangle : quad) {
        Vec3 u{0, 0, 0};
        Vec3 v{0, 0, 0};
        for (std::size_t i = 0; i < point.gradient.size(); ++i) {
            u += point.gradient[i][0] * (p[i] - p[0]);
            v += point.gradient[i][1] * (p[i] - p[0]);
        }
        sum += point.weight * norm(cross(u, v));
    }
    return sum;
}

double length(const Vec3 *p) {
    double sum = 0;
    for (std::size_t i = 0; i < 6; ++i) {
        const double t = gauss_points[i];
        const Vec3 slope = (4 * t - 1) * (p[1] - p[0]) + (4 - 8 * t) * (p[2] - p[0]);
        sum += gauss_weights[i] * norm(slope);
    }
    return sum;
}

} // namespace nmgs::curved
