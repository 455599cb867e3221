// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs_cad/submap.h"

#include "nmgs/element/hexa20.h"
#include "nmgs/element/validity.h"
#include "nmgs_cad/edge_curve.h"
#include "nmgs_cad/face_projection.h"
#include "nmgs_cad/logical_lattice.h"

#include <BRepAdaptor_Surface.hxx>
#include <BRep_Tool.hxx>
#include <Standard_Failure.hxx>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

namespace nmgs::cad {
namespace {

using Index = std::array<int, 3>;

enum class Kind : std::int8_t { outside, inside, on_face, fixed };

// The lattice with every interval divided, and twice as fine again: nodes with even indices become
// points, the others are middles.
struct Grid {
    const CadShape &shape;
    const SolidBoundary &boundary;
    const LogicalDirections &directions;
    const LogicalLattice &lattice;
    Layout &layout;
    const LayoutOptions &options;
    Refusal &refusal;

    std::array<std::vector<int>, 3> segments; // of each interval between planes
    std::array<std::vector<int>, 3> base;     // index of each plane
    std::array<std::vector<double>, 3> place; // of each index
    std::array<int, 3> size{};
    std::vector<Kind> kind;
    std::vector<Vec3> position;
    std::vector<std::int32_t> point; // of the layout, at even indices
    std::vector<std::int32_t> face;  // place in the boundary, of nodes on faces

    [[nodiscard]] std::size_t at(Index i) const {
        const int n = i[0] + size[0] * (i[1] + size[1] * i[2]);
        return static_cast<std::size_t>(n);
    }
    [[nodiscard]] double extent() const;
    bool divide();
    void mark();
    bool lay_edges();
    bool keep_face(std::size_t f);
    void guess();
    void relax(const Progress &progress);
    void project();
    bool write(double &worst);
    [[nodiscard]] std::vector<Index> unit_squares(std::size_t f) const;
    [[nodiscard]] std::array<Index, 2> ends(std::size_t coedge) const;
};

std::array<Index, 2> Grid::ends(std::size_t coedge) const {
    const Coedge &c = boundary.coedges[coedge];
    const int other = boundary.coedges[static_cast<std::size_t>(c.next)].vertex;
    std::array<Index, 2> result{lattice.vertex.at(c.vertex), lattice.vertex.at(other)};
    if (!c.forward) {
        std::swap(result[0], result[1]);
    }
    return result;
}

// About how large the solid is.
double Grid::extent() const {
    double largest = 0;
    for (std::size_t a = 0; a < 3; ++a) {
        largest = std::max(largest, lattice.planes[a].back() - lattice.planes[a].front());
    }
    return largest;
}

// Segments of each interval: enough for the edges' turning and length, exactly as many as the edges
// have that are laid out already.
bool Grid::divide() {
    struct Given {
        std::size_t axis;
        int low, high, count;
        int edge;
    };
    std::vector<Given> given;
    for (std::size_t a = 0; a < 3; ++a) {
        segments[a].assign(static_cast<std::size_t>(lattice.cells(a)), 1);
    }
    for (std::size_t i = 0; i < boundary.coedges.size(); ++i) {
        const Coedge &c = boundary.coedges[i];
        if (!c.forward) {
            continue;
        }
        const auto a = static_cast<std::size_t>(axis_of(directions.coedge[i]));
        const auto [from, to] = ends(i);
        const int low = std::min(from[a], to[a]);
        const int high = std::max(from[a], to[a]);
        const auto &known = layout.edges[static_cast<std::size_t>(c.edge)];
        if (!known.empty()) {
            given.push_back({a, low, high, static_cast<int>(known.size()) - 1, c.edge});
            continue;
        }
        const TopoDS_Edge edge = shape.edge(c.edge);
        const double turn = turning(edge) / options.angle;
        const double length = options.size > 0 ? EdgeCurve(edge).length() / options.size : 0;
        const auto &x = lattice.planes[a];
        const double whole = x[static_cast<std::size_t>(high)] - x[static_cast<std::size_t>(low)];
        for (int n = low; n < high; ++n) {
            const auto p = static_cast<std::size_t>(n);
            const double part = (x[p + 1] - x[p]) / whole;
            segments[a][p] = std::max(
                segments[a][p], static_cast<int>(std::ceil(std::max(turn, length) * part - 1e-6)));
        }
    }
    // Short spans first: they leave no choice.
    std::stable_sort(given.begin(), given.end(), [](const Given &p, const Given &q) {
        return p.high - p.low < q.high - q.low;
    });
    std::array<std::vector<char>, 3> settled;
    for (std::size_t a = 0; a < 3; ++a) {
        settled[a].assign(segments[a].size(), 0);
    }
    for (const Given &g : given) {
        int left = g.count;
        std::vector<std::size_t> open;
        const auto &x = lattice.planes[g.axis];
        double width = 0;
        for (auto n = static_cast<std::size_t>(g.low); n < static_cast<std::size_t>(g.high); ++n) {
            if (settled[g.axis][n] != 0) {
                left -= segments[g.axis][n];
            } else {
                open.push_back(n);
                width += x[n + 1] - x[n];
            }
        }
        if (left < static_cast<int>(open.size()) || (open.empty() && left != 0)) {
            refusal = {"the neighbours' " + std::to_string(g.count) + " segments of " +
                           entity_name(1, g.edge) + " do not suit the others of " +
                           entity_name(3, boundary.solid),
                       {entity_name(1, g.edge)}};
            return false;
        }
        for (std::size_t n = 0; n < open.size(); ++n) {
            const auto after = static_cast<int>(open.size() - n - 1);
            const double step = x[open[n] + 1] - x[open[n]];
            const int count =
                std::clamp(static_cast<int>(std::lround(left * step / width)), 1, left - after);
            segments[g.axis][open[n]] = after == 0 ? left : count;
            settled[g.axis][open[n]] = 1;
            left -= segments[g.axis][open[n]];
            width -= step;
        }
    }
    double total = 1;
    for (std::size_t a = 0; a < 3; ++a) {
        base[a] = {0};
        place[a] = {lattice.planes[a].front()};
        for (std::size_t n = 0; n < segments[a].size(); ++n) {
            const int steps = 2 * segments[a][n];
            for (int i = 1; i <= steps; ++i) {
                const double t = static_cast<double>(i) / steps;
                place[a].push_back((1 - t) * lattice.planes[a][n] + t * lattice.planes[a][n + 1]);
            }
            base[a].push_back(base[a].back() + steps);
        }
        size[a] = base[a].back() + 1;
        total *= size[a];
    }
    constexpr double most = 4e6;
    if (total > most) {
        refusal = {"the lattice of " + entity_name(3, boundary.solid) +
                       " would have too many nodes",
                   {entity_name(3, boundary.solid)}};
        return false;
    }
    return true;
}

std::vector<Index> Grid::unit_squares(std::size_t f) const {
    const auto a = static_cast<std::size_t>(axis_of(directions.face[f]));
    std::vector<Index> result;
    Index i{};
    i[a] = lattice.vertex.at(
        boundary.coedges[static_cast<std::size_t>(boundary.loops[f].front())].vertex)[a];
    const std::size_t u = (a + 1) % 3;
    const std::size_t v = (a + 2) % 3;
    for (i[v] = 0; i[v] < lattice.cells(v); ++i[v]) {
        for (i[u] = 0; i[u] < lattice.cells(u); ++i[u]) {
            if (lattice.face[a][lattice.wall(a, i)] == static_cast<std::int32_t>(f)) {
                result.push_back(i);
            }
        }
    }
    return result;
}

void Grid::mark() {
    const std::size_t count = static_cast<std::size_t>(size[0]) *
                              static_cast<std::size_t>(size[1]) * static_cast<std::size_t>(size[2]);
    kind.assign(count, Kind::outside);
    position.assign(count, Vec3{0, 0, 0});
    point.assign(count, -1);
    face.assign(count, -1);
    const auto range = [&](std::size_t a, int n) {
        return std::array<int, 2>{base[a][static_cast<std::size_t>(n)],
                                  base[a][static_cast<std::size_t>(n) + 1]};
    };
    Index c{};
    for (c[2] = 0; c[2] < lattice.cells(2); ++c[2]) {
        for (c[1] = 0; c[1] < lattice.cells(1); ++c[1]) {
            for (c[0] = 0; c[0] < lattice.cells(0); ++c[0]) {
                if (!lattice.inside(c)) {
                    continue;
                }
                const auto x = range(0, c[0]);
                const auto y = range(1, c[1]);
                const auto z = range(2, c[2]);
                for (int k = z[0]; k <= z[1]; ++k) {
                    for (int j = y[0]; j <= y[1]; ++j) {
                        for (int i = x[0]; i <= x[1]; ++i) {
                            kind[at({i, j, k})] = Kind::inside;
                        }
                    }
                }
            }
        }
    }
    for (std::size_t f = 0; f < boundary.faces.size(); ++f) {
        const auto a = static_cast<std::size_t>(axis_of(directions.face[f]));
        const std::size_t u = (a + 1) % 3;
        const std::size_t v = (a + 2) % 3;
        for (const Index &square : unit_squares(f)) {
            Index i{};
            i[a] = base[a][static_cast<std::size_t>(square[a])];
            const auto ru = range(u, square[u]);
            const auto rv = range(v, square[v]);
            for (i[v] = rv[0]; i[v] <= rv[1]; ++i[v]) {
                for (i[u] = ru[0]; i[u] <= ru[1]; ++i[u]) {
                    kind[at(i)] = Kind::on_face;
                    face[at(i)] = static_cast<std::int32_t>(f);
                }
            }
        }
    }
}

bool Grid::lay_edges() {
    for (std::size_t c = 0; c < boundary.coedges.size(); ++c) {
        const int edge = boundary.coedges[c].edge;
        if (!boundary.coedges[c].forward) {
            continue;
        }
        const auto a = static_cast<std::size_t>(axis_of(directions.coedge[c]));
        auto [from, to] = ends(c);
        for (std::size_t d = 0; d < 3; ++d) {
            from[d] = base[d][static_cast<std::size_t>(from[d])];
            to[d] = base[d][static_cast<std::size_t>(to[d])];
        }
        const int step = from[a] < to[a] ? 1 : -1;
        const double low = place[a][static_cast<std::size_t>(from[a])];
        const double high = place[a][static_cast<std::size_t>(to[a])];
        std::vector<double> fractions;
        for (int i = from[a] + 2 * step; i != to[a]; i += 2 * step) {
            fractions.push_back((place[a][static_cast<std::size_t>(i)] - low) / (high - low));
        }
        const auto points = layout.divide_edge(shape, edge, fractions);
        const EdgeCurve curve(shape.edge(edge));
        std::vector<double> along{0};
        for (std::size_t n = 1; n + 1 < points.size(); ++n) {
            along.push_back(curve.fraction(layout.points[static_cast<std::size_t>(points[n])]));
        }
        along.push_back(1);
        Index i = from;
        for (std::size_t n = 0; n < points.size(); ++n) {
            auto &p = point[at(i)];
            if (p >= 0 && p != points[n]) {
                return false;
            }
            p = points[n];
            position[at(i)] = layout.points[static_cast<std::size_t>(p)];
            kind[at(i)] = Kind::fixed;
            i[a] += step;
            if (n + 1 < points.size()) {
                position[at(i)] = curve.at(0.5 * (along[n] + along[n + 1]));
                kind[at(i)] = Kind::fixed;
                i[a] += step;
            }
        }
    }
    return true;
}

// Finds the lattice's squares in the quads that a neighbour has laid over the face.
bool Grid::keep_face(std::size_t f) {
    const auto quads = layout.quads_of(boundary.faces[f]);
    if (quads.empty()) {
        return true;
    }
    const auto a = static_cast<std::size_t>(axis_of(directions.face[f]));
    const std::size_t u = (a + 1) % 3;
    const std::size_t v = (a + 2) % 3;
    std::map<std::int32_t, Index> known;
    std::size_t squares = 0;
    for (const Index &square : unit_squares(f)) {
        const auto su = static_cast<std::size_t>(square[u]);
        const auto sv = static_cast<std::size_t>(square[v]);
        squares +=
            static_cast<std::size_t>(segments[u][su]) * static_cast<std::size_t>(segments[v][sv]);
        Index i{};
        i[a] = base[a][static_cast<std::size_t>(square[a])];
        for (i[v] = base[v][sv]; i[v] <= base[v][sv + 1]; i[v] += 2) {
            for (i[u] = base[u][su]; i[u] <= base[u][su + 1]; i[u] += 2) {
                if (point[at(i)] >= 0) {
                    known[point[at(i)]] = i;
                }
            }
        }
    }
    const auto refuse = [&] {
        refusal = {"the neighbour's quads on " + entity_name(2, boundary.faces[f]) +
                       " are not a grid that suits " + entity_name(3, boundary.solid),
                   {entity_name(2, boundary.faces[f])}};
        return false;
    };
    if (squares != quads.size()) {
        return refuse();
    }
    bool more = true;
    while (more) {
        more = false;
        for (const auto q : quads) {
            const auto &p = layout.quads[static_cast<std::size_t>(q)].points;
            for (std::size_t n = 0; n < 4; ++n) {
                // A parallelogram's fourth corner.
                const auto before = known.find(p[(n + 3) % 4]);
                const auto after = known.find(p[(n + 1) % 4]);
                const auto across = known.find(p[(n + 2) % 4]);
                if (known.contains(p[n]) || before == known.end() || after == known.end() ||
                    across == known.end()) {
                    continue;
                }
                Index i{};
                for (std::size_t d = 0; d < 3; ++d) {
                    i[d] = before->second[d] + after->second[d] - across->second[d];
                    if (i[d] < 0 || i[d] >= size[d]) {
                        return refuse();
                    }
                }
                if (face[at(i)] != static_cast<std::int32_t>(f) || point[at(i)] >= 0) {
                    return refuse();
                }
                known[p[n]] = i;
                point[at(i)] = p[n];
                position[at(i)] = layout.points[static_cast<std::size_t>(p[n])];
                kind[at(i)] = Kind::fixed;
                more = true;
            }
        }
    }
    FaceProjection projection(shape.face(boundary.faces[f]));
    for (const auto q : quads) {
        const auto &p = layout.quads[static_cast<std::size_t>(q)].points;
        for (std::size_t n = 0; n < 4; ++n) {
            const auto from = known.find(p[n]);
            const auto to = known.find(p[(n + 1) % 4]);
            if (from == known.end() || to == known.end()) {
                return refuse();
            }
            Index middle{};
            int apart = 0;
            for (std::size_t d = 0; d < 3; ++d) {
                middle[d] = (from->second[d] + to->second[d]) / 2;
                apart += std::abs(from->second[d] - to->second[d]);
            }
            if (apart != 2) {
                return refuse();
            }
            if (kind[at(middle)] != Kind::fixed) {
                const auto given = layout.middles.find(
                    {std::min(p[n], p[(n + 1) % 4]), std::max(p[n], p[(n + 1) % 4])});
                position[at(middle)] = given != layout.middles.end()
                                           ? given->second
                                           : projection.nearest(0.5 * (position[at(from->second)] +
                                                                       position[at(to->second)]));
                kind[at(middle)] = Kind::fixed;
            }
        }
    }
    return true;
}

// The affine map of the lattice's places that comes nearest to the fixed nodes: right already for a
// rectilinear solid.
void Grid::guess() {
    std::array<std::array<double, 4>, 4> a{};
    std::array<Vec3, 4> b{};
    const auto row = [&](const Index &i) {
        return std::array<double, 4>{1, place[0][static_cast<std::size_t>(i[0])],
                                     place[1][static_cast<std::size_t>(i[1])],
                                     place[2][static_cast<std::size_t>(i[2])]};
    };
    Index i{};
    for (i[2] = 0; i[2] < size[2]; ++i[2]) {
        for (i[1] = 0; i[1] < size[1]; ++i[1]) {
            for (i[0] = 0; i[0] < size[0]; ++i[0]) {
                if (kind[at(i)] == Kind::fixed) {
                    const auto r = row(i);
                    for (std::size_t p = 0; p < 4; ++p) {
                        for (std::size_t q = 0; q < 4; ++q) {
                            a[p][q] += r[p] * r[q];
                        }
                        b[p] += r[p] * position[at(i)];
                    }
                }
            }
        }
    }
    for (std::size_t k = 0; k < 4; ++k) {
        for (std::size_t n = k + 1; n < 4; ++n) {
            const double f = a[n][k] / a[k][k];
            for (std::size_t j = k; j < 4; ++j) {
                a[n][j] -= f * a[k][j];
            }
            b[n] = b[n] - f * b[k];
        }
    }
    for (std::size_t k = 4; k-- > 0;) {
        for (std::size_t j = k + 1; j < 4; ++j) {
            b[k] = b[k] - a[k][j] * b[j];
        }
        b[k] = (1 / a[k][k]) * b[k];
    }
    for (i[2] = 0; i[2] < size[2]; ++i[2]) {
        for (i[1] = 0; i[1] < size[1]; ++i[1]) {
            for (i[0] = 0; i[0] < size[0]; ++i[0]) {
                if (kind[at(i)] == Kind::inside || kind[at(i)] == Kind::on_face) {
                    const auto r = row(i);
                    position[at(i)] = b[0] + r[1] * b[1] + r[2] * b[2] + r[3] * b[3];
                }
            }
        }
    }
}

// Laplace's equation by Gauss and Seidel with over-relaxation: faces first, then the inside.
void Grid::relax(const Progress &progress) {
    const double far = extent();
    for (const Kind which : {Kind::on_face, Kind::inside}) {
        constexpr int most = 400;
        for (int round = 0; round < most; ++round) {
            double largest = 0;
            Index i{};
            for (i[2] = 0; i[2] < size[2]; ++i[2]) {
                for (i[1] = 0; i[1] < size[1]; ++i[1]) {
                    for (i[0] = 0; i[0] < size[0]; ++i[0]) {
                        const std::size_t n = at(i);
                        if (kind[n] != which) {
                            continue;
                        }
                        const int skip =
                            which == Kind::on_face
                                ? axis_of(directions.face[static_cast<std::size_t>(face[n])])
                                : 3;
                        Vec3 sum{0, 0, 0};
                        double weights = 0;
                        for (std::size_t d = 0; d < 3; ++d) {
                            if (static_cast<int>(d) == skip) {
                                continue;
                            }
                            Index low = i;
                            Index high = i;
                            --low[d];
                            ++high[d];
                            const auto &x = place[d];
                            const auto m = static_cast<std::size_t>(i[d]);
                            const double before = x[m] - x[m - 1];
                            const double after = x[m + 1] - x[m];
                            const double a = 1 / (before * (before + after));
                            const double b = 1 / (after * (before + after));
                            sum += a * position[at(low)] + b * position[at(high)];
                            weights += a + b;
                        }
                        const Vec3 move = (1 / weights) * sum - position[n];
                        largest = std::max(largest, norm2(move));
                        constexpr double over = 1.4;
                        position[n] += over * move;
                    }
                }
            }
            poll(progress, 0.5);
            if (largest <= 1e-14 * far * far) {
                break;
            }
        }
        if (which == Kind::on_face) {
            project();
        }
    }
}

void Grid::project() {
    std::vector<std::vector<std::size_t>> nodes(boundary.faces.size());
    for (std::size_t n = 0; n < kind.size(); ++n) {
        if (kind[n] == Kind::on_face) {
            nodes[static_cast<std::size_t>(face[n])].push_back(n);
        }
    }
    for (std::size_t f = 0; f < nodes.size(); ++f) {
        if (nodes[f].empty()) {
            continue;
        }
        FaceProjection projection(shape.face(boundary.faces[f]));
        for (const std::size_t n : nodes[f]) {
            position[n] = projection.nearest(position[n]);
        }
    }
}

// Least Jacobian over the block by the lengths of its columns, sampled.
double block_quality(std::span<const Vec3, 20> nodes) {
    double worst = 1;
    for (int k = -1; k <= 1; ++k) {
        for (int j = -1; j <= 1; ++j) {
            for (int i = -1; i <= 1; ++i) {
                const auto d = hexa20::derivatives(i, j, k);
                Vec3 x{0, 0, 0};
                Vec3 y{0, 0, 0};
                Vec3 z{0, 0, 0};
                for (std::size_t n = 0; n < 20; ++n) {
                    x += d.xi[n] * nodes[n];
                    y += d.eta[n] * nodes[n];
                    z += d.zeta[n] * nodes[n];
                }
                const double lengths = norm(x) * norm(y) * norm(z);
                worst = std::min(worst, lengths > 0 ? determinant(x, y, z) / lengths : 0.0);
            }
        }
    }
    return worst;
}

bool Grid::write(double &worst) {
    const double tiny = 1e-9 * extent();
    const auto point_at = [&](const Index &i) {
        const std::size_t n = at(i);
        if (point[n] < 0) {
            const CadEntity on =
                kind[n] == Kind::on_face
                    ? CadEntity{2, boundary.faces[static_cast<std::size_t>(face[n])]}
                    : CadEntity{3, boundary.solid};
            point[n] = layout.add_point(position[n], on);
        }
        return point[n];
    };
    for (std::size_t f = 0; f < boundary.faces.size(); ++f) {
        const int number = boundary.faces[f];
        if (!layout.quads_of(number).empty()) {
            continue;
        }
        const auto a = static_cast<std::size_t>(axis_of(directions.face[f]));
        const std::size_t u = (a + 1) % 3;
        const std::size_t v = (a + 2) % 3;
        // (u, v) turns about +a; a face that looks the other way is turned round, and one that the
        // shape holds the other way round once more.
        const bool flip = (sign_of(directions.face[f]) < 0) != (boundary.reversed[f] != 0);
        for (const Index &square : unit_squares(f)) {
            Index i{};
            i[a] = base[a][static_cast<std::size_t>(square[a])];
            const auto su = static_cast<std::size_t>(square[u]);
            const auto sv = static_cast<std::size_t>(square[v]);
            for (i[v] = base[v][sv]; i[v] < base[v][sv + 1]; i[v] += 2) {
                for (i[u] = base[u][su]; i[u] < base[u][su + 1]; i[u] += 2) {
                    std::array<Index, 4> corners{i, i, i, i};
                    corners[1][u] += 2;
                    corners[2][u] += 2;
                    corners[2][v] += 2;
                    corners[3][v] += 2;
                    if (flip) {
                        std::swap(corners[1], corners[3]);
                    }
                    Layout::Quad quad{{}, number};
                    for (std::size_t n = 0; n < 4; ++n) {
                        quad.points[n] = point_at(corners[n]);
                    }
                    layout.quads.push_back(quad);
                }
            }
        }
    }
    worst = 1;
    Index cell{};
    for (cell[2] = 0; cell[2] + 1 < size[2]; cell[2] += 2) {
        for (cell[1] = 0; cell[1] + 1 < size[1]; cell[1] += 2) {
            for (cell[0] = 0; cell[0] + 1 < size[0]; cell[0] += 2) {
                Index coarse{};
                for (std::size_t d = 0; d < 3; ++d) {
                    coarse[d] =
                        static_cast<int>(std::upper_bound(base[d].begin(), base[d].end(), cell[d]) -
                                         base[d].begin()) -
                        1;
                }
                if (!lattice.inside(coarse)) {
                    continue;
                }
                Layout::Hexa hexa{{}, boundary.solid};
                std::array<Vec3, 20> nodes{};
                std::array<Index, 20> indices{};
                for (std::size_t n = 0; n < 20; ++n) {
                    for (std::size_t d = 0; d < 3; ++d) {
                        indices[n][d] = cell[d] + static_cast<int>(hexa20::natural[n][d]) + 1;
                    }
                    nodes[n] = position[at(indices[n])];
                    if (n < 8) {
                        hexa.points[n] = point_at(indices[n]);
                    }
                }
                if (check_validity(std::span<const Vec3, 20>(nodes)).validity != Validity::valid) {
                    refusal = {"a block of " + entity_name(3, boundary.solid) + " would be folded",
                               {entity_name(3, boundary.solid)}};
                    return false;
                }
                worst = std::min(worst, block_quality(nodes));
                layout.hexas.push_back(hexa);
                for (std::size_t n = 8; n < 20; ++n) {
                    const std::size_t m = at(indices[n]);
                    if (kind[m] == Kind::fixed) {
                        continue; // on an edge, or the neighbour's
                    }
                    Index low = indices[n];
                    Index high = indices[n];
                    for (std::size_t d = 0; d < 3; ++d) {
                        const int along = hexa20::natural[n][d] == 0 ? 1 : 0;
                        low[d] -= along;
                        high[d] += along;
                    }
                    const std::int32_t p = point[at(low)];
                    const std::int32_t q = point[at(high)];
                    const Vec3 straight = 0.5 * (position[at(low)] + position[at(high)]);
                    if (distance(straight, position[m]) > tiny) {
                        layout.middles[{std::min(p, q), std::max(p, q)}] = position[m];
                    }
                }
            }
        }
    }
    return true;
}

} // namespace

bool fill_submap(const CadShape &shape, int solid, Layout &layout, const LayoutOptions &options,
                 Refusal &refusal, const Progress &progress) {
    try {
        const auto boundary = boundary_of(shape, solid, refusal);
        if (!boundary) {
            return false;
        }
        const auto found = logical_directions(shape, *boundary, refusal);
        std::optional<Layout> best;
        double best_quality = 0;
        constexpr double good = 0.4;
        for (const auto &directions : found) {
            for (const double merge : {0.34, 0.0}) {
                if (best_quality > good) {
                    break;
                }
                poll(progress, 0.1);
                const auto lattice = logical_lattice(shape, *boundary, directions, merge, refusal);
                if (!lattice) {
                    continue;
                }
                Layout trial = layout;
                Grid grid{shape, *boundary, directions, *lattice, trial, options, refusal, {},
                          {},    {},        {},         {},       {},    {},      {}};
                if (!grid.divide()) {
                    continue;
                }
                grid.mark();
                bool fits = grid.lay_edges();
                for (std::size_t f = 0; fits && f < boundary->faces.size(); ++f) {
                    fits = grid.keep_face(f);
                }
                if (!fits) {
                    continue;
                }
                grid.guess();
                grid.relax(progress);
                double quality = 0;
                if (grid.write(quality) && quality > best_quality) {
                    best_quality = quality;
                    best = std::move(trial);
                }
            }
        }
        if (!best) {
            return false;
        }
        layout = std::move(*best);
        refusal = {};
        return true;
    } catch (const Standard_Failure &failure) {
        refusal = {entity_name(3, solid) + ": OpenCASCADE: " + failure.GetMessageString(),
                   {entity_name(3, solid)}};
        return false;
    }
}

} // namespace nmgs::cad
