// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs/plc/mend.h"

#include "nmgs/plc/surface.h"
#include "nmgs/plc/welded.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>

namespace nmgs {
namespace {

using Polygon = std::vector<std::int32_t>;
using EdgeKey = std::pair<std::int32_t, std::int32_t>;

// A PLC in a form that can be changed.
struct Loose {
    std::vector<std::vector<Polygon>> facets;
    std::vector<std::int32_t> number; // of the facet in the old PLC
};

Loose loosen(const Plc &plc) {
    Loose loose;
    for (std::size_t f = 0; f < plc.facet_count(); ++f) {
        std::vector<Polygon> polygons;
        for (std::int64_t p = plc.facet_offsets[f]; p < plc.facet_offsets[f + 1]; ++p) {
            const auto at = static_cast<std::size_t>(p);
            const auto begin = plc.polygon_nodes.begin();
            Polygon nodes(begin + plc.polygon_offsets[at], begin + plc.polygon_offsets[at + 1]);
            if (nodes.size() > 2) {
                nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
                while (nodes.size() > 1 && nodes.front() == nodes.back()) {
                    nodes.pop_back();
                }
            }
            polygons.push_back(std::move(nodes));
        }
        loose.facets.push_back(std::move(polygons));
        loose.number.push_back(static_cast<std::int32_t>(f));
    }
    return loose;
}

// The PLC with these facets; markers and holes of facets come along.
Plc tighten(const Plc &old, const Loose &loose) {
    Plc plc = old;
    plc.polygon_nodes.clear();
    plc.polygon_offsets = {0};
    plc.facet_offsets = {0};
    plc.facet_markers.clear();
    plc.facet_holes.clear();
    plc.facet_hole_offsets = {0};
    for (std::size_t f = 0; f < loose.facets.size(); ++f) {
        const auto from = static_cast<std::size_t>(loose.number[f]);
        for (const Polygon &polygon : loose.facets[f]) {
            plc.polygon_nodes.insert(plc.polygon_nodes.end(), polygon.begin(), polygon.end());
            plc.end_polygon();
        }
        for (std::int64_t h = old.facet_hole_offsets[from]; h < old.facet_hole_offsets[from + 1];
             ++h) {
            plc.facet_holes.push_back(old.facet_holes[static_cast<std::size_t>(h)]);
        }
        plc.end_facet();
        if (!old.facet_markers.empty()) {
            plc.facet_markers.push_back(old.facet_markers[from]);
        }
    }
    return plc;
}

void drop_points(Plc &plc, const std::vector<std::int32_t> &first) {
    std::vector<std::int32_t> place(plc.points.size(), -1);
    Plc kept;
    const auto k = static_cast<std::size_t>(plc.attribute_count);
    for (std::size_t i = 0; i < plc.points.size(); ++i) {
        if (first[i] != static_cast<std::int32_t>(i)) {
            continue;
        }
        place[i] = static_cast<std::int32_t>(kept.points.size());
        kept.points.push_back(plc.points[i]);
        if (!plc.point_markers.empty()) {
            kept.point_markers.push_back(plc.point_markers[i]);
        }
        for (std::size_t a = 0; a < k; ++a) {
            kept.point_attributes.push_back(plc.point_attributes[i * k + a]);
        }
    }
    plc.points = std::move(kept.points);
    plc.point_markers = std::move(kept.point_markers);
    plc.point_attributes = std::move(kept.point_attributes);
    for (std::int32_t &node : plc.polygon_nodes) {
        node = place[static_cast<std::size_t>(first[static_cast<std::size_t>(node)])];
    }
}

// Middle points of triangles that are lines, by the line's ends.
std::map<EdgeKey, std::int32_t> slivers(const Welded &welded, const Loose &loose) {
    std::map<EdgeKey, std::int32_t> middles;
    for (std::size_t f = 0; f < loose.facets.size(); ++f) {
        if (!welded.degenerate(f) || loose.facets[f].size() != 1 ||
            loose.facets[f][0].size() != 3) {
            continue;
        }
        const Polygon &n = loose.facets[f][0];
        std::array<double, 3> length{};
        for (std::size_t k = 0; k < 3; ++k) {
            length[k] = distance(welded.point(n[(k + 1) % 3]), welded.point(n[(k + 2) % 3]));
        }
        const auto m = static_cast<std::size_t>(std::max_element(length.begin(), length.end()) -
                                                length.begin());
        middles.try_emplace(std::minmax(n[(m + 1) % 3], n[(m + 2) % 3]), n[m]);
    }
    return middles;
}

// Puts the middle points into the edges that they lie on, until no edge has one.
void insert_middles(Polygon &polygon, const std::map<EdgeKey, std::int32_t> &middles) {
    if (polygon.size() < 3) {
        return;
    }
    std::size_t k = 0;
    std::size_t guard = polygon.size() + 2 * middles.size();
    while (k < polygon.size() && guard-- > 0) {
        const std::int32_t a = polygon[k];
        const std::int32_t b = polygon[(k + 1) % polygon.size()];
        const auto found = middles.find(std::minmax(a, b));
        if (found != middles.end() &&
            std::find(polygon.begin(), polygon.end(), found->second) == polygon.end()) {
            polygon.insert(polygon.begin() + static_cast<std::ptrdiff_t>(k) + 1, found->second);
        } else {
            ++k;
        }
    }
}

void remove_facets(Loose &loose, const Welded &welded, std::vector<std::string> &done) {
    const auto middles = slivers(welded, loose);
    Loose kept;
    std::set<std::vector<Polygon>> seen;
    std::size_t thin = 0;
    std::size_t twice = 0;
    for (std::size_t f = 0; f < loose.facets.size(); ++f) {
        if (welded.degenerate(f)) {
            ++thin;
            continue;
        }
        auto key = loose.facets[f];
        for (Polygon &polygon : key) {
            std::sort(polygon.begin(), polygon.end());
        }
        if (!seen.insert(std::move(key)).second) {
            ++twice;
            continue;
        }
        for (Polygon &polygon : loose.facets[f]) {
            insert_middles(polygon, middles);
        }
        kept.facets.push_back(std::move(loose.facets[f]));
        kept.number.push_back(loose.number[f]);
    }
    loose = std::move(kept);
    if (thin > 0) {
        done.push_back("removed " + std::to_string(thin) + " facets without area");
    }
    if (twice > 0) {
        done.push_back("removed " + std::to_string(twice) + " duplicate facets");
    }
}

void orient(Loose &loose, const Plc &plc, double tolerance, const Progress &progress,
            std::vector<std::string> &done) {
    const Welded welded(plc, tolerance, progress);
    std::vector<Box> boxes;
    for (std::size_t f = 0; f < plc.facet_count(); ++f) {
        boxes.push_back(welded.box(f));
    }
    const BoxTree tree(boxes);
    const Surfaces surfaces = surfaces_of(welded);
    const std::vector<bool> wrong = inside_out(welded, tree, surfaces);
    std::size_t turned = 0;
    for (std::size_t f = 0; f < loose.facets.size(); ++f) {
        const auto s = static_cast<std::size_t>(surfaces.of_facet[f]);
        if (surfaces.oriented[s] && surfaces.flipped[f] != wrong[s]) {
            for (Polygon &polygon : loose.facets[f]) {
                std::reverse(polygon.begin(), polygon.end());
            }
            ++turned;
        }
    }
    if (turned > 0) {
        done.push_back("turned " + std::to_string(turned) + " facets");
    }
}

} // namespace

Mended mend(const Plc &plc, const CheckOptions &options, const Progress &progress) {
    Mended mended;
    const double tolerance = tolerance_of(plc, options);
    const Welded welded(plc, tolerance, progress);
    Loose loose = loosen(welded.plc);
    remove_facets(loose, welded, mended.done);
    orient(loose, tighten(plc, loose), tolerance, progress, mended.done);
    mended.plc = tighten(plc, loose);
    mended.facet_of = loose.number;
    drop_points(mended.plc, welded.first);
    const std::size_t merged = plc.points.size() - mended.plc.points.size();
    if (merged > 0) {
        mended.done.insert(mended.done.begin(),
                           "merged " + std::to_string(merged) + " duplicate points");
    }
    return mended;
}

} // namespace nmgs
