// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs_cad/cut.h"

#include "nmgs_cad/cut_state.h"
#include "nmgs_cad/cut_to_sweep.h"
#include "nmgs_cad/fill_pieces.h"
#include "nmgs_cad/layout_quality.h"
#include "nmgs_cad/midpoint.h"

#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>

#include <algorithm>
#include <optional>

namespace nmgs::cad {
namespace {

bool fill_by_midpoints(const Pieces &pieces, Layout &layout, const LayoutOptions &options,
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

// Fills the pieces by whatever strategy does each, if all can be filled and well. Those that have
// obstacles first, and alone: most often one of these cannot be filled.
std::optional<Layout> fill_by_strategies(const CutState &state, const LayoutOptions &options,
                                         const Progress &progress) {
    std::vector<std::pair<double, int>> hardest;
    for (std::size_t i = 0; i < state.bad.size(); ++i) {
        hardest.emplace_back(-state.obstacles[i].weight, state.bad[i]);
    }
    std::sort(hardest.begin(), hardest.end());
    std::vector<int> doubtful;
    doubtful.reserve(hardest.size());
    for (const auto &[weight, solid] : hardest) {
        doubtful.push_back(solid);
    }
    FillPiecesOptions how;
    how.layout = options;
    how.attempts = 2;
    how.doubtful = doubtful;
    constexpr double as_they_come[] = {0.0};
    how.segments = as_they_come;
    int culprit = 0;
    Refusal ignored;
    return fill_pieces(state.pieces, how, culprit, ignored, progress);
}

constexpr std::size_t most_cuts = 24;
constexpr int most_pieces = 400;
constexpr double good = 0.3; // a worst scaled Jacobian that calls for no further search

// Cuts by all the proposals at once that together resolve what is in the way, again and again: a
// few steps instead of a long search, where it leads to blocks. Their quality, or -1.
double cut_by_covers(const CadShape &shape, std::span<const int> solids, const CutState &start,
                     Layout &layout, const LayoutOptions &options, int &work,
                     const Progress &progress) {
    const CutState *state = &start;
    std::optional<CutState> next;
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
        auto found = cut_further(shape, solids, state, cuts, ignored);
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
    if (!fill_by_midpoints(state->pieces, of_pieces, options, ignored, progress) ||
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
    auto state = cut_further(shape, solids, nullptr, {}, refusal);
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
    if (quality < enough && solids.size() == 1) {
        // A part of the work and of the time is left for the search below.
        Refusal no_sweeps;
        int share = 2 * work / 3;
        LayoutOptions sweeps = options;
        sweeps.cut_work = &share;
        if (options.until != std::chrono::steady_clock::time_point::max()) {
            const auto now = std::chrono::steady_clock::now();
            sweeps.until = now + (options.until - now) * 2 / 3;
        }
        work -= share;
        const bool filled =
            fill_cut_to_sweep(shape, solids.front(), layout, sweeps, no_sweeps, progress);
        work += share;
        if (filled) {
            return true;
        }
    }
    double lowest = state->weight;
    int idle = 0; // cuts since the last that left less than any before
    while (!state->bad.empty() && state->cuts.size() < most_cuts) {
        std::vector<CutState> found;
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
            auto next = cut_further(shape, solids, &*state, {&cut, 1}, ignored);
            work -= work_of(next ? next->pieces : state->pieces);
            if (next && next->pieces.cad.solids.Extent() > state->pieces.cad.solids.Extent() &&
                next->pieces.cad.solids.Extent() <= most_pieces) {
                found.push_back(std::move(*next));
            }
        }
        std::stable_sort(found.begin(), found.end(),
                         [](const CutState &a, const CutState &b) { return a.weight < b.weight; });
        for (std::size_t n = 0; n < std::min(found.size(), most_promising); ++n) {
            if (state->cuts.size() >= first_cuts || work <= 0 || late(options) ||
                found[n].pieces.cad.solids.Extent() > few_pieces) {
                continue;
            }
            work -= work_of(found[n].pieces); // strategies take as long again
            const auto of_pieces = fill_by_strategies(found[n], options, progress);
            Layout result = layout;
            if (of_pieces && join(shape, found[n].pieces, *of_pieces, result, refusal)) {
                layout = std::move(result);
                return true;
            }
        }
        std::optional<CutState> best;
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
    if (!fill_by_midpoints(state->pieces, of_pieces, options, refusal, progress)) {
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
