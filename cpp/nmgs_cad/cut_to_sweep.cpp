// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs_cad/cut_to_sweep.h"

#include "nmgs/support/at.h"
#include "nmgs_cad/cut_proposals.h"
#include "nmgs_cad/fill_pieces.h"
#include "nmgs_cad/imprint_sweeps.h"
#include "nmgs_cad/split.h"
#include "nmgs_cad/sweep_cuts.h"
#include "nmgs_cad/sweepability.h"

#include <BRepAlgoAPI_Common.hxx>
#include <Standard_Failure.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_DataMapOfShapeInteger.hxx>
#include <TopoDS.hxx>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>
#include <optional>
#include <set>

namespace nmgs::cad {
namespace {

constexpr int most_pieces = 80;
constexpr int most_fillings = 4;
constexpr int few_fillings = 2;   // where the solid itself should be swept, and cannot be
constexpr double resisting = 0.9; // the cost of a piece that should be swept and cannot be
constexpr int most_states = 60;
constexpr std::size_t most_choices = 6; // of the cuts of one piece

// What is known of a piece.
struct Piece {
    double cost = 0;                           // of sweeping it
    std::optional<std::vector<SweepCut>> cuts; // once they were asked for
};

struct State {
    Pieces pieces;
    std::vector<int> known; // of each solid, from 1: its place in Search::known
};

// A state to come.
struct Choice {
    std::shared_ptr<const State> from;
    int piece = 0;
    const SweepCut *cut = nullptr;
    double cost = 0;
    int order = 0;
};

// The part of the faces that lies in the solid.
TopTools_ListOfShape within(const TopTools_ListOfShape &faces, const TopoDS_Shape &solid) {
    TopTools_ListOfShape result;
    try {
        BRepAlgoAPI_Common common;
        TopTools_ListOfShape tools;
        tools.Append(solid);
        common.SetArguments(faces);
        common.SetTools(tools);
        common.SetNonDestructive(Standard_True);
        common.SetToFillHistory(Standard_False);
        common.Build();
        if (common.IsDone() && !common.HasErrors()) {
            for (TopExp_Explorer it(common.Shape(), TopAbs_FACE); it.More(); it.Next()) {
                result.Append(it.Current());
            }
        }
    } catch (const Standard_Failure &) {
        result.Clear();
    }
    return result;
}

// Best-first search: the cut that promises to leave the least in the way next, wherever it is.
struct Search {
    const CadShape &shape;
    std::vector<int> solids;
    const LayoutOptions &options;
    const Progress &progress;
    double length;
    int &work;
    std::vector<std::unique_ptr<Piece>> known;
    TopTools_DataMapOfShapeInteger places; // of pieces in known
    std::vector<Choice> choices;
    std::set<std::vector<long>> seen; // volumes of the pieces of states
    int fillings = 0;
    int states = 0;
    Refusal refusal;

    double cost_of(const CadShape &one);
    std::shared_ptr<const State> look_at(Pieces &&pieces);
    bool fill(const State &state, Layout &layout, int &culprit);
    bool expand(const std::shared_ptr<const State> &state, Layout &layout);
    std::shared_ptr<const State> follow(const Choice &choice);
    bool run(Layout &layout);
};

// A piece that should be swept may turn out to fold, to meet itself, or to have knife edges.
double Search::cost_of(const CadShape &one) {
    if (sweepability(one, 1).cost > 0) {
        return sweep_cost(one, length);
    }
    work -= one.faces.Extent();
    Refusal ignored;
    constexpr int attempts = 2;
    // With finer neighbours a piece may become better than alone.
    constexpr double least = 0.1;
    return fills_alone(one, 1, options, attempts, least, ignored, progress) ? 0 : resisting;
}

std::shared_ptr<const State> Search::look_at(Pieces &&pieces) {
    auto state = std::make_shared<State>();
    state->pieces = std::move(pieces);
    const CadShape &cad = state->pieces.cad;
    state->known.assign(at(cad.solids.Extent()) + 1, 0);
    for (int n = 1; n <= cad.solids.Extent(); ++n) {
        if (!places.IsBound(cad.solids(n))) {
            places.Bind(cad.solids(n), static_cast<int>(known.size()));
            known.push_back(std::make_unique<Piece>());
            const CadShape one = make_shape(cad.solid(n));
            known.back()->cost = cost_of(one);
        }
        state->known[at(n)] = places.Find(cad.solids(n));
    }
    return state;
}

bool Search::fill(const State &state, Layout &layout, int &culprit) {
    ++fillings;
    FillPiecesOptions how;
    how.layout = options;
    constexpr double plain[] = {4.0, 0.0};
    constexpr double as_they_come[] = {0.0};
    const auto fill_with = [&](const Pieces &pieces, std::span<const double> segments) {
        how.segments = segments;
        const auto of_pieces = fill_pieces(pieces, how, culprit, refusal, progress);
        return of_pieces && join(shape, pieces, *of_pieces, layout, refusal);
    };
    if (fill_with(state.pieces, plain)) {
        return true;
    }
    const auto drawn = imprint_sweeps(shape, state.pieces);
    return drawn && fill_with(*drawn, as_they_come);
}

// Fills a state that has nothing in the way, or adds the cuts of the piece that has most.
bool Search::expand(const std::shared_ptr<const State> &state, Layout &layout) {
    const CadShape &cad = state->pieces.cad;
    for (;;) {
        double rest = 0;
        int worst = 0;
        for (int n = 1; n <= cad.solids.Extent(); ++n) {
            const Piece &piece = *known[at(state->known[at(n)])];
            rest += piece.cost;
            if (piece.cost > 0 && piece.cuts && piece.cuts->empty()) {
                return false; // a dead end
            }
            if (piece.cost > 0 &&
                (worst == 0 || piece.cost > known[at(state->known[at(worst)])]->cost)) {
                worst = n;
            }
        }
        if (worst == 0) {
            int culprit = 0;
            return fill(*state, layout, culprit);
        }
        Piece &piece = *known[at(state->known[at(worst)])];
        if (!piece.cuts) {
            piece.cuts = sweep_cuts(make_shape(cad.solid(worst)), length, work, progress);
            if (piece.cuts->size() > most_choices) {
                piece.cuts->resize(most_choices);
            }
            Refusal ignored;
            if (piece.cuts->empty() && piece.cost > resisting &&
                fills_alone(cad, worst, options, 2, 0.2, ignored, progress)) {
                piece.cost = 0; // no sweep, but another strategy does it
                continue;
            }
        }
        for (const SweepCut &cut : *piece.cuts) {
            choices.push_back({state, worst, &cut, rest - piece.cost + cut.cost,
                               static_cast<int>(choices.size())});
        }
        return false;
    }
}

std::shared_ptr<const State> Search::follow(const Choice &choice) {
    const CadShape &cad = choice.from->pieces.cad;
    const auto local = within(choice.cut->faces, cad.solid(choice.piece));
    if (local.IsEmpty()) {
        return nullptr;
    }
    auto next = split(shape, choice.from->pieces, local, refusal);
    work -= next ? next->cad.faces.Extent() : cad.faces.Extent();
    if (!next || next->cad.solids.Extent() <= cad.solids.Extent() ||
        next->cad.solids.Extent() > most_pieces) {
        return nullptr;
    }
    // Other cuts may leave the same pieces.
    std::vector<long> volumes;
    const double whole = std::accumulate(next->volume.begin(), next->volume.end(), 0.0);
    for (const double volume : next->volume) {
        volumes.push_back(std::lround(1e6 * volume / whole));
    }
    std::sort(volumes.begin(), volumes.end());
    if (!seen.insert(std::move(volumes)).second) {
        return nullptr;
    }
    return look_at(std::move(*next));
}

bool Search::run(Layout &layout) {
    auto whole = split(shape, solids, {}, refusal);
    if (!whole) {
        return false;
    }
    const auto start = look_at(std::move(*whole));
    if (known.size() == 1 && known.front()->cost == 0) {
        refusal = {"it needs no cut to be swept", {}};
        return false;
    }
    const int most = known.front()->cost == resisting ? few_fillings : most_fillings;
    if (expand(start, layout)) {
        return true;
    }
    while (!choices.empty() && work > 0 && fillings < most && states < most_states &&
           !late(options)) {
        poll(progress, static_cast<double>(states) / most_states);
        const auto best =
            std::min_element(choices.begin(), choices.end(), [](const Choice &a, const Choice &b) {
                return a.cost != b.cost ? a.cost < b.cost : a.order > b.order;
            });
        const Choice choice = *best;
        choices.erase(best);
        ++states;
        if (const auto state = follow(choice); state && expand(state, layout)) {
            return true;
        }
    }
    refusal = {"no cuts make pieces that can be swept: " + refusal.reason, {}};
    return false;
}

} // namespace

bool fill_cut_to_sweep(const CadShape &shape, int solid, Layout &layout,
                       const LayoutOptions &options, Refusal &refusal, const Progress &progress) {
    constexpr int most_work = 3000; // where no one else counts
    int own_work = most_work;
    int &work = options.cut_work != nullptr ? *options.cut_work : own_work;
    Search search{shape, {solid}, options, progress, diagonal_of(shape.solid(solid)),
                  work,  {},      {},      {},       {},
                  0,     0,       {}};
    const bool filled = search.run(layout);
    refusal = search.refusal;
    return filled;
}

} // namespace nmgs::cad
