// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs_cad/solid_layout.h"

#include "nmgs/support/error.h"
#include "nmgs_cad/cut.h"
#include "nmgs_cad/layout_quality.h"
#include "nmgs_cad/mapped.h"
#include "nmgs_cad/midpoint.h"
#include "nmgs_cad/midpoint_obstacles.h"
#include "nmgs_cad/primitive.h"
#include "nmgs_cad/solid_groups.h"
#include "nmgs_cad/solid_likeness.h"
#include "nmgs_cad/submap.h"
#include "nmgs_cad/sweep.h"

#include <BRep_Tool.hxx>
#include <TopExp.hxx>
#include <TopoDS.hxx>

#include <algorithm>
#include <cmath>
#include <map>
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
// A worst scaled Jacobian that finer divisions may turn over.
constexpr double folded = 0.01;

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
        if (best && best->quality.reaches(options.good) &&
            (strategy == &fill_cut || best->entry.blocks == 1)) {
            break; // the search for cuts is dear; there are no fewer blocks than one
        }
        if (strategy == &fill_cut && !options.cuts) {
            break;
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
        if (filling.quality.worst <= folded) {
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

// What became of a group of solids.
struct GroupFilling {
    std::optional<Layout> layout;
    std::map<int, FitEntry> entries; // of its solids; where there is no layout, of some
    int culprit = 0;                 // the one that could not be filled last
    bool alone = false;              // not even by itself

    [[nodiscard]] double worst() const {
        double least = layout ? 1 : -1;
        for (const auto &[solid, entry] : entries) {
            least = layout ? std::min(least, entry.quality) : least;
        }
        return least;
    }
};

// Fills the solids of a group one after the other. One that does not come to terms with what its
// neighbours laid over their common faces goes first in the next try.
GroupFilling fill_in_turn(const CadShape &shape, std::vector<int> order, const Layout &layout,
                          const SolidLayoutOptions &options, std::size_t tries,
                          const Progress &progress) {
    GroupFilling result;
    std::set<std::vector<int>> tried;
    for (std::size_t attempt = 0; attempt < tries && tried.insert(order).second; ++attempt) {
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
            result.layout = std::move(trial);
            result.entries = std::move(found);
            return result;
        }
        result.culprit = order[done];
        result.entries.emplace(order[done], found[order[done]]);
        result.alone = done == 0;
        if (result.alone) {
            break;
        }
        std::rotate(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(done),
                    order.begin() + static_cast<std::ptrdiff_t>(done) + 1);
    }
    return result;
}

// Cuts all solids of a group by the same planes and cylinders.
GroupFilling fill_together(const CadShape &shape, const std::vector<int> &group,
                           const Layout &layout, const SolidLayoutOptions &options,
                           const Progress &progress) {
    GroupFilling result;
    Layout trial = layout;
    Refusal refusal;
    bool filled = false;
    try {
        filled = cut_solids(shape, group, trial, options.layout, refusal, progress);
    } catch (const GeometryError &error) {
        refusal = {error.what(), error.entities};
    } catch (const Standard_Failure &failure) {
        refusal = {std::string("OpenCASCADE: ") + failure.GetMessageString(), {}};
    }
    double volume = 0;
    for (const int solid : group) {
        volume += std::abs(volume_of(shape.solid(solid)));
        if (filled && !uncovered(shape, solid, trial).empty()) {
            const auto names = uncovered(shape, solid, trial);
            refusal = {"cuts would not cover " + names.front(), names};
            filled = false;
        }
    }
    if (filled) {
        const LayoutQuality quality = layout_quality(shape, trial, layout.hexas.size());
        for (const int solid : group) {
            FitEntry &entry = result.entries[solid];
            entry.entity = {3, solid};
            entry.method = "cut";
            entry.quality = quality.worst;
        }
        if (quality.worst > 0 && std::abs(quality.volume - volume) <= volume_error * volume) {
            result.layout = std::move(trial);
            return result;
        }
        refusal = {"the blocks of cuts would be folded", {}};
    }
    for (const int solid : group) {
        FitEntry &entry = result.entries[solid];
        entry = {};
        entry.entity = {3, solid};
        entry.reason = "cut with its neighbours: " + refusal.reason;
        entry.blockers = refusal.blockers;
    }
    return result;
}

// Where one of a group cannot be filled even by itself without cuts: cuts that, then fills the
// others.
GroupFilling fill_after_cut(const CadShape &shape, const std::vector<int> &group, int first,
                            const Layout &layout, const SolidLayoutOptions &options,
                            const Progress &progress) {
    SolidLayoutOptions by_cuts = options;
    by_cuts.method = "cut";
    GroupFilling result;
    FitEntry entry;
    const auto filling = fill(shape, first, layout, by_cuts, entry, progress);
    if (filling) {
        std::vector<int> others = group;
        others.erase(std::remove(others.begin(), others.end(), first), others.end());
        SolidLayoutOptions without_cuts = options;
        without_cuts.cuts = false;
        constexpr std::size_t tries = 3;
        result = fill_in_turn(shape, others, filling->layout, without_cuts, tries, progress);
    }
    result.entries[first] = entry;
    return result;
}

// The best filling of solids that share nodes, or the reasons of each.
GroupFilling fill_group(const CadShape &shape, const std::vector<int> &group, const Layout &layout,
                        const SolidLayoutOptions &options, const Progress &progress) {
    const std::size_t tries = group.size() == 1 ? 1 : std::min<std::size_t>(group.size() + 2, 8);
    SolidLayoutOptions without_cuts = options;
    without_cuts.cuts = options.cuts && (group.size() == 1 || options.method == "cut");
    GroupFilling best = fill_in_turn(shape, group, layout, without_cuts, tries, progress);
    constexpr double poor = 0.2;
    if (options.cuts && group.size() > 1 && options.method == "auto") {
        const bool culprit = !best.layout && best.alone;
        for (const bool together : {false, true}) {
            if (best.worst() > poor || (!together && !culprit)) {
                continue;
            }
            GroupFilling next =
                together ? fill_together(shape, group, layout, options, progress)
                         : fill_after_cut(shape, group, best.culprit, layout, options, progress);
            if (next.worst() > best.worst()) {
                best = std::move(next);
            } else if (!best.layout) {
                for (auto &[solid, entry] : next.entries) {
                    FitEntry &mine = best.entries.try_emplace(solid, entry).first->second;
                    if (solid == best.culprit && !entry.reason.empty()) {
                        mine.reason += "; " + entry.reason;
                    }
                }
            }
        }
    }
    if (best.layout) {
        return best;
    }
    for (const int solid : group) {
        const auto [own, added] = best.entries.try_emplace(solid);
        FitEntry &entry = own->second;
        if (added) {
            entry.entity = {3, solid};
            entry.reason = "it shares faces with " + entity_name(3, best.culprit) +
                           ", for which there is no structured strategy";
            entry.blockers = {entity_name(3, best.culprit)};
        }
    }
    return best;
}

// Solids that touch no other, as they have turned out so far.
struct Known {
    SolidLikeness likeness;
    FitEntry entry;
};

// What is known of a solid that looks the same.
const FitEntry *known_of(const std::vector<Known> &known, const SolidLikeness &likeness) {
    const auto found = std::find_if(known.begin(), known.end(), [&](const Known &other) {
        return alike(other.likeness, likeness);
    });
    return found == known.end() ? nullptr : &found->entry;
}

// The groups, those with least in the way of blocks first.
std::vector<std::vector<int>> easiest_first(const CadShape &shape, std::span<const int> solids) {
    auto groups = joined_solids(shape, solids);
    if (groups.size() < 2) {
        return groups;
    }
    std::vector<std::pair<double, std::size_t>> order;
    order.reserve(groups.size());
    for (std::size_t g = 0; g < groups.size(); ++g) {
        double weight = 0;
        for (const int solid : groups[g]) {
            weight += obstacles_of(shape, solid).weight;
        }
        order.emplace_back(weight, g);
    }
    std::sort(order.begin(), order.end());
    std::vector<std::vector<int>> result;
    result.reserve(order.size());
    for (const auto &[weight, g] : order) {
        result.push_back(std::move(groups[g]));
    }
    return result;
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
    const auto groups = easiest_first(shape, solids);
    // Work for searches over cuts: enough for two hard ones, a little more for many; each leaves
    // what it does not use to the harder ones that come after it.
    constexpr int for_one = 6000;
    constexpr int for_each = 300;
    int left = 2 * for_one + for_each * static_cast<int>(groups.size());
    // Pieces of a search have its end.
    constexpr std::chrono::seconds patience{40};
    const auto until = options.layout.until == std::chrono::steady_clock::time_point::max()
                           ? std::chrono::steady_clock::now() + patience
                           : options.layout.until;
    std::vector<Known> known;
    for (std::size_t g = 0; g < groups.size(); ++g) {
        poll(progress, static_cast<double>(g) / static_cast<double>(groups.size()));
        const auto &group = groups[g];
        SolidLayoutOptions mine = options;
        const int share = std::min(for_one, left / static_cast<int>(groups.size() - g));
        int work = share;
        mine.layout.cut_work = &work;
        mine.layout.until = until;
        const bool alone = group.size() == 1 && groups.size() > 1 && options.method == "auto";
        const SolidLikeness likeness = alone ? likeness_of(shape, group.front()) : SolidLikeness{};
        const FitEntry *same = alone ? known_of(known, likeness) : nullptr;
        GroupFilling filling;
        if (same != nullptr && same->method.empty()) {
            FitEntry &entry = filling.entries[group.front()];
            entry.entity = {3, group.front()};
            entry.reason = "it is like " + entity_name(3, same->entity.index) + ": " + same->reason;
            entry.blockers = {entity_name(3, group.front())};
        } else {
            if (same != nullptr) {
                mine.method = same->method;
                filling = fill_group(shape, group, layout, mine, progress);
                mine.method = options.method;
            }
            if (!filling.layout) {
                filling = fill_group(shape, group, layout, mine, progress);
            }
        }
        left -= share - std::max(work, 0);
        if (filling.layout) {
            layout = std::move(*filling.layout);
        }
        if (alone && same == nullptr) {
            known.push_back({likeness, filling.entries.at(group.front())});
        }
        entries.merge(filling.entries);
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
