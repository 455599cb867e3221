// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs_cad/quad_repair.h"

#include "nmgs/support/ascending.h"
#include "nmgs/support/at.h"
#include "nmgs_cad/quad_smoothing.h"
#include "nmgs_cad/quad_steps.h"

#include <algorithm>
#include <map>
#include <numbers>

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

// The quads round one of a mesh as a mesh of their own; its rim inside the whole is fixed.
struct Part {
    FaceMesh mesh;
    Numbers nodes; // in the whole
    Numbers quads; // there
    std::set<std::array<std::int32_t, 2>> kept;
};

Part part_round(const FaceMesh &whole, std::int32_t quad,
                const std::set<std::array<std::int32_t, 2>> &kept) {
    constexpr int layers = 3;
    const Quad &middle = whole.quads[at(quad)];
    const auto near = nodes_near(whole, {middle.begin(), middle.end()}, layers);
    Part part;
    std::vector<std::int32_t> local(whole.points.size(), -1);
    std::vector<char> rim(whole.points.size(), 0);
    for (std::size_t q = 0; q < whole.quads.size(); ++q) {
        const auto inside = [&](std::int32_t n) { return near[at(n)] != 0; };
        Quad nodes = whole.quads[q];
        if (std::all_of(nodes.begin(), nodes.end(), inside)) {
            for (std::int32_t &n : nodes) {
                if (local[at(n)] < 0) {
                    local[at(n)] = static_cast<std::int32_t>(part.nodes.size());
                    part.nodes.push_back(n);
                }
                n = local[at(n)];
            }
            part.quads.push_back(static_cast<std::int32_t>(q));
            part.mesh.quads.push_back(nodes);
        } else {
            for (const std::int32_t n : nodes) {
                rim[at(n)] = 1;
            }
        }
    }
    FaceMesh &mesh = part.mesh;
    const auto number = [&](std::int32_t n) { return n < 0 ? n : local[at(n)]; };
    for (const std::int32_t n : part.nodes) {
        mesh.points.push_back(whole.points[at(n)]);
        mesh.uv.push_back(whole.uv[at(n)]);
        mesh.normals.push_back(whole.normals[at(n)]);
        const bool cut = rim[at(n)] != 0 && !whole.fixed(n);
        mesh.layout_point.push_back(cut ? 0 : whole.layout_point[at(n)]);
        FaceMesh::Rim own = whole.rim[at(n)];
        own.before = number(own.before);
        own.after = number(own.after);
        own.angle = cut ? 2 * std::numbers::pi : own.angle;
        mesh.rim.push_back(own);
    }
    for (const auto &[a, b] : kept) {
        if (local[at(a)] >= 0 && local[at(b)] >= 0) {
            part.kept.insert(ascending(local[at(a)], local[at(b)]));
        }
    }
    return part;
}

// Puts a changed part back.
void replace(FaceMesh &whole, const Part &part, const FaceMesh &changed) {
    Numbers nodes = part.nodes;
    for (std::size_t n = 0; n < changed.points.size(); ++n) {
        if (n == nodes.size()) {
            nodes.push_back(static_cast<std::int32_t>(whole.points.size()));
            whole.points.emplace_back();
            whole.uv.emplace_back();
            whole.normals.emplace_back();
            whole.layout_point.push_back(-1);
            whole.rim.emplace_back();
        }
        const std::size_t to = at(nodes[n]);
        whole.points[to] = changed.points[n];
        whole.uv[to] = changed.uv[n];
        whole.normals[to] = changed.normals[n];
    }
    for (const std::int32_t q : part.quads) {
        whole.quads[at(q)][0] = -1;
    }
    std::erase_if(whole.quads, [](const Quad &q) { return q[0] < 0; });
    for (Quad quad : changed.quads) {
        for (std::int32_t &n : quad) {
            n = nodes[at(n)];
        }
        whole.quads.push_back(quad);
    }
}

struct Candidate {
    FaceMesh mesh;
    Numbers nodes; // that the change touched
    double price;
};

void smooth_near(FaceMesh &mesh, const FaceSurface &surface, const Numbers &nodes, int layers,
                 int laplace, int search) {
    const auto near = nodes_near(mesh, nodes, layers);
    std::vector<std::size_t> free;
    for (std::size_t n = 0; n < near.size(); ++n) {
        if (near[n] != 0) {
            free.push_back(n);
        }
    }
    smooth_quads(mesh, surface, laplace, search, free);
}

// Every change at a quad of the part, roughly smoothed.
std::vector<Candidate> candidates(const Part &part, const FaceSurface &surface, std::int32_t worst,
                                  double good) {
    std::vector<Candidate> result;
    const auto add = [&](FaceMesh mesh, Numbers nodes) {
        constexpr int laplace = 2;
        constexpr int search = 1;
        smooth_near(mesh, surface, nodes, 1, laplace, search);
        const double price = price_of(mesh, good);
        result.push_back({std::move(mesh), std::move(nodes), price});
    };
    FaceMesh mesh = part.mesh;
    QuadSteps tables(mesh, surface, part.kept);
    const Quad quad = mesh.quads[at(worst)];
    std::vector<QuadStep> steps;
    for (std::size_t c = 0; c < 4; ++c) {
        tables.rotations(quad[c], quad[(c + 1) % 4], steps);
        tables.openings(quad[c], steps);
    }
    tables.closings(worst, steps);
    for (const QuadStep &step : steps) {
        FaceMesh changed = mesh;
        QuadSteps work(changed, surface, part.kept);
        Numbers nodes = work.touched(step);
        work.apply(step);
        work.commit();
        std::erase_if(nodes, [&](std::int32_t n) { return work.valence(n) == 0; });
        add(std::move(changed), std::move(nodes));
    }
    std::vector<Numbers> wrapped{{worst}};
    for (std::size_t c = 0; c < 4; ++c) {
        const std::int32_t a = quad[c];
        const std::int32_t b = quad[(c + 1) % 4];
        const auto beside = tables.of_edge.find({b, a});
        if (beside != tables.of_edge.end() && beside->second != worst &&
            !part.kept.contains(ascending(a, b))) {
            wrapped.push_back({worst, beside->second});
        }
    }
    for (const Numbers &quads : wrapped) {
        FaceMesh changed = mesh;
        wrap(changed, surface, quads);
        add(std::move(changed), {quad.begin(), quad.end()});
    }
    return result;
}

bool mend(FaceMesh &mesh, const FaceSurface &surface,
          const std::set<std::array<std::int32_t, 2>> &kept, std::int32_t worst, double good) {
    const Part part = part_round(mesh, worst, kept);
    const auto place = std::find(part.quads.begin(), part.quads.end(), worst) - part.quads.begin();
    auto all = candidates(part, surface, static_cast<std::int32_t>(place), good);
    constexpr double progress = 0.02;
    double least = price_of(part.mesh, good) - progress;
    std::stable_sort(all.begin(), all.end(),
                     [](const Candidate &a, const Candidate &b) { return a.price < b.price; });
    constexpr std::size_t most = 3;
    const FaceMesh *best = nullptr;
    for (std::size_t i = 0; i < std::min(most, all.size()); ++i) {
        constexpr int layers = 2;
        constexpr int search = 10;
        smooth_near(all[i].mesh, surface, all[i].nodes, layers, 1, search);
        const double price = price_of(all[i].mesh, good);
        if (price < least) {
            least = price;
            best = &all[i].mesh;
        }
    }
    if (best != nullptr) {
        replace(mesh, part, *best);
    }
    return best != nullptr;
}

} // namespace

void repair_quads(FaceMesh &mesh, const FaceSurface &surface,
                  const std::set<std::array<std::int32_t, 2>> &kept, double good) {
    std::set<Quad> hopeless;
    constexpr int most = 40;
    // The worst quads count: where these cannot be mended the others are of no use.
    constexpr std::size_t patience = 8;
    for (int round = 0; round < most && hopeless.size() < patience; ++round) {
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
        if (!mend(mesh, surface, kept, worst, good)) {
            hopeless.insert(quad);
        }
    }
}

} // namespace nmgs::cad
