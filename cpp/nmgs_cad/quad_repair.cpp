// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs_cad/quad_repair.h"

#include "nmgs/support/at.h"
#include "nmgs_cad/quad_smoothing.h"
#include "nmgs_cad/quad_steps.h"

#include <algorithm>
#include <limits>
#include <optional>

namespace nmgs::cad {
namespace {

using Quad = QuadSteps::Quad;
using Numbers = std::vector<std::int32_t>;

// What is wrapped: a cycle of nodes and the quads inside.
void wrap(FaceMesh &mesh, const FaceSurface &surface, const Numbers &quads) {
    std::map<std::array<std::int32_t, 2>, std::int32_t> sides;
    std::map<std::int32_t, std::int32_t> inner; // node on the cycle -> the new one inside
    Uv centre{0, 0};
    for (const std::int32_t q : quads) {
        for (std::size_t c = 0; c < 4; ++c) {
            const Quad &quad = mesh.quads[at(q)];
            sides[{quad[c], quad[(c + 1) % 4]}] = q;
            centre = centre + (0.25 / static_cast<double>(quads.size())) * mesh.uv[at(quad[c])];
        }
    }
    std::vector<Quad> ring;
    for (const auto &[ends, q] : sides) {
        if (!sides.contains({ends[1], ends[0]})) {
            for (const std::int32_t n : ends) {
                if (!inner.contains(n)) {
                    constexpr double share = 0.35;
                    inner[n] = mesh.add(surface, (1 - share) * mesh.uv[at(n)] + share * centre);
                }
            }
            ring.push_back({ends[0], ends[1], inner.at(ends[1]), inner.at(ends[0])});
        }
    }
    for (const std::int32_t q : quads) {
        for (std::int32_t &n : mesh.quads[at(q)]) {
            n = inner.contains(n) ? inner.at(n) : n;
        }
    }
    mesh.quads.insert(mesh.quads.end(), ring.begin(), ring.end());
}

double quality_of(const FaceMesh &mesh, const Quad &quad) {
    double least = 1;
    for (std::size_t c = 0; c < 4; ++c) {
        if (!unavoidable(mesh, quad, c)) {
            least = std::min(least, corner_quality(mesh, quad, c));
        }
    }
    return least;
}

// What is wrong with the mesh: quads below `good`, by how much, and much more where one would be
// folded.
double price_of(const FaceMesh &mesh, double good) {
    constexpr double sound = 0.05;
    constexpr double folded = 2;
    double sum = 0;
    for (const Quad &quad : mesh.quads) {
        const double quality = quality_of(mesh, quad);
        const double lack = std::max(0.0, good - quality) / good;
        sum += lack * lack + (quality < sound ? folded : 0);
    }
    return sum;
}

// The nodes of some quads and of those round them, layer by layer.
std::vector<char> nodes_near(const FaceMesh &mesh, const Numbers &nodes, int layers) {
    std::vector<char> near(mesh.points.size(), 0);
    for (const std::int32_t n : nodes) {
        near[at(n)] = 1;
    }
    for (int layer = 0; layer < layers; ++layer) {
        const std::vector<char> front = near;
        for (const Quad &quad : mesh.quads) {
            if (std::any_of(quad.begin(), quad.end(),
                            [&](std::int32_t n) { return front[at(n)] != 0; })) {
                for (const std::int32_t n : quad) {
                    near[at(n)] = 1;
                }
            }
        }
    }
    return near;
}

struct Repair {
    const FaceSurface &surface;
    const std::set<std::array<std::int32_t, 2>> &kept;
    double good;
    std::optional<FaceMesh> best;
    double least = 0; // price

    // Smooths a changed mesh near the nodes; it is the best if it is.
    void consider(FaceMesh mesh, const Numbers &nodes) {
        constexpr int layers = 2;
        constexpr int laplace = 2;
        constexpr int search = 12;
        const auto near = nodes_near(mesh, nodes, layers);
        std::vector<std::size_t> free;
        for (std::size_t n = 0; n < near.size(); ++n) {
            if (near[n] != 0) {
                free.push_back(n);
            }
        }
        smooth_quads(mesh, surface, laplace, search, free);
        const double price = price_of(mesh, good);
        if (price < least) {
            least = price;
            best = std::move(mesh);
        }
    }
    bool mend(FaceMesh &mesh, std::int32_t worst) {
        QuadSteps tables(mesh, surface, kept);
        const Quad quad = mesh.quads[at(worst)];
        constexpr double progress = 0.02;
        best.reset();
        least = price_of(mesh, good) - progress;
        std::vector<QuadStep> steps;
        for (std::size_t c = 0; c < 4; ++c) {
            tables.rotations(quad[c], quad[(c + 1) % 4], steps);
            tables.openings(quad[c], steps);
        }
        tables.closings(worst, steps);
        for (const QuadStep &step : steps) {
            FaceMesh changed = mesh;
            QuadSteps work(changed, surface, kept);
            const auto nodes = work.touched(step);
            work.apply(step);
            work.commit();
            Numbers present;
            std::copy_if(nodes.begin(), nodes.end(), std::back_inserter(present),
                         [&](std::int32_t n) { return work.valence(n) > 0; });
            consider(std::move(changed), present);
        }
        std::vector<Numbers> wrapped{{worst}};
        for (std::size_t c = 0; c < 4; ++c) {
            const auto beside = tables.of_edge.find({quad[(c + 1) % 4], quad[c]});
            if (beside != tables.of_edge.end() && beside->second != worst &&
                !kept.contains(
                    {std::min(quad[c], quad[(c + 1) % 4]), std::max(quad[c], quad[(c + 1) % 4])})) {
                wrapped.push_back({worst, beside->second});
            }
        }
        for (const Numbers &quads : wrapped) {
            FaceMesh changed = mesh;
            wrap(changed, surface, quads);
            consider(std::move(changed), {quad.begin(), quad.end()});
        }
        if (best) {
            mesh = std::move(*best);
        }
        return best.has_value();
    }
};

} // namespace

void repair_quads(FaceMesh &mesh, const FaceSurface &surface,
                  const std::set<std::array<std::int32_t, 2>> &kept, double good) {
    Repair repair{surface, kept, good, std::nullopt, 0};
    std::set<Quad> hopeless;
    constexpr int most = 60;
    for (int round = 0; round < most; ++round) {
        double least = good;
        std::int32_t worst = -1;
        for (std::size_t q = 0; q < mesh.quads.size(); ++q) {
            if (!hopeless.contains(mesh.quads[q])) {
                const double quality = quality_of(mesh, mesh.quads[q]);
                if (quality < least) {
                    least = quality;
                    worst = static_cast<std::int32_t>(q);
                }
            }
        }
        if (worst < 0) {
            break;
        }
        const Quad quad = mesh.quads[at(worst)];
        if (!repair.mend(mesh, worst)) {
            hopeless.insert(quad);
        }
    }
}

} // namespace nmgs::cad
