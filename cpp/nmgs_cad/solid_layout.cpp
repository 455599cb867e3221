// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs_cad/solid_layout.h"

#include "nmgs/support/error.h"
#include "nmgs_cad/cut.h"
#include "nmgs_cad/layout_quality.h"
#include "nmgs_cad/mapped.h"
#include "nmgs_cad/midpoint.h"
#include "nmgs_cad/primitive.h"
#include "nmgs_cad/submap.h"
#include "nmgs_cad/sweep.h"

#include <BRep_Tool.hxx>
#include <TopExp.hxx>
#include <TopoDS.hxx>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>
#include <set>

namespace nmgs::cad {
namespace {

constexpr SolidStrategy strategies[] = {
    {"mapped", &fill_mapped}, {"primitive", &fill_primitive}, {"submap", &fill_submap},
    {"sweep", &fill_sweep},   {"mid-point", &fill_midpoint},  {"cut", &fill_cut},
};

// More than the volume of a coarse mesh of a round solid may be wrong by.
constexpr double volume_error = 0.1;

// Vertices, edges and faces of the solid that the layout has nothing on: what lies embedded in a
// face or in the solid, for example, where a strategy looks at boundaries only.
std::vector<std::string> uncovered(const CadShape &shape, int solid, const Layout &layout) {
    std::set<int> vertices;
    for (const CadEntity &entity : layout.on) {
        if (entity.dimension == 0) {
            vertices.insert(entity.index);
        }
    }
    std::set<int> faces;
    for (const auto &quad : layout.quads) {
        faces.insert(quad.face);
    }
    std::vector<std::string> names;
    TopTools_IndexedMapOfShape parts;
    TopExp::MapShapes(shape.solid(solid), parts);
    for (int i = 1; i <= parts.Extent(); ++i) {
        const TopoDS_Shape &part = parts(i);
        if (part.ShapeType() == TopAbs_VERTEX) {
            const int n = shape.vertices.FindIndex(part);
            if (!vertices.contains(n)) {
                names.push_back(entity_name(0, n));
            }
        } else if (part.ShapeType() == TopAbs_EDGE) {
            const int n = shape.edges.FindIndex(part);
            if (layout.edges[static_cast<std::size_t>(n)].size() < 2 &&
                !BRep_Tool::Degenerated(TopoDS::Edge(part))) {
                names.push_back(entity_name(1, n));
            }
        } else if (part.ShapeType() == TopAbs_FACE) {
            const int n = shape.faces.FindIndex(part);
            if (!faces.contains(n)) {
                names.push_back(entity_name(2, n));
            }
        }
    }
    return names;
}

struct Filling {
    Layout layout;
    FitEntry entry;
    LayoutQuality quality;
};

// Whether a is to be preferred to b.
bool better(const Filling &a, const Filling &b, double good) {
    const double qa = std::min(a.quality.worst, good);
    const double qb = std::min(b.quality.worst, good);
    return qa != qb ? qa > qb : a.entry.blocks < b.entry.blocks;
}

// The best filling of one solid, or nothing and the reasons in entry.
std::optional<Filling> fill(const CadShape &shape, int solid, const Layout &layout,
                            const SolidLayoutOptions &options, FitEntry &entry,
                            const Progress &progress) {
    std::optional<Filling> best;
    entry = {};
    entry.entity = {3, solid};
    std::set<std::string> blockers;
    for (const SolidStrategy &tried : strategies) {
        const std::string_view name = tried.name;
        const FillSolid strategy = tried.fill;
        if (options.method != "auto" && options.method != name) {
            continue;
        }
        poll(progress, 0.0);
        if (strategy == &fill_cut &&
            (!options.cuts || (best && best->quality.worst >= options.good))) {
            break; // the search for cuts is dear
        }
        const auto refuse = [&](const Refusal &refusal) {
            entry.reason +=
                (entry.reason.empty() ? "" : "; ") + std::string(name) + ": " + refusal.reason;
            blockers.insert(refusal.blockers.begin(), refusal.blockers.end());
        };
        Filling filling{layout, entry, {}};
        Refusal refusal;
        try {
            if (!strategy(shape, solid, filling.layout, options.layout, refusal, progress)) {
                refuse(refusal);
                continue;
            }
        } catch (const GeometryError &error) {
            refuse({error.what(), error.entities});
            continue;
        } catch (const Standard_Failure &failure) {
            refuse({std::string("OpenCASCADE: ") + failure.GetMessageString(), {}});
            continue;
        }
        const auto left_out = uncovered(shape, solid, filling.layout);
        if (!left_out.empty()) {
            refuse({"it would not cover " + left_out.front(), left_out});
            continue;
        }
        filling.quality = layout_quality(shape, filling.layout, layout.hexas.size());
        const double volume = std::abs(volume_of(shape.solid(solid)));
        if (filling.quality.worst <= 0) {
            refuse({"its blocks would be folded", {entity_name(3, solid)}});
            continue;
        }
        if (std::abs(filling.quality.volume - volume) > volume_error * volume) {
            refuse({"its blocks would not have the solid's volume", {entity_name(3, solid)}});
            continue;
        }
        filling.entry.method = name;
        filling.entry.quality = filling.quality.worst;
        filling.entry.blocks =
            static_cast<std::int32_t>(filling.layout.hexas.size() - layout.hexas.size());
        if (!best || better(filling, *best, options.good)) {
            best = std::move(filling);
        }
    }
    if (best) {
        best->entry.reason.clear();
        entry = best->entry;
    } else {
        entry.blockers.assign(blockers.begin(), blockers.end());
    }
    return best;
}

// Groups of solids that are joined by shared faces.
std::vector<std::vector<int>> joined(const CadShape &shape, std::span<const int> solids) {
    std::map<int, std::vector<std::size_t>> users;
    std::vector<std::size_t> root(solids.size());
    std::iota(root.begin(), root.end(), std::size_t{0});
    const auto find = [&](std::size_t n) {
        while (root[n] != n) {
            n = root[n];
        }
        return n;
    };
    for (std::size_t s = 0; s < solids.size(); ++s) {
        TopTools_IndexedMapOfShape faces;
        TopExp::MapShapes(shape.solid(solids[s]), TopAbs_FACE, faces);
        for (int f = 1; f <= faces.Extent(); ++f) {
            auto &list = users[shape.faces.FindIndex(faces(f))];
            if (!list.empty()) {
                root[find(s)] = find(list.front());
            }
            list.push_back(s);
        }
    }
    std::map<std::size_t, std::vector<int>> groups;
    for (std::size_t s = 0; s < solids.size(); ++s) {
        groups[find(s)].push_back(solids[s]);
    }
    std::vector<std::vector<int>> result;
    result.reserve(groups.size());
    for (auto &[first, group] : groups) {
        result.push_back(std::move(group));
    }
    return result;
}

// Fills the solids of a group one after the other. One that does not come to terms with what its
// neighbours laid over their common faces goes first in the next try.
bool fill_group(const CadShape &shape, std::vector<int> order, Layout &layout,
                const SolidLayoutOptions &options, std::map<int, FitEntry> &entries,
                const Progress &progress) {
    const std::vector<int> group = order;
    const std::size_t tries = group.size() == 1 ? 1 : std::min<std::size_t>(group.size() + 2, 8);
    std::map<int, FitEntry> first_reasons;
    for (std::size_t attempt = 0; attempt < tries; ++attempt) {
        Layout trial = layout;
        std::map<int, FitEntry> found;
        std::size_t done = 0;
        for (; done < order.size(); ++done) {
            FitEntry entry;
            auto filling = fill(shape, order[done], trial, options, entry, progress);
            found[order[done]] = entry;
            if (!filling) {
                break;
            }
            trial = std::move(filling->layout);
        }
        if (done == order.size()) {
            layout = std::move(trial);
            entries.merge(found);
            return true;
        }
        first_reasons.emplace(order[done], found[order[done]]);
        if (done == 0) {
            break; // not even alone
        }
        std::rotate(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(done),
                    order.begin() + static_cast<std::ptrdiff_t>(done) + 1);
    }
    const auto culprit = *first_reasons.rbegin();
    for (const int solid : group) {
        FitEntry &entry = entries[solid];
        const auto own = first_reasons.find(solid);
        if (own != first_reasons.end()) {
            entry = own->second;
            continue;
        }
        entry.entity = {3, solid};
        entry.reason = "it shares faces with " + entity_name(3, culprit.first) +
                       ", for which there is no structured strategy";
        entry.blockers = {entity_name(3, culprit.first)};
    }
    return false;
}

} // namespace

std::span<const SolidStrategy> solid_strategies() {
    return strategies;
}

std::vector<FitEntry> layout_solids(const CadShape &shape, std::span<const int> solids,
                                    Layout &layout, const SolidLayoutOptions &options,
                                    const Progress &progress) {
    if (options.method != "auto" &&
        std::none_of(std::begin(strategies), std::end(strategies),
                     [&](const SolidStrategy &s) { return s.name == options.method; })) {
        throw ArgumentError("method: " + options.method + " is not known");
    }
    std::map<int, FitEntry> entries;
    const auto groups = joined(shape, solids);
    for (std::size_t g = 0; g < groups.size(); ++g) {
        poll(progress, static_cast<double>(g) / static_cast<double>(groups.size()));
        fill_group(shape, groups[g], layout, options, entries, progress);
    }
    // Each solid's hexahedra together, in the order of the solids.
    std::map<int, std::vector<Layout::Hexa>> of;
    for (const auto &hexa : layout.hexas) {
        of[hexa.solid].push_back(hexa);
    }
    layout.hexas.clear();
    for (auto &[solid, hexas] : of) {
        const auto entry = entries.find(solid);
        if (entry != entries.end()) {
            entry->second.first_block = static_cast<std::int32_t>(layout.hexas.size());
            entry->second.blocks = static_cast<std::int32_t>(hexas.size());
        }
        layout.hexas.insert(layout.hexas.end(), hexas.begin(), hexas.end());
    }
    std::vector<FitEntry> report;
    for (const int solid : solids) {
        report.push_back(entries.at(solid));
    }
    return report;
}

} // namespace nmgs::cad
