// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs/quality/untangle.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace nmgs {
namespace {

// The corners' neighbours along xi, eta, zeta in right-handed order, and the directions' numbers.
constexpr std::array<std::array<std::uint8_t, 3>, 8> hexa_neighbours{
    {{1, 3, 4}, {2, 0, 5}, {3, 1, 6}, {0, 2, 7}, {7, 5, 0}, {4, 6, 1}, {5, 7, 2}, {6, 4, 3}}};
constexpr std::array<std::array<std::uint8_t, 3>, 8> hexa_directions{
    {{0, 1, 2}, {1, 0, 2}, {0, 1, 2}, {1, 0, 2}, {1, 0, 2}, {0, 1, 2}, {1, 0, 2}, {0, 1, 2}}};

constexpr double least_ratio = 0.05; // of a cell's target lengths

// A corner of a cell: its node, its neighbours' and the lengths that these edges should have. Of a
// quad the third edge is the normal.
struct Corner {
    std::array<std::int32_t, 4> node; // own, then three neighbours; the last is -1 for a quad
    std::array<double, 3> length;
    Vec3 normal;
};

struct Untangler {
    std::span<Vec3> points;
    std::span<const std::array<std::int32_t, 8>> hexahedra;
    std::span<const std::array<std::int32_t, 4>> quads;
    NodeSlides &slides;
    std::vector<Corner> corners;
    std::vector<std::int32_t> first, of_node; // corners that a node takes part in
    std::vector<std::int32_t> movable;
    std::vector<double> reach; // mean length of the edges at a node
    double delta = 0;          // of the regularisation
    double power = 1;

    void prepare();
    void set_targets();
    [[nodiscard]] double scaled_jacobian(const Corner &c) const;
    [[nodiscard]] double determinant_of(const Corner &c) const;
    [[nodiscard]] double worst() const;
    [[nodiscard]] double lack(double enough) const; // sum of what corners are below it
    double energy(std::int32_t node, Vec3 at, Vec3 *gradient);
    [[nodiscard]] double least_round(std::int32_t node) const;
    void relax(std::int32_t node);
    bool raise(std::int32_t node);
    [[nodiscard]] std::span<const std::int32_t> corners_of(std::int32_t node) const {
        const auto n = static_cast<std::size_t>(node);
        return std::span(of_node).subspan(static_cast<std::size_t>(first[n]),
                                          static_cast<std::size_t>(first[n + 1] - first[n]));
    }
    [[nodiscard]] Vec3 at(std::int32_t node) const {
        return points[static_cast<std::size_t>(node)];
    }
    [[nodiscard]] std::array<Vec3, 3> edges(const Corner &c) const {
        const Vec3 p = at(c.node[0]);
        return {at(c.node[1]) - p, at(c.node[2]) - p,
                c.node[3] < 0 ? c.length[2] * c.normal : at(c.node[3]) - p};
    }
};

void Untangler::prepare() {
    corners.reserve(8 * hexahedra.size() + 4 * quads.size());
    for (const auto &h : hexahedra) {
        for (std::size_t k = 0; k < 8; ++k) {
            Corner c{};
            c.node[0] = h[k];
            for (std::size_t i = 0; i < 3; ++i) {
                c.node[i + 1] = h[static_cast<std::size_t>(hexa_neighbours[k][i])];
            }
            corners.push_back(c);
        }
    }
    for (const auto &q : quads) {
        for (std::size_t k = 0; k < 4; ++k) {
            corners.push_back({{q[k], q[(k + 1) % 4], q[(k + 3) % 4], -1}, {1, 1, 1}, {}});
        }
    }
    first.assign(points.size() + 1, 0);
    for (const Corner &c : corners) {
        for (const std::int32_t n : c.node) {
            if (n >= 0) {
                ++first[static_cast<std::size_t>(n) + 1];
            }
        }
    }
    for (std::size_t n = 0; n < points.size(); ++n) {
        first[n + 1] += first[n];
    }
    of_node.resize(static_cast<std::size_t>(first.back()));
    auto next = first;
    for (std::size_t c = 0; c < corners.size(); ++c) {
        for (const std::int32_t n : corners[c].node) {
            if (n >= 0) {
                of_node[static_cast<std::size_t>(next[static_cast<std::size_t>(n)]++)] =
                    static_cast<std::int32_t>(c);
            }
        }
    }
    for (std::size_t n = 0; n < points.size(); ++n) {
        const auto node = static_cast<std::int32_t>(n);
        if (first[n + 1] > first[n] && slides.freedom(node) > 0) {
            movable.push_back(node);
        }
    }
}

// Each direction of a cell has one target, the mean of its edges: thin cells stay thin.
void Untangler::set_targets() {
    std::size_t c = 0;
    for (const auto &h : hexahedra) {
        std::array<double, 3> mean{};
        for (std::size_t k = 0; k < 8; ++k) {
            for (std::size_t i = 0; i < 3; ++i) {
                mean[static_cast<std::size_t>(hexa_directions[k][i])] +=
                    distance(at(h[k]), at(h[static_cast<std::size_t>(hexa_neighbours[k][i])])) / 8;
            }
        }
        const double most = std::max({mean[0], mean[1], mean[2]});
        for (std::size_t k = 0; k < 8; ++k, ++c) {
            for (std::size_t i = 0; i < 3; ++i) {
                corners[c].length[i] = std::max(
                    mean[static_cast<std::size_t>(hexa_directions[k][i])], least_ratio * most);
            }
        }
    }
    for (std::size_t q = 0; q < quads.size(); ++q) {
        const auto &n = quads[q];
        const double along = 0.5 * (distance(at(n[0]), at(n[1])) + distance(at(n[2]), at(n[3])));
        const double across = 0.5 * (distance(at(n[1]), at(n[2])) + distance(at(n[3]), at(n[0])));
        const double most = std::max(along, across);
        for (std::size_t k = 0; k < 4; ++k, ++c) {
            const double u = std::max(along, least_ratio * most);
            const double v = std::max(across, least_ratio * most);
            corners[c].length = {k % 2 == 0 ? u : v, k % 2 == 0 ? v : u, 1};
            corners[c].normal = slides.normal(static_cast<std::int32_t>(q), at(n[k]));
        }
    }
    reach.assign(points.size(), 0);
    for (const std::int32_t n : movable) {
        double sum = 0;
        int count = 0;
        for (const std::int32_t i : corners_of(n)) {
            const Corner &corner = corners[static_cast<std::size_t>(i)];
            for (std::size_t k = 0; k < (corner.node[3] < 0 ? 2U : 3U); ++k) {
                sum += distance(at(corner.node[0]), at(corner.node[k + 1]));
                ++count;
            }
        }
        reach[static_cast<std::size_t>(n)] = count > 0 ? sum / count : 0;
    }
}

double Untangler::determinant_of(const Corner &c) const {
    const auto e = edges(c);
    return determinant(e[0], e[1], e[2]) / (c.length[0] * c.length[1] * c.length[2]);
}

double Untangler::scaled_jacobian(const Corner &c) const {
    const auto e = edges(c);
    const double size = std::sqrt(norm2(e[0]) * norm2(e[1]) * norm2(e[2]));
    return size > 0 ? determinant(e[0], e[1], e[2]) / size : -1;
}

double Untangler::worst() const {
    double least = 1;
    for (const Corner &c : corners) {
        least = std::min(least, scaled_jacobian(c));
    }
    return least;
}

double Untangler::lack(double enough) const {
    double sum = 0;
    for (const Corner &c : corners) {
        sum += std::max(0.0, enough - scaled_jacobian(c));
    }
    return sum;
}

double Untangler::least_round(std::int32_t node) const {
    double least = 1;
    for (const std::int32_t i : corners_of(node)) {
        least = std::min(least, scaled_jacobian(corners[static_cast<std::size_t>(i)]));
    }
    return least;
}

// Sum over the node's corners of ((|u|^2 / d)^(d/2) / h(det u))^power, u the edges by their
// targets.
double Untangler::energy(std::int32_t node, Vec3 place, Vec3 *gradient) {
    Vec3 &p = points[static_cast<std::size_t>(node)];
    const Vec3 kept = p;
    p = place;
    double sum = 0;
    Vec3 slope{};
    for (const std::int32_t i : corners_of(node)) {
        const Corner &c = corners[static_cast<std::size_t>(i)];
        const auto e = edges(c);
        const bool flat = c.node[3] < 0;
        const Vec3 a = (1 / c.length[0]) * e[0];
        const Vec3 b = (1 / c.length[1]) * e[1];
        const Vec3 n = flat ? c.normal : (1 / c.length[2]) * e[2];
        const Vec3 bn = cross(b, n);
        const double det = dot(a, bn);
        const double root = std::sqrt(det * det + 4 * delta * delta);
        const double h = 0.5 * (det + root);
        const double f = norm2(a) + norm2(b) + (flat ? 0 : norm2(n));
        const double size = flat ? f / 2 : (f / 3) * std::sqrt(f / 3);
        if (!(h > 0)) {
            p = kept;
            return std::numeric_limits<double>::infinity();
        }
        const double kappa = size / h;
        double value = kappa;
        for (double q = 1; q < power; q *= 2) {
            value *= value;
        }
        sum += value;
        if (gradient != nullptr) {
            // By the logarithm.
            const double stretch = (flat ? 2 : 3) / f;
            const double squash = 1 / root;
            const Vec3 da = (1 / c.length[0]) * (stretch * a - squash * bn);
            const Vec3 db = (1 / c.length[1]) * (stretch * b - squash * cross(n, a));
            const Vec3 dn =
                flat ? Vec3{} : (1 / c.length[2]) * (stretch * n - squash * cross(a, b));
            const double factor = power * value;
            if (c.node[0] == node) {
                slope = slope - factor * (da + db + dn);
            } else {
                slope += factor * (c.node[1] == node ? da : c.node[2] == node ? db : dn);
            }
        }
    }
    p = kept;
    if (gradient != nullptr) {
        *gradient = slope;
    }
    return sum;
}

// One step of Newton's method, its matrix by differences of the gradient.
void Untangler::relax(std::int32_t node) {
    Vec3 &p = points[static_cast<std::size_t>(node)];
    const double size = reach[static_cast<std::size_t>(node)];
    const auto d = static_cast<std::size_t>(slides.freedom(node));
    std::array<Vec3, 3> axis{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    if (d < 3) {
        const auto t = slides.tangents(node, p);
        axis = {t[0], t[1], {}};
    }
    Vec3 slope{};
    const double before = energy(node, p, &slope);
    if (!std::isfinite(before) || size <= 0) {
        return;
    }
    std::array<double, 3> g{};
    std::array<std::array<double, 3>, 3> m{};
    const double step = 1e-5 * size;
    for (std::size_t i = 0; i < d; ++i) {
        g[i] = dot(slope, axis[i]);
    }
    for (std::size_t i = 0; i < d; ++i) {
        Vec3 beside{};
        if (!std::isfinite(energy(node, p + step * axis[i], &beside))) {
            return;
        }
        for (std::size_t j = 0; j < d; ++j) {
            m[i][j] = (dot(beside, axis[j]) - g[j]) / step;
        }
    }
    // Cholesky with a growing multiple of the unit matrix until it is positive definite.
    double trace = 0;
    for (std::size_t i = 0; i < d; ++i) {
        trace += std::abs(m[i][i]);
    }
    std::array<double, 3> move{};
    bool solved = false;
    for (double shift = 0; !solved && shift<1e4 * (trace + 1e-300); shift = shift> 0
                               ? 4 * shift
                               : 1e-3 * trace + 1e-300) {
        std::array<std::array<double, 3>, 3> l{};
        bool positive = true;
        for (std::size_t i = 0; i < d && positive; ++i) {
            for (std::size_t j = 0; j <= i; ++j) {
                double v = 0.5 * (m[i][j] + m[j][i]) + (i == j ? shift : 0);
                for (std::size_t k = 0; k < j; ++k) {
                    v -= l[i][k] * l[j][k];
                }
                if (i != j) {
                    l[i][j] = v / l[j][j];
                } else if (v > 1e-9 * trace) {
                    l[i][i] = std::sqrt(v);
                } else {
                    positive = false;
                }
            }
        }
        if (!positive) {
            continue;
        }
        std::array<double, 3> y{};
        for (std::size_t i = 0; i < d; ++i) {
            y[i] = -g[i];
            for (std::size_t k = 0; k < i; ++k) {
                y[i] -= l[i][k] * y[k];
            }
            y[i] /= l[i][i];
        }
        for (std::size_t i = d; i-- > 0;) {
            move[i] = y[i];
            for (std::size_t k = i + 1; k < d; ++k) {
                move[i] -= l[k][i] * move[k];
            }
            move[i] /= l[i][i];
        }
        solved = true;
    }
    if (!solved) {
        return;
    }
    Vec3 go{};
    for (std::size_t i = 0; i < d; ++i) {
        go += move[i] * axis[i];
    }
    const double length = norm(go);
    if (length > 0.5 * size) {
        go = (0.5 * size / length) * go;
    }
    for (int halving = 0; halving < 8; ++halving) {
        const Vec3 there = d < 3 ? slides.slide(node, p, p + go) : p + go;
        if (energy(node, there, nullptr) < before) {
            p = there;
            return;
        }
        go = 0.5 * go;
    }
}

// Tries steps that raise the least scaled Jacobian round the node: along its gradient, that of the
// corners nearly as bad, and the axes.
bool Untangler::raise(std::int32_t node) {
    Vec3 &p = points[static_cast<std::size_t>(node)];
    const int freedom = slides.freedom(node);
    const double size = reach[static_cast<std::size_t>(node)];
    const double start = least_round(node);
    double least = start;
    double step = 0.2 * size;
    int failures = 0;
    for (int round = 0; round < 6 && failures < 3; ++round) {
        std::array<Vec3, 3> axis{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
        if (freedom < 3) {
            const auto t = slides.tangents(node, p);
            axis = {t[0], freedom > 1 ? t[1] : Vec3{}, {}};
        }
        Vec3 steepest{};
        Vec3 common{};
        double lowest = 2;
        const double h = 1e-6 * size;
        for (const std::int32_t i : corners_of(node)) {
            const Corner &c = corners[static_cast<std::size_t>(i)];
            const double here = scaled_jacobian(c);
            if (here > least + 0.05) {
                continue;
            }
            Vec3 slope{};
            const Vec3 kept = p;
            for (int d = 0; d < freedom; ++d) {
                const Vec3 a = axis[static_cast<std::size_t>(d)];
                p = kept + h * a;
                slope += ((scaled_jacobian(c) - here) / h) * a;
                p = kept;
            }
            const double n = norm(slope);
            if (n > 0) {
                common += (1 / n) * slope;
                if (here < lowest) {
                    lowest = here;
                    steepest = (1 / n) * slope;
                }
            }
        }
        const double n = norm(common);
        const std::array<Vec3, 8> tries{steepest, n > 0 ? (1 / n) * common : Vec3{},
                                        axis[0],  -1.0 * axis[0],
                                        axis[1],  -1.0 * axis[1],
                                        axis[2],  -1.0 * axis[2]};
        const Vec3 from = p;
        Vec3 best = from;
        for (const Vec3 &t : tries) {
            if (norm2(t) < 0.5) {
                continue;
            }
            p = freedom < 3 ? slides.slide(node, from, from + step * t) : from + step * t;
            const double value = least_round(node);
            if (value > least + 1e-9) {
                least = value;
                best = p;
            }
            p = from;
        }
        if (best == from) {
            step *= 0.3;
            ++failures;
        }
        p = best;
    }
    return least > start;
}

// See UntangleOptions::each. Those with the worst corners first.
void raise_each(Untangler &u, const UntangleOptions &options, const Progress &progress) {
    int visits = 0;
    std::vector<char> again(u.points.size(), 1); // something round the node has moved since
    for (int sweep = 0; sweep < options.sweeps && visits < options.raises; ++sweep) {
        if (sweep % 4 == 0) {
            u.set_targets();
        }
        u.delta = 0;
        u.power = 4;
        std::vector<std::pair<double, std::int32_t>> bad;
        for (const std::int32_t n : u.movable) {
            const double least = again[static_cast<std::size_t>(n)] != 0 ? u.least_round(n) : 1;
            if (least < options.good) {
                bad.emplace_back(least, n);
            }
        }
        if (bad.empty()) {
            break;
        }
        std::sort(bad.begin(), bad.end());
        for (const auto &[least, n] : bad) {
            poll(progress, static_cast<double>(sweep) / options.sweeps);
            const double was = u.least_round(n);
            again[static_cast<std::size_t>(n)] = 0;
            if (was >= options.good) {
                continue;
            }
            if (++visits > options.raises) {
                break;
            }
            const Vec3 before = u.at(n);
            u.relax(n);
            if (u.least_round(n) <= was) {
                u.points[static_cast<std::size_t>(n)] = before;
            }
            if (u.least_round(n) < options.good) {
                u.raise(n);
            }
            const bool moved = u.least_round(n) > was + options.gain;
            for (const std::int32_t c : u.corners_of(n)) {
                for (const std::int32_t m : u.corners[static_cast<std::size_t>(c)].node) {
                    if (moved && m >= 0) {
                        again[static_cast<std::size_t>(m)] = 1;
                    }
                }
            }
        }
    }
}

} // namespace

UntangleResult untangle(std::span<Vec3> points,
                        std::span<const std::array<std::int32_t, 8>> hexahedra,
                        std::span<const std::array<std::int32_t, 4>> quads, NodeSlides &slides,
                        const UntangleOptions &options, const Progress &progress) {
    Untangler u{points, hexahedra, quads, slides, {}, {}, {}, {}, {}, 0, 1};
    u.prepare();
    u.set_targets();
    UntangleResult result;
    result.before = result.after = u.worst();
    if (u.movable.empty() || result.before >= options.good) {
        return result;
    }
    if (options.each) {
        raise_each(u, options, progress);
        result.after = u.worst();
        return result;
    }
    std::vector<Vec3> best(points.begin(), points.end());
    const auto keep_best = [&] {
        const double now = u.worst();
        if (now > result.after) {
            result.after = now;
            std::copy(points.begin(), points.end(), best.begin());
        }
        return now;
    };
    const auto poll_often = [&](std::size_t n, double fraction) {
        constexpr std::size_t often = 512;
        if (n % often == 0) {
            poll(progress, fraction);
        }
    };
    // Cells that are good already make room, but need no visit of their own.
    constexpr double room = 0.7;
    const double enough = std::min(options.good, room);
    double mark = result.after;
    double lack = u.lack(enough);
    for (int sweep = 0; sweep < options.sweeps && result.after < options.good; ++sweep) {
        if (sweep % 4 == 0) {
            u.set_targets();
        }
        double least = 1;
        for (const Corner &c : u.corners) {
            least = std::min(least, u.determinant_of(c));
        }
        // Inside out: a finite energy, and the sooner the better. Otherwise a barrier, which leans
        // on the worst ever more.
        constexpr double positive = 0.01;
        u.delta = least > positive ? 0 : std::max(0.02, 0.3 * std::sqrt(-std::min(0.0, least)));
        u.power = least <= positive ? 1 : sweep < options.sweeps / 3 ? 2 : 4;
        for (std::size_t n = 0; n < u.movable.size(); ++n) {
            if (u.least_round(u.movable[n]) < enough) {
                u.relax(u.movable[n]);
            }
            poll_often(n, 0.5 * sweep / options.sweeps);
        }
        keep_best();
        if (sweep % 6 == 5) {
            // The worst may come last: as long as the others gain, it goes on.
            const double now = u.lack(enough);
            if (result.after < mark + options.gain && now > 0.97 * lack) {
                break;
            }
            mark = result.after;
            lack = now;
        }
    }
    std::copy(best.begin(), best.end(), points.begin());
    mark = result.after;
    int raised = 0;
    for (int sweep = 0; sweep < options.sweeps && result.after < options.good; ++sweep) {
        if (sweep % 4 == 0) {
            u.set_targets();
        }
        // Only where it is nearly as bad as at the worst.
        const double limit = std::min(result.after + 0.1, options.good);
        bool moved = false;
        for (std::size_t n = 0; n < u.movable.size(); ++n) {
            if (raised < options.raises && u.least_round(u.movable[n]) < limit) {
                ++raised;
                moved = u.raise(u.movable[n]) || moved;
            }
            poll_often(n, 0.5 + 0.5 * sweep / options.sweeps);
        }
        keep_best();
        if (!moved || raised >= options.raises) {
            break;
        }
        if (sweep % 3 == 2) {
            if (result.after < mark + options.gain) {
                break;
            }
            mark = result.after;
        }
    }
    std::copy(best.begin(), best.end(), points.begin());
    return result;
}

} // namespace nmgs
