// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs_cad/hexas_on_cad.h"

#include "nmgs/support/ascending.h"
#include "nmgs/support/at.h"
#include "nmgs_cad/edge_curve.h"
#include "nmgs_cad/entity_locator.h"

#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>

#include <algorithm>
#include <limits>
#include <set>

namespace nmgs::cad {
namespace {

using Pair = std::array<std::int32_t, 2>;
using Four = std::array<std::int32_t, 4>;

// A hexahedron's faces, seen from outside counter-clockwise.
constexpr std::array<std::array<std::size_t, 4>, 6> sides{
    {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}}};

Four sorted(Four q) {
    std::sort(q.begin(), q.end());
    return q;
}
struct Binder {
    const CadShape &shape;
    int solid;
    HexaMesh mesh;
    Layout layout;
    Refusal &refusal;
    double tolerance;
    EntityLocator locator;

    std::vector<Four> boundary;       // of the mesh, seen from outside
    std::vector<CadEntity> on;        // of each point
    std::vector<std::int32_t> number; // of each point in the layout
    std::map<int, std::set<int>> faces_of_edge, faces_of_vertex;
    std::map<int, std::vector<Pair>> segments; // of each CAD edge, points of the mesh
    std::map<Pair, int> edge_of;

    Binder(const CadShape &s, int n, HexaMesh m, Layout l, Refusal &r)
        : shape(s), solid(n), mesh(std::move(m)), layout(std::move(l)), refusal(r),
          tolerance(1e-5 * extent_of(s.solid(n))), locator(s, n, tolerance) {
        for (const int f : locator.faces()) {
            for (TopExp_Explorer it(shape.face(f), TopAbs_EDGE); it.More(); it.Next()) {
                faces_of_edge[shape.edges.FindIndex(it.Current())].insert(f);
            }
            for (TopExp_Explorer it(shape.face(f), TopAbs_VERTEX); it.More(); it.Next()) {
                faces_of_vertex[shape.vertices.FindIndex(it.Current())].insert(f);
            }
        }
    }
    bool refuse(const std::string &reason, int dimension, int index) {
        refusal = {reason, {entity_name(dimension, index)}};
        return false;
    }
    [[nodiscard]] Vec3 middle(Pair key) const {
        const auto given = mesh.middles.find(key);
        return given != mesh.middles.end()
                   ? given->second
                   : 0.5 * (mesh.points[at(key[0])] + mesh.points[at(key[1])]);
    }
    [[nodiscard]] std::set<int> faces_of(CadEntity entity) const {
        if (entity.dimension == 2) {
            return {entity.index};
        }
        const auto &map = entity.dimension == 1 ? faces_of_edge : faces_of_vertex;
        const auto found = map.find(entity.index);
        return found == map.end() ? std::set<int>{} : found->second;
    }

    void turn() {
        for (auto &h : mesh.hexas) {
            Vec3 low{};
            Vec3 high{};
            Vec3 area{};
            for (std::size_t i = 0; i < 4; ++i) {
                low += mesh.points[at(h[i])];
                high += mesh.points[at(h[i + 4])];
            }
            for (const std::size_t base : {0U, 4U}) {
                const auto p = [&](std::size_t i) { return mesh.points[at(h[base + i])]; };
                area += cross(p(2) - p(0), p(3) - p(1));
            }
            if (dot(area, high - low) < 0) {
                std::swap(h[1], h[3]);
                std::swap(h[5], h[7]);
            }
        }
    }
    void find_boundary() {
        std::map<Four, std::pair<int, Four>> count;
        for (const auto &h : mesh.hexas) {
            for (const auto &side : sides) {
                const Four q{h[side[0]], h[side[1]], h[side[2]], h[side[3]]};
                auto &entry = count[sorted(q)];
                ++entry.first;
                entry.second = q;
            }
        }
        for (const auto &[key, entry] : count) {
            if (entry.first == 1) {
                boundary.push_back(entry.second);
            }
        }
    }
    bool place_points();
    bool find_edges();
    bool write_edges();
    bool write_faces();
    bool run();
};

bool Binder::place_points() {
    on.assign(mesh.points.size(), {3, solid});
    number.assign(mesh.points.size(), -1);
    std::vector<char> outer(mesh.points.size(), 0);
    for (const auto &q : boundary) {
        for (const auto p : q) {
            outer[at(p)] = 1;
        }
    }
    std::vector<char> laid_face(static_cast<std::size_t>(shape.faces.Extent()) + 1, 0);
    for (const auto &q : layout.quads) {
        laid_face[at(q.face)] = 1;
    }
    const std::size_t known = layout.points.size();
    std::map<int, std::vector<std::int32_t>> on_face;
    for (std::size_t p = 0; p < known; ++p) {
        if (layout.on[p].dimension == 2) {
            on_face[layout.on[p].index].push_back(static_cast<std::int32_t>(p));
        }
    }
    // Length of the shortest edge at each point.
    std::vector<double> reach(mesh.points.size(), std::numeric_limits<double>::infinity());
    for (const auto &q : boundary) {
        for (std::size_t i = 0; i < 4; ++i) {
            const std::size_t a = at(q[i]);
            const std::size_t b = at(q[(i + 1) % 4]);
            const double length = distance(mesh.points[a], mesh.points[b]);
            reach[a] = std::min(reach[a], length);
            reach[b] = std::min(reach[b], length);
        }
    }
    std::set<std::int32_t> taken;
    std::set<std::int32_t> vertices;
    for (std::size_t p = 0; p < mesh.points.size(); ++p) {
        const Vec3 place = mesh.points[p];
        if (outer[p] == 0) {
            number[p] = layout.add_point(place, {3, solid});
            continue;
        }
        on[p] = locator.at(place);
        const auto [dimension, index] = on[p];
        if (dimension == 3) {
            return refuse("a point of the swept mesh is on none of the solid's faces", 3, solid);
        }
        if (dimension == 0) {
            number[p] = layout.vertex(shape, index);
            if (!vertices.insert(index).second) {
                return refuse("two points of the swept mesh come together", 0, index);
            }
            continue;
        }
        const std::vector<std::int32_t> *there = nullptr;
        if (dimension == 1 && !layout.edges[at(index)].empty()) {
            there = &layout.edges[at(index)];
        } else if (dimension == 2 && laid_face[at(index)] != 0) {
            there = &on_face[index];
        }
        if (there == nullptr) {
            number[p] = layout.add_point(place, on[p]);
            continue;
        }
        // The nearest one; whether they are joined in the same way is seen later.
        double nearest = std::max(3 * tolerance, 0.4 * reach[p]);
        for (const auto n : *there) {
            const double away = distance(layout.points[at(n)], place);
            if (away <= nearest && layout.on[at(n)].dimension == dimension) {
                number[p] = n;
                nearest = away;
            }
        }
        if (number[p] < 0 || !taken.insert(number[p]).second) {
            return refuse("it is laid out already, with points elsewhere", dimension, index);
        }
    }
    for (const int v : locator.vertices()) {
        if (!vertices.contains(v)) {
            return refuse("the swept mesh has no point at a vertex", 0, v);
        }
    }
    return true;
}

bool Binder::find_edges() {
    std::set<Pair> seen;
    for (const auto &q : boundary) {
        for (std::size_t i = 0; i < 4; ++i) {
            const Pair key = ascending(q[i], q[(i + 1) % 4]);
            const CadEntity a = on[at(key[0])];
            const CadEntity b = on[at(key[1])];
            if (!seen.insert(key).second || a.dimension > 1 || b.dimension > 1) {
                continue;
            }
            std::vector<int> candidates;
            if (a.dimension == 1 || b.dimension == 1) {
                candidates.push_back(a.dimension == 1 ? a.index : b.index);
            } else {
                candidates = locator.edges();
            }
            const Vec3 m = middle(key);
            for (const int e : candidates) {
                const auto touches = [&](CadEntity entity) {
                    if (entity.dimension == 1) {
                        return entity.index == e;
                    }
                    const TopoDS_Edge edge = shape.edge(e);
                    return shape.vertices.FindIndex(TopExp::FirstVertex(edge)) == entity.index ||
                           shape.vertices.FindIndex(TopExp::LastVertex(edge)) == entity.index;
                };
                if (touches(a) && touches(b) && locator.on_edge(m, e)) {
                    segments[e].push_back(key);
                    edge_of[key] = e;
                    break;
                }
            }
        }
    }
    return true;
}

bool Binder::write_edges() {
    for (const int e : locator.edges()) {
        const auto &list = segments[e];
        std::map<std::int32_t, std::vector<std::int32_t>> next;
        for (const auto &[a, b] : list) {
            next[number[at(a)]].push_back(number[at(b)]);
            next[number[at(b)]].push_back(number[at(a)]);
        }
        const TopoDS_Edge edge = shape.edge(e);
        const auto first =
            layout.vertex(shape, shape.vertices.FindIndex(TopExp::FirstVertex(edge)));
        const auto last = layout.vertex(shape, shape.vertices.FindIndex(TopExp::LastVertex(edge)));
        std::vector<std::int32_t> chain{first};
        while (chain.size() <= list.size()) {
            const auto &ways = next[chain.back()];
            std::int32_t way = -1;
            for (const auto w : ways) {
                if (chain.size() < 2 || w != chain[chain.size() - 2]) {
                    way = way < 0 ? w : way;
                }
            }
            if (way < 0) {
                break;
            }
            chain.push_back(way);
        }
        if (list.empty() || chain.size() != list.size() + 1 || chain.back() != last ||
            (first == last && chain.size() < 4)) {
            return refuse("the swept mesh does not run along an edge", 1, e);
        }
        if (first == last) {
            const EdgeCurve curve(edge);
            if (curve.fraction(layout.points[at(chain[1])]) >
                curve.fraction(layout.points[at(chain[chain.size() - 2])])) {
                std::reverse(chain.begin(), chain.end());
            }
        }
        auto &written = layout.edges[at(e)];
        if (!written.empty() && written != chain) {
            return refuse("it is laid out already, otherwise than the sweep needs", 1, e);
        }
        written = chain;
    }
    return true;
}

bool Binder::write_faces() {
    std::map<int, std::set<Four>> laid;
    for (const auto &q : layout.quads) {
        laid[q.face].insert(sorted(q.points));
    }
    std::map<int, TopAbs_Orientation> orientation;
    for (TopExp_Explorer it(shape.solid(solid), TopAbs_FACE); it.More(); it.Next()) {
        orientation[shape.faces.FindIndex(it.Current())] = it.Current().Orientation();
    }
    std::set<int> covered;
    for (const auto &q : boundary) {
        std::set<int> candidates = faces_of(on[at(q[0])]);
        for (std::size_t i = 0; i < 4; ++i) {
            const auto narrow = [&](const std::set<int> &by) {
                std::erase_if(candidates, [&](int f) { return !by.contains(f); });
            };
            narrow(faces_of(on[at(q[i])]));
            const auto e = edge_of.find(ascending(q[i], q[(i + 1) % 4]));
            if (e != edge_of.end()) {
                narrow(faces_of_edge[e->second]);
            }
        }
        if (candidates.size() > 1) {
            for (std::size_t i = 0; i < 4; ++i) {
                const Vec3 m = middle(ascending(q[i], q[(i + 1) % 4]));
                std::erase_if(candidates, [&](int f) { return !locator.on_face(m, f); });
            }
        }
        if (candidates.empty()) {
            return refuse("a quad of the swept mesh is on none of the solid's faces", 3, solid);
        }
        const int face = *candidates.begin();
        covered.insert(face);
        Layout::Quad quad{{number[at(q[0])], number[at(q[1])], number[at(q[2])], number[at(q[3])]},
                          face};
        if (shape.face(face).Orientation() != orientation[face]) {
            std::swap(quad.points[1], quad.points[3]);
        }
        const auto known = laid.find(face);
        if (known == laid.end()) {
            layout.quads.push_back(quad);
        } else if (!known->second.contains(sorted(quad.points))) {
            return refuse("it is laid out already, otherwise than the sweep needs", 2, face);
        }
    }
    for (const int f : locator.faces()) {
        if (!covered.contains(f)) {
            return refuse("the swept mesh does not cover a face", 2, f);
        }
    }
    return true;
}

bool Binder::run() {
    turn();
    find_boundary();
    if (!place_points() || !find_edges() || !write_edges() || !write_faces()) {
        return false;
    }
    for (const auto &[key, m] : mesh.middles) {
        const auto a = number[at(key[0])];
        const auto b = number[at(key[1])];
        if (!edge_of.contains(key)) {
            layout.middles.emplace(ascending(a, b), m);
        }
    }
    for (const auto &h : mesh.hexas) {
        Layout::Hexa hexa{{}, solid};
        for (std::size_t i = 0; i < 8; ++i) {
            hexa.points[i] = number[at(h[i])];
        }
        layout.hexas.push_back(hexa);
    }
    return true;
}

} // namespace

bool add_hexas(const CadShape &shape, int solid, const HexaMesh &mesh, Layout &layout,
               Refusal &refusal) {
    Binder binder(shape, solid, mesh, layout, refusal);
    if (!binder.run()) {
        return false;
    }
    layout = std::move(binder.layout);
    return true;
}

} // namespace nmgs::cad
