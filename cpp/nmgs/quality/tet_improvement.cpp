// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs/quality/tet_improvement.h"

#include "nmgs/quality/hexas_of_tet.h"
#include "nmgs/quality/tet_improver.h"

#include <algorithm>

namespace nmgs {

// Tries what may help a tetrahedron that is worse than `good`, the cheapest first.
void TetImprover::mend(std::int32_t t, double good) {
    const auto still = [&] { return alive(t) && quality_[at(t)] < good; };
    const Corners p = mesh_.tets[at(t)].p;
    const auto same = [&] { return still() && mesh_.tets[at(t)].p == p; };
    for (std::size_t e = 0; e < 6 && same(); ++e) {
        remove_edge(t, e);
    }
    for (std::size_t v = 0; v < 4 && same(); ++v) {
        flip_face(t, v);
    }
    for (std::size_t v = 0; v < 4 && still(); ++v) {
        smooth(mesh_.tets[at(t)].p[v], 12);
    }
    // New points only where nothing else has helped.
    constexpr double poor = 0.8;
    if (!still() || quality_[at(t)] > poor * good) {
        return;
    }
    if (!fill_cavity({t}) && same()) {
        for (const auto &[a, b] : tet_edges) {
            std::vector<std::int32_t> ring;
            if (same() && !kept(p[a], p[b]) && around(p[a], p[b], ring)) {
                fill_cavity(ring);
            }
        }
    }
}

double TetImprover::run(const Progress &progress) {
    const auto lacking = [&] {
        double lack = 0;
        for (std::size_t t = 0; t < mesh_.tets.size(); ++t) {
            if (mesh_.tets[t].part >= 0) {
                lack += std::max(0.0, options_.good - quality_[t]);
            }
        }
        return lack;
    };
    constexpr long least_work = 1'000'000;
    constexpr long work_each = 250;
    constexpr long most_work = 4'000'000;
    const long limit =
        options_.work > 0
            ? options_.work
            : std::min(least_work + work_each * static_cast<long>(mesh_.tets.size()), most_work);
    double last = lacking();
    for (int round = 0; round < options_.rounds && work_ < limit; ++round) {
        // What is worst first, all over the mesh.
        constexpr std::array<double, 4> stages{0.3, 0.5, 0.8, 1};
        const double good =
            options_.good * stages[std::min<std::size_t>(static_cast<std::size_t>(round), 3)];
        std::vector<std::pair<double, std::int32_t>> bad;
        for (std::size_t t = 0; t < mesh_.tets.size(); ++t) {
            if (mesh_.tets[t].part >= 0 && quality_[t] < good) {
                bad.emplace_back(quality_[t], static_cast<std::int32_t>(t));
            }
        }
        std::sort(bad.begin(), bad.end());
        for (std::size_t i = 0; i < bad.size() && work_ < limit; ++i) {
            if (i % 16 == 0) {
                poll(progress, static_cast<double>(round) / options_.rounds);
            }
            mend(bad[i].second, good);
        }
        const double now = lacking();
        if (round > 3 && now > 0.97 * last) {
            break;
        }
        last = now;
    }
    std::erase_if(mesh_.tets, [](const TetMesh::Tet &t) { return t.part < 0; });
    double worst = 1;
    for (const auto &t : mesh_.tets) {
        worst = std::min(worst, quality(t.p));
    }
    return worst;
}

double improve_tets(TetMesh &mesh, const TetImprovementOptions &options, const Progress &progress) {
    return TetImprover(mesh, options).run(progress);
}

} // namespace nmgs
