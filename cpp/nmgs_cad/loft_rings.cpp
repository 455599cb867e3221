// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs_cad/loft_rings.h"

#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>

#include <algorithm>
#include <set>

namespace nmgs::cad {
namespace {

struct Finder {
    const CadShape &shape;
    std::vector<int> faces;
    std::map<int, FaceLoops> loops;
    std::map<int, std::vector<int>> faces_of_edge;

    [[nodiscard]] int other(int edge, int face) const {
        const auto &list = faces_of_edge.at(edge);
        return list.size() != 2 || list[0] == list[1] ? 0 : list[0] == face ? list[1] : list[0];
    }
    [[nodiscard]] std::set<int> boundary(int face) const {
        std::set<int> edges;
        for (const auto &loop : loops.at(face).loops) {
            for (const auto &use : loop) {
                edges.insert(use.edge);
            }
        }
        return edges;
    }
    [[nodiscard]] bool plain(int face) const {
        const FaceLoops &all = loops.at(face);
        return all.inner.empty() &&
               std::all_of(all.loops.begin(), all.loops.end(), [](const FaceLoop &loop) {
                   return std::none_of(loop.begin(), loop.end(), [](const EdgeUse &use) {
                       return use.seam || use.degenerated;
                   });
               });
    }
    [[nodiscard]] std::optional<LoftWall> wall(int face, int low) const;
    [[nodiscard]] std::optional<LoftRings> from(int source) const;
};

std::optional<LoftWall> Finder::wall(int face, int low) const {
    const FaceLoops &all = loops.at(face);
    if (all.loops.size() != 1 || all.loops[0].size() != 4 || !all.inner.empty()) {
        return std::nullopt;
    }
    FaceLoop loop = all.loops[0];
    const auto at =
        std::find_if(loop.begin(), loop.end(), [&](const EdgeUse &use) { return use.edge == low; });
    std::rotate(loop.begin(), at, loop.end());
    const bool degenerated =
        std::any_of(loop.begin(), loop.end(), [](const EdgeUse &use) { return use.degenerated; });
    if (degenerated || loop[2].edge == low || loop[1].edge == low ||
        (loop[1].edge == loop[3].edge) != loop[1].seam) {
        return std::nullopt;
    }
    return LoftWall{face, loop[0], loop[1], loop[2], loop[3]};
}

std::optional<LoftRings> Finder::from(int source) const {
    if (!plain(source)) {
        return std::nullopt;
    }
    LoftRings result;
    result.source = source;
    std::set<int> used{source};
    std::map<int, int> front; // edges of the ring, and the face below each
    for (const int e : boundary(source)) {
        front[e] = source;
    }
    while (used.size() < faces.size()) {
        std::set<int> beyond;
        for (const auto &[e, below] : front) {
            beyond.insert(other(e, below));
        }
        if (beyond.contains(0)) {
            return std::nullopt;
        }
        if (beyond.size() == 1 && !result.rings.empty()) {
            const int target = *beyond.begin();
            const std::set<int> edges = boundary(target);
            if (!used.contains(target) && plain(target) && edges.size() == front.size() &&
                std::all_of(edges.begin(), edges.end(), [&](int e) { return front.contains(e); })) {
                used.insert(target);
                result.target = target;
                break;
            }
        }
        std::map<int, LoftWall> ring;
        std::map<int, int> next;
        for (const auto &[e, below] : front) {
            const int face = other(e, below);
            const auto found = wall(face, e);
            if (!found || !used.insert(face).second) {
                return std::nullopt;
            }
            ring[e] = *found;
            next[found->high.edge] = face;
        }
        if (next.size() != front.size()) {
            return std::nullopt;
        }
        result.rings.push_back(std::move(ring));
        front = std::move(next);
    }
    if (result.target == 0 || used.size() != faces.size()) {
        return std::nullopt;
    }
    return result;
}

} // namespace

std::optional<LoftRings> loft_rings(const CadShape &shape, int solid) {
    Finder finder{shape, {}, {}, {}};
    for (TopExp_Explorer it(shape.solid(solid), TopAbs_FACE); it.More(); it.Next()) {
        const int f = shape.faces.FindIndex(it.Current());
        Refusal refusal;
        auto loops = face_loops(shape, f, refusal);
        if (!loops || finder.loops.contains(f)) {
            return std::nullopt;
        }
        finder.faces.push_back(f);
        for (const auto &loop : loops->loops) {
            for (const auto &use : loop) {
                finder.faces_of_edge[use.edge].push_back(f);
            }
        }
        finder.loops[f] = std::move(*loops);
    }
    std::vector<int> order = finder.faces;
    std::stable_sort(order.begin(), order.end(), [&](int a, int b) {
        return finder.boundary(a).size() > finder.boundary(b).size();
    });
    for (const int f : order) {
        if (auto rings = finder.from(f)) {
            return rings;
        }
    }
    return std::nullopt;
}

} // namespace nmgs::cad
