// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs/support/ascending.h"
#include "nmgs_cad/section.h"
#include "nmgs_cad/section_layout.h"
#include "nmgs_cad/section_neighbours.h"

#include <numbers>
#include <set>

namespace nmgs::cad {
namespace {

using Pair = std::array<std::int32_t, 2>;

// Carries quads through the levels.
struct Carrier {
    const Section &section;
    const Layout &flat;
    std::map<Pair, Vec3> flat_middles;
    HexaMesh mesh;
    std::vector<std::vector<std::int32_t>> points; // of each level, by flat point
    // Faces of the section at each flat point and edge, for levels that are not flat.
    std::map<std::int32_t, std::set<int>> faces_of_point;
    std::map<Pair, std::set<int>> faces_of_edge;

    [[nodiscard]] double level(std::size_t k) const {
        return k < section.levels.size() ? section.levels[k]
                                         : section.levels.front() + 2 * std::numbers::pi;
    }
    // The place at level k over a place of the flat layout at which these faces meet.
    [[nodiscard]] Vec3 lift(Vec3 place, const std::set<int> *faces, std::size_t k) const {
        double to = level(k);
        if (section.height) {
            double sum = 0;
            int count = 0;
            for (const int f : *faces) {
                const auto &filled = section.filled[static_cast<std::size_t>(f)];
                if ((k > 0 && filled[k - 1] != 0) || (k < filled.size() && filled[k] != 0)) {
                    const auto height = section.height(f, place, k);
                    if (height.exact) {
                        sum = height.level;
                        count = 1;
                        break;
                    }
                    sum += height.level;
                    ++count;
                }
            }
            to = count > 0 ? sum / count : to;
        }
        return section.motion.move(place, to - section.base);
    }
    std::int32_t point(std::int32_t p, std::size_t k) {
        auto &n = points[k % section.levels.size()][static_cast<std::size_t>(p)];
        if (n < 0) {
            n = static_cast<std::int32_t>(mesh.points.size());
            mesh.points.push_back(lift(flat.points[static_cast<std::size_t>(p)],
                                       section.height ? &faces_of_point.at(p) : nullptr, k));
        }
        return n;
    }
    void middle(std::int32_t a, std::int32_t b, Vec3 place) {
        const Vec3 pa = mesh.points[static_cast<std::size_t>(a)];
        const Vec3 pb = mesh.points[static_cast<std::size_t>(b)];
        if (distance(0.5 * (pa + pb), place) > 1e-9 * distance(pa, pb)) {
            mesh.middles[ascending(a, b)] = place;
        }
    }
    void carry(const Layout::Quad &quad, std::size_t k) {
        std::array<std::int32_t, 8> hexa{};
        for (std::size_t i = 0; i < 4; ++i) {
            hexa[i] = point(quad.points[i], k);
            hexa[i + 4] = point(quad.points[i], k + 1);
        }
        for (std::size_t i = 0; i < 4; ++i) {
            const auto a = quad.points[i];
            const auto b = quad.points[(i + 1) % 4];
            const Pair key = ascending(a, b);
            const Vec3 m = flat_middles.at(key);
            const auto *faces = section.height ? &faces_of_edge.at(key) : nullptr;
            middle(hexa[i], hexa[(i + 1) % 4], lift(m, faces, k));
            middle(hexa[i + 4], hexa[(i + 1) % 4 + 4], lift(m, faces, k + 1));
            if (section.motion.turn) {
                const Vec3 place = flat.points[static_cast<std::size_t>(a)];
                middle(hexa[i], hexa[i + 4],
                       section.motion.move(place, 0.5 * (level(k) + level(k + 1)) - section.base));
            }
        }
        mesh.hexas.push_back(hexa);
    }
};

// Middles of the edges of the quads, as the patches of the layout have them.
std::map<Pair, Vec3> middles_of(const CadShape &cad, const Layout &flat) {
    const CadBlocks patches = blocks_of(cad, flat, 2);
    std::map<Pair, Vec3> result;
    for (std::size_t q = 0; q < flat.quads.size(); ++q) {
        const auto &p = flat.quads[q].points;
        for (std::size_t i = 0; i < 4; ++i) {
            const auto a = p[i];
            const auto b = p[(i + 1) % 4];
            result[ascending(a, b)] = patches.model.nodes[8 * q + 4 + i];
        }
    }
    return result;
}

} // namespace

bool sweep_section(const CadShape &shape, int solid, const Section &section, Layout &layout,
                   const LayoutOptions &options, Refusal &refusal, const Progress &progress) {
    Layout flat(section.cad);
    take_over(shape, solid, section, layout, flat);
    if (!layout_section(section.cad, flat, options, refusal, progress)) {
        return false;
    }
    return add_hexas(shape, solid, carry_section(section, flat).mesh, layout, refusal);
}

Carried carry_section(const Section &section, const Layout &flat) {
    Carrier carrier{section, flat, middles_of(section.cad, flat), {}, {}, {}, {}};
    if (section.height) {
        for (const auto &quad : flat.quads) {
            for (std::size_t i = 0; i < 4; ++i) {
                const auto a = quad.points[i];
                const auto b = quad.points[(i + 1) % 4];
                carrier.faces_of_point[a].insert(quad.face);
                carrier.faces_of_edge[ascending(a, b)].insert(quad.face);
            }
        }
    }
    carrier.points.assign(section.levels.size(), std::vector<std::int32_t>(flat.points.size(), -1));
    const std::size_t intervals = section.levels.size() - (section.closed ? 0 : 1);
    for (const auto &quad : flat.quads) {
        for (std::size_t k = 0; k < intervals; ++k) {
            if (section.filled[static_cast<std::size_t>(quad.face)][k] != 0) {
                carrier.carry(quad, k);
            }
        }
    }
    return {std::move(carrier.mesh), std::move(carrier.points)};
}

} // namespace nmgs::cad
