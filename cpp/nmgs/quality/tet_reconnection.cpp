// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs/quality/hexas_of_tet.h"
#include "nmgs/quality/tet_improver.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace nmgs {

// The tetrahedra round an edge; false where they do not close, or are of two parts.
bool TetImprover::around(std::int32_t a, std::int32_t b, std::vector<std::int32_t> &tets) const {
    for (const std::int32_t t : of_[at(a)]) {
        const auto &p = mesh_.tets[at(t)].p;
        if (std::find(p.begin(), p.end(), b) != p.end()) {
            if (!tets.empty() && mesh_.tets[at(t)].part != mesh_.tets[at(tets[0])].part) {
                return false;
            }
            tets.push_back(t);
        }
    }
    return tets.size() > 2;
}

bool TetImprover::remove_edge(std::int32_t tet, std::size_t edge) {
    const std::int32_t a = mesh_.tets[at(tet)].p[tet_edges[edge][0]];
    const std::int32_t b = mesh_.tets[at(tet)].p[tet_edges[edge][1]];
    constexpr std::size_t most = 8;
    std::vector<std::int32_t> tets;
    if (kept(a, b) || !around(a, b, tets) || tets.size() > most) {
        return false;
    }
    double floor = 1;
    // Each tetrahedron (a, b, x, y), positive, leads from x to y.
    std::vector<std::array<std::int32_t, 2>> steps;
    for (const std::int32_t t : tets) {
        floor = std::min(floor, quality_[at(t)]);
        const auto &p = mesh_.tets[at(t)].p;
        for (std::size_t v = 0; v < 4; ++v) {
            if (p[v] != a) {
                continue;
            }
            const auto &o = tet_others[v];
            for (std::size_t i = 0; i < 3; ++i) {
                if (p[o[i]] == b) {
                    steps.push_back({p[o[(i + 1) % 3]], p[o[(i + 2) % 3]]});
                }
            }
        }
    }
    std::vector<std::int32_t> ring{steps[0][0]};
    for (std::size_t k = 0; k < steps.size(); ++k) {
        const auto next = std::find_if(steps.begin(), steps.end(),
                                       [&](const auto &s) { return s[0] == ring.back(); });
        if (next == steps.end()) {
            return false;
        }
        if ((*next)[1] == ring[0]) {
            break;
        }
        ring.push_back((*next)[1]);
    }
    const std::size_t n = ring.size();
    if (n != tets.size()) {
        return false;
    }
    // Best worst of the polygon from i to j, and the third corner there.
    std::array<std::array<double, most>, most> best{};
    std::array<std::array<std::size_t, most>, most> third{};
    for (std::size_t i = 0; i + 1 < n; ++i) {
        best[i][i + 1] = 1;
    }
    for (std::size_t span = 2; span < n; ++span) {
        for (std::size_t i = 0; i + span < n; ++i) {
            const std::size_t j = i + span;
            best[i][j] = -2;
            for (std::size_t k = i + 1; k < j; ++k) {
                double q = std::min(best[i][k], best[k][j]);
                const double bar = std::max(floor, best[i][j]);
                if (q <= bar) {
                    continue;
                }
                q = std::min(q, quality({ring[i], ring[k], ring[j], b}, bar));
                q = q > bar ? std::min(q, quality({ring[i], ring[j], ring[k], a}, bar)) : q;
                if (q > best[i][j]) {
                    best[i][j] = q;
                    third[i][j] = k;
                }
            }
        }
    }
    if (best[0][n - 1] <= floor) {
        return false;
    }
    std::vector<Corners> fresh;
    std::vector<std::array<std::size_t, 2>> work{{0, n - 1}};
    while (!work.empty()) {
        const auto [i, j] = work.back();
        work.pop_back();
        if (j < i + 2) {
            continue;
        }
        const std::size_t k = third[i][j];
        fresh.push_back({ring[i], ring[k], ring[j], b});
        fresh.push_back({ring[i], ring[j], ring[k], a});
        work.push_back({i, k});
        work.push_back({k, j});
    }
    replace(tets, fresh);
    return true;
}

// Two tetrahedra become three round a new edge.
bool TetImprover::flip_face(std::int32_t tet, std::size_t opposite) {
    const Corners p = mesh_.tets[at(tet)].p;
    const auto [i, j, k] = tet_others[opposite];
    const Face f{p[i], p[j], p[k]};
    const std::int32_t other = beyond(tet, f);
    if (other < 0) {
        return false;
    }
    const double floor = std::min(quality_[at(tet)], quality_[at(other)]);
    std::int32_t far = -1;
    for (const std::int32_t n : mesh_.tets[at(other)].p) {
        far = std::find(f.begin(), f.end(), n) == f.end() ? n : far;
    }
    if (kept(p[opposite], far)) {
        return false; // it is an edge elsewhere
    }
    std::vector<Corners> fresh;
    for (std::size_t s = 0; s < 3; ++s) {
        fresh.push_back({p[opposite], f[s], f[(s + 1) % 3], far});
        if (quality(fresh.back(), floor) <= floor) {
            return false;
        }
    }
    replace({tet, other}, fresh);
    return true;
}

} // namespace nmgs
