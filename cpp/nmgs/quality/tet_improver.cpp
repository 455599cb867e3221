// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs/quality/tet_improver.h"

#include "nmgs/quality/hexas_of_tet.h"

#include <algorithm>
#include <cmath>

namespace nmgs {

TetImprover::TetImprover(TetMesh &mesh, const TetImprovementOptions &options)
    : mesh_(mesh), options_(options), of_(mesh.points.size()), quality_(mesh.tets.size()),
      on_face_(mesh.points.size(), 0), centres_(mesh.points.size()) {
    for (const auto &[ends, place] : mesh.middles) {
        middles_.emplace(key_of(ends[0], ends[1]), place);
        on_face_[at(ends[0])] = on_face_[at(ends[1])] = 1;
    }
    for (const auto &[corners, place] : mesh.centres) {
        centres_[at(corners[0])].emplace_back(corners, place);
    }
    for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
        for (const std::int32_t n : mesh.tets[t].p) {
            of_[at(n)].push_back(static_cast<std::int32_t>(t));
        }
        quality_[t] = quality(mesh.tets[t].p);
    }
}

bool TetImprover::kept(std::int32_t a, std::int32_t b) const {
    return on_face_[at(a)] != 0 && on_face_[at(b)] != 0 && middles_.contains(key_of(a, b));
}

bool TetImprover::kept(const Face &f) const {
    if (on_face_[at(f[0])] == 0 || on_face_[at(f[1])] == 0 || on_face_[at(f[2])] == 0) {
        return false;
    }
    const Face key = sorted(f);
    const auto &list = centres_[at(key[0])];
    return std::any_of(list.begin(), list.end(), [&](const auto &e) { return e.first == key; });
}

double TetImprover::quality(const Corners &p, double floor) {
    return quality_at(p, -1, {}, floor);
}

double TetImprover::quality_at(const Corners &p, std::int32_t moved, Vec3 place, double floor) {
    ++work_;
    std::array<Vec3, 4> x{};
    std::array<bool, 4> on{};
    for (std::size_t i = 0; i < 4; ++i) {
        const bool here = p[i] == moved || p[i] < 0;
        x[i] = here ? place : mesh_.points[at(p[i])];
        on[i] = !here && on_face_[at(p[i])] != 0;
    }
    if (determinant(x[1] - x[0], x[2] - x[0], x[3] - x[0]) <= 0) {
        return -1;
    }
    std::array<Vec3, 6> m{};
    for (std::size_t e = 0; e < 6; ++e) {
        const auto [a, b] = tet_edges[e];
        m[e] = 0.5 * (x[a] + x[b]);
        if (on[a] && on[b]) {
            const auto found = middles_.find(key_of(p[a], p[b]));
            if (found != middles_.end()) {
                m[e] = found->second;
            }
        }
    }
    std::array<Vec3, 4> f{};
    for (std::size_t v = 0; v < 4; ++v) {
        const auto [i, j, k] = tet_others[v];
        f[v] = (4.0 / 9) * (m[tet_edge_of[i][j]] + m[tet_edge_of[j][k]] + m[tet_edge_of[k][i]]) -
               (1.0 / 9) * (x[i] + x[j] + x[k]);
        if (on[i] && on[j] && on[k]) {
            const Face key = sorted({p[i], p[j], p[k]});
            for (const auto &[corners, centre] : centres_[at(key[0])]) {
                if (corners == key) {
                    f[v] = centre;
                }
            }
        }
    }
    return hexas_quality(x, m, f, floor);
}

std::int32_t TetImprover::beyond(std::int32_t tet, const Face &f) const {
    if (kept(f)) {
        return -1;
    }
    for (const std::int32_t t : of_[at(f[0])]) {
        const auto &p = mesh_.tets[at(t)].p;
        if (t != tet && std::find(p.begin(), p.end(), f[1]) != p.end() &&
            std::find(p.begin(), p.end(), f[2]) != p.end()) {
            return mesh_.tets[at(t)].part == mesh_.tets[at(tet)].part ? t : -1;
        }
    }
    return -1;
}

void TetImprover::replace(const std::vector<std::int32_t> &old, const std::vector<Corners> &fresh) {
    const std::int32_t part = mesh_.tets[at(old[0])].part;
    for (const std::int32_t t : old) {
        for (const std::int32_t n : mesh_.tets[at(t)].p) {
            std::erase(of_[at(n)], t);
        }
        mesh_.tets[at(t)].part = -1;
    }
    for (std::size_t i = 0; i < fresh.size(); ++i) {
        std::int32_t number = 0;
        if (i < old.size()) {
            number = old[i];
        } else {
            number = static_cast<std::int32_t>(mesh_.tets.size());
            mesh_.tets.emplace_back();
            quality_.push_back(0);
        }
        mesh_.tets[at(number)] = {fresh[i], part};
        for (const std::int32_t n : fresh[i]) {
            of_[at(n)].push_back(number);
        }
        quality_[at(number)] = quality(fresh[i]);
    }
}

} // namespace nmgs
