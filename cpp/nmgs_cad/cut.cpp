// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs_cad/cut.h"

#include "nmgs_cad/cut_to_sweep.h"
#include "nmgs_cad/edge_curve.h"
#include "nmgs_cad/layout_quality.h"
#include "nmgs_cad/midpoint.h"
#include "nmgs_cad/solid_layout.h"
#include "nmgs_cad/split.h"

#include <BRepAdaptor_Surface.hxx>
#include <BRep_Tool.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>

#include <algorithm>
#include <numeric>
#include <optional>

namespace nmgs::cad {
namespace {

// The solids as the cuts leave them.
struct State {
    std::vector<Cut> cuts;
    Pieces pieces;
    std::vector<int> bad; // pieces with obstacles
    std::vector<Obstacles> obstacles;
    Proposals proposals;
    double weight = 0;
};

// The pieces of a state cut by one more, or by several.
std::optional<State> make_state(const CadShape &shape, std::span<const int> solids,
                                const State *before, std::span<const Cut> more, Refusal &refusal) {
    TopTools_ListOfShape tools;
    for (const Cut &cut : more) {
        tools.Append(cut_face(shape, cut));
    }
    auto pieces = before != nullptr ? split(shape, before->pieces, tools, refusal)
                                    : split(shape, solids, tools, refusal);
    if (!pieces) {
        return std::nullopt;
    }
    std::vector<Cut> cuts = before != nullptr ? before->cuts : std::vector<Cut>{};
    cuts.insert(cuts.end(), more.begin(), more.end());
    State state{std::move(cuts), std::move(*pieces), {}, {}, {}, 0};
    const CadShape &cad = state.pieces.cad;
    for (int n = 1; n <= cad.solids.Extent(); ++n) {
        Obstacles o = obstacles_of(cad, n);
        state.weight += o.weight;
        if (o.weight > 0) {
            state.bad.push_back(n);
            state.obstacles.push_back(std::move(o));
        }
    }
    // Slivers cost as much as an obstacle.
    const double diagonal = diagonal_of(shape.shape);
    for (int e = 1; e <= cad.edges.Extent(); ++e) {
        if (state.pieces.edge_on[static_cast<std::size_t>(e)].dimension > 1 &&
            !BRep_Tool::Degenerated(cad.edge(e)) &&
            EdgeCurve(cad.edge(e)).length() < 2e-3 * diagonal) {
            state.weight += 0.5;
        }
    }
    state.weight += 0.02 * cad.solids.Extent();
    state.proposals = candidates(cad, state.bad, state.obstacles);
    state.weight = state.proposals.needed + 0.02 * state.weight;
    return state;
}

bool fill_pieces(const Pieces &pieces, Layout &layout, const LayoutOptions &options,
                 Refusal &refusal, const Progress &progress) {
    for (int n = 1; n <= pieces.cad.solids.Extent(); ++n) {
        poll(progress, 0.7);
        if (!fill_midpoint(pieces.cad, n, layout, options, refusal, progress)) {
            return false;
        }
    }
    return true;
}

} // namespace

std::vector<int> obstacles(const CadShape &shape, int solid) {
    const Obstacles found = obstacles_of(shape, solid);
    return {found.edges.begin(), found.edges.end()};
}

namespace {

// What it takes to look at pieces, in plain faces; others take longer to intersect.
int work_of(const Pieces &pieces) {
    int work = 0;
    for (int f = 1; f <= pieces.cad.faces.Extent(); ++f) {
        switch (BRepAdaptor_Surface(pieces.cad.face(f), Standard_False).GetType()) {
        case GeomAbs_Plane:
        case GeomAbs_Cylinder:
        case GeomAbs_Cone:
        case GeomAbs_Sphere:
            work += 1;
            break;
        default:
            work += 8;
        }
    }
    return work;
}

// Fills the pieces by whatever strategy does each, if all can be filled and well. Those that have
// obstacles first, and alone: most often one of these cannot be filled.
bool fill_by_strategies(const State &state, Layout &of_pieces, const LayoutOptions &options,
                        const Progress &progress) {
    const Pieces &pieces = state.pieces;
    std::vector<int> all(static_cast<std::size_t>(pieces.cad.solids.Extent()));
    std::iota(all.begin(), all.end(), 1);
    SolidLayoutOptions without_cuts;
    without_cuts.layout = options;
    without_cuts.cuts = false;
    without_cuts.layout.attempts = 2;
    constexpr double enough = 0.2;
    std::vector<std::pair<double, int>> hardest;
    for (std::size_t i = 0; i < state.bad.size(); ++i) {
        hardest.emplace_back(-state.obstacles[i].weight, state.bad[i]);
    }
    std::sort(hardest.begin(), hardest.end());
    for (const auto &[weight, solid] : hardest) {
        Layout alone(pieces.cad);
        const auto entry =
            layout_solids(pieces.cad, {&solid, 1}, alone, without_cuts, progress).front();
        if (entry.method.empty() || entry.quality < enough) {
            return false;
        }
    }
    const auto report = layout_solids(pieces.cad, all, of_pieces, without_cuts, progress);
    return std::none_of(report.begin(), report.end(),
                        [](const FitEntry &entry) { return entry.method.empty(); }) &&
           layout_quality(pieces.cad, of_pieces).worst > enough;
}

constexpr std::size_t most_cuts = 24;
constexpr int most_pieces = 400;
constexpr double good = 0.3; // a worst scaled Jacobian that calls for no further search

// Cuts by all the proposals at once that together resolve what is in the way, again and again: a
// few steps instead of a long search, where it leads to blocks. Their quality, or -1.
double cut_by_covers(const CadShape &shape, std::span<const int> solids, const State &start,
                     Layout &layout, const LayoutOptions &options, int &work,
                     const Progress &progress) {
    const State *state = &start;
    std::optional<State> next;
    int lowest = start.proposals.needed;
    int idle = 0;
    const int least = work - work / 3; // the rest is for a search where this fails
    while (!state->bad.empty()) {
        poll(progress, 0.0);
        std::vector<Cut> cuts;
        for (const Cut &cut : state->proposals.cover) {
            const bool used =
                std::any_of(state->cuts.begin(), state->cuts.end(), [&](const Cut &c) {
                    return same(c, cut, 1e-4 * diagonal_of(shape.shape));
                });
            if (!used) {
                cuts.push_back(cut);
            }
        }
        if (cuts.empty() || state->cuts.size() + cuts.size() > most_cuts || work <= least ||
            late(options)) {
            return -1;
        }
        Refusal ignored;
        auto found = make_state(shape, solids, state, cuts, ignored);
        work -= work_of(found ? found->pieces : state->pieces);
        if (!found || found->pieces.cad.solids.Extent() <= state->pieces.cad.solids.Extent() ||
            found->pieces.cad.solids.Extent() > most_pieces) {
            return -1;
        }
        next = std::move(found);
        state = &*next;
        idle = state->proposals.needed < lowest ? 0 : idle + 1;
        lowest = std::min(lowest, state->proposals.needed);
        constexpr int patient = 3;
        if (idle == patient || state->proposals.needed > 3 * lowest + 10) {
            return -1; // it only gets worse
        }
    }
    Layout of_pieces(state->pieces.cad);
    Layout result = layout;
    Refusal ignored;
    if (!fill_pieces(state->pieces, of_pieces, options, ignored, progress) ||
        !join(shape, state->pieces, of_pieces, result, ignored)) {
        return -1;
    }
    layout = std::move(result);
    return layout_quality(state->pieces.cad, of_pieces).worst;
}

} // namespace

bool cut_solids(const CadShape &shape, std::span<const int> solids, Layout &layout,
                const LayoutOptions &options, Refusal &refusal, const Progress &progress) {
    constexpr int patient = 3;
    constexpr std::size_t tries = 10; // of the most promising cuts
    // Faces of all the pieces that are looked at: the work, whatever the machine's speed.
    constexpr int most_work = 4000;
    int own_work = most_work;
    int &work = options.cut_work != nullptr ? *options.cut_work : own_work;
    // The pieces after a few cuts may do for other strategies as they are.
    constexpr std::size_t first_cuts = 3;
    constexpr std::size_t most_promising = 4;
    constexpr int few_pieces = 12;
    TopTools_IndexedMapOfShape faces;
    for (const int solid : solids) {
        for (TopExp_Explorer it(shape.solid(solid), TopAbs_EDGE); it.More(); it.Next()) {
            const int edge = shape.edges.FindIndex(it.Current());
            if (!layout.edges[static_cast<std::size_t>(edge)].empty()) {
                refusal = {entity_name(1, edge) + " is laid out already by a neighbour",
                           {entity_name(1, edge)}};
                return false;
            }
        }
        TopExp::MapShapes(shape.solid(solid), TopAbs_FACE, faces);
        constexpr int most_faces = 250;
        if (faces.Extent() > most_faces) {
            refusal = {entity_name(3, solid) + " has " + std::to_string(faces.Extent()) +
                           " faces, too many for a search over cuts",
                       {entity_name(3, solid)}};
            return false;
        }
    }
    auto state = make_state(shape, solids, nullptr, {}, refusal);
    if (!state) {
        return false;
    }
    Layout wholesale = layout;
    const double quality = cut_by_covers(shape, solids, *state, wholesale, options, work, progress);
    if (quality >= good) {
        layout = std::move(wholesale);
        return true;
    }
    constexpr double enough = 0.2;
    Refusal no_sweeps;
    if (quality < enough && solids.size() == 1 &&
        fill_cut_to_sweep(shape, solids.front(), layout, options, no_sweeps, progress)) {
        return true;
    }
    double lowest = state->weight;
    int idle = 0; // cuts since the last that left less than any before
    while (!state->bad.empty() && state->cuts.size() < most_cuts) {
        std::vector<State> found;
        const auto used = [&](const Cut &cut) {
            return std::any_of(state->cuts.begin(), state->cuts.end(), [&](const Cut &c) {
                return same(c, cut, 1e-4 * diagonal_of(shape.shape));
            });
        };
        std::size_t tried = 0;
        for (const Cut &cut : state->proposals.cuts) {
            if (used(cut)) {
                continue;
            }
            if (tried++ == tries || work <= 0 || late(options)) {
                break;
            }
            poll(progress,
                 static_cast<double>(state->cuts.size()) / static_cast<double>(most_cuts));
            Refusal ignored;
            auto next = make_state(shape, solids, &*state, {&cut, 1}, ignored);
            work -= work_of(next ? next->pieces : state->pieces);
            if (next && next->pieces.cad.solids.Extent() > state->pieces.cad.solids.Extent() &&
                next->pieces.cad.solids.Extent() <= most_pieces) {
                found.push_back(std::move(*next));
            }
        }
        std::stable_sort(found.begin(), found.end(),
                         [](const State &a, const State &b) { return a.weight < b.weight; });
        for (std::size_t n = 0; n < std::min(found.size(), most_promising); ++n) {
            if (state->cuts.size() >= first_cuts || work <= 0 || late(options) ||
                found[n].pieces.cad.solids.Extent() > few_pieces) {
                continue;
            }
            work -= work_of(found[n].pieces); // strategies take as long again
            Layout of_pieces(found[n].pieces.cad);
            Layout result = layout;
            if (fill_by_strategies(found[n], of_pieces, options, progress) &&
                join(shape, found[n].pieces, of_pieces, result, refusal)) {
                layout = std::move(result);
                return true;
            }
        }
        std::optional<State> best;
        if (!found.empty()) {
            best = std::move(found.front());
        }
        idle = best && best->weight < lowest ? 0 : idle + 1;
        if (!best || idle > patient) {
            break;
        }
        lowest = std::min(lowest, best->weight);
        state = std::move(best);
    }
    if (!state->bad.empty() && quality > 0) {
        layout = std::move(wholesale);
        return true;
    }
    if (!state->bad.empty()) {
        refusal = {"after " + std::to_string(state->cuts.size()) + " cuts " +
                       std::to_string(state->bad.size()) + " of " +
                       std::to_string(state->pieces.cad.solids.Extent()) +
                       " pieces still have edges that stand in the way",
                   {}};
        for (const int solid : solids) {
            for (const int e : obstacles(shape, solid)) {
                refusal.blockers.push_back(entity_name(1, e));
            }
        }
        return false;
    }
    Layout of_pieces(state->pieces.cad);
    if (!fill_pieces(state->pieces, of_pieces, options, refusal, progress)) {
        return false;
    }
    Layout result = layout;
    if (!join(shape, state->pieces, of_pieces, result, refusal)) {
        return false;
    }
    layout = std::move(result);
    return true;
}

bool fill_cut(const CadShape &shape, int solid, Layout &layout, const LayoutOptions &options,
              Refusal &refusal, const Progress &progress) {
    return cut_solids(shape, {&solid, 1}, layout, options, refusal, progress);
}

} // namespace nmgs::cad
