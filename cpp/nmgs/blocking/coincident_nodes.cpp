// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs/blocking/coincident_nodes.h"

#include "nmgs/mesh/point_hash.h"
#include "nmgs/support/near_boxes.h"
#include "nmgs/support/parallel.h"

#include <algorithm>
#include <limits>

namespace nmgs {
namespace {

// A face of a block, or edge of a patch, that no other shares.
struct Entity {
    std::size_t block;
    int code;
    std::vector<std::int32_t> nodes;
    Box box;
};

std::vector<Entity> unmatched(const BlockModel &model, const Topology &topology) {
    std::vector<Entity> entities;
    for (std::size_t b = 0; b < model.size(); ++b) {
        for (int code = 0; code < (model.dimension == 2 ? 9 : part::count); ++code) {
            if (part::dimension(code) == model.dimension - 1 && topology.owns(b, code) &&
                topology.uses[b * part::count + static_cast<std::size_t>(code)] == 1) {
                entities.push_back({b, code, {}, {}});
            }
        }
    }
    return entities;
}

void load(Entity &entity, const Lattice &lattice, std::span<const Vec3> points) {
    const auto g = lattice.divisions(entity.block);
    const auto digits = part::digits(entity.code);
    LatticeIndex low{};
    LatticeIndex high{};
    for (std::size_t d = 0; d < 3; ++d) {
        low[d] = digits[d] == 2 ? g[d] : 0;
        high[d] = digits[d] == 0 ? 0 : g[d];
    }
    for (std::int32_t k = low[2]; k <= high[2]; ++k) {
        for (std::int32_t j = low[1]; j <= high[1]; ++j) {
            for (std::int32_t i = low[0]; i <= high[0]; ++i) {
                const auto node = static_cast<std::int32_t>(lattice.node(entity.block, {i, j, k}));
                entity.nodes.push_back(node);
                entity.box.add(points[static_cast<std::size_t>(node)]);
            }
        }
    }
}

} // namespace

Coincidences find_coincident_nodes(const BlockModel &model, const Topology &topology,
                                   const Lattice &lattice, std::span<const Vec3> points) {
    auto entities = unmatched(model, topology);
    parallel_for(entities.size(), 1, [&](std::size_t first, std::size_t last) {
        for (std::size_t e = first; e < last; ++e) {
            load(entities[e], lattice, points);
        }
    });
    std::vector<Box> boxes;
    boxes.reserve(entities.size());
    for (const Entity &entity : entities) {
        boxes.push_back(entity.box);
    }
    const double tolerance = topology.tolerance;
    std::vector<std::vector<std::size_t>> near(entities.size());
    for (const auto &[a, b] : near_boxes(boxes, tolerance)) {
        if (entities[a].block != entities[b].block) {
            near[a].push_back(b);
            near[b].push_back(a);
        }
    }
    std::vector<std::vector<std::int32_t>> found(entities.size());
    parallel_for(entities.size(), 1, [&](std::size_t first, std::size_t last) {
        for (std::size_t e = first; e < last; ++e) {
            for (const std::int32_t node : entities[e].nodes) {
                const Vec3 place = points[static_cast<std::size_t>(node)];
                if (std::any_of(near[e].begin(), near[e].end(), [&](std::size_t other) {
                        return boxes[other].near(place, tolerance);
                    })) {
                    found[e].push_back(node);
                }
            }
        }
    });
    std::vector<std::int32_t> candidates;
    for (const auto &nodes : found) {
        candidates.insert(candidates.end(), nodes.begin(), nodes.end());
    }
    std::sort(candidates.begin(), candidates.end());
    candidates.erase(std::unique(candidates.begin(), candidates.end()), candidates.end());

    std::vector<std::pair<std::int32_t, std::int32_t>> same; // dropped node, lower node
    PointHash hash(tolerance);
    hash.reserve(candidates.size());
    for (const std::int32_t node : candidates) {
        const Vec3 p = points[static_cast<std::size_t>(node)];
        const std::int64_t lower = hash.find(p);
        if (lower >= 0) {
            same.emplace_back(node, static_cast<std::int32_t>(lower));
        } else {
            hash.insert(p, node);
        }
    }
    Coincidences result;
    result.remaining = static_cast<std::int64_t>(points.size() - same.size());
    if (same.empty()) {
        return result;
    }
    result.number = Array<std::int32_t>(points.size());
    std::size_t next = 0;
    for (std::size_t n = 0; n < points.size(); ++n) {
        if (next < same.size() && static_cast<std::size_t>(same[next].first) == n) {
            result.number[n] = result.number[static_cast<std::size_t>(same[next].second)];
            ++next;
        } else {
            result.number[n] = static_cast<std::int32_t>(n - next);
        }
    }
    return result;
}

void apply(const Coincidences &coincidences, Mesh &mesh) {
    if (coincidences.number.empty()) {
        return;
    }
    // A kept node's new number is the highest so far; a dropped one's was seen before.
    std::int32_t highest = -1;
    for (std::size_t n = 0; n < mesh.points.size(); ++n) {
        if (coincidences.number[n] > highest) {
            highest = coincidences.number[n];
            mesh.points[static_cast<std::size_t>(highest)] = mesh.points[n];
        }
    }
    mesh.points.shrink(static_cast<std::size_t>(coincidences.remaining));
    for (CellBlock &block : mesh.cells) {
        parallel_for(
            block.nodes.size(), std::size_t{1} << 16, [&](std::size_t first, std::size_t last) {
                for (std::size_t i = first; i < last; ++i) {
                    block.nodes[i] = coincidences.number[static_cast<std::size_t>(block.nodes[i])];
                }
            });
    }
}

} // namespace nmgs
