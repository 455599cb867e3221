// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs_cad/fill_pieces.h"

#include "nmgs/support/at.h"
#include "nmgs_cad/edge_curve.h"
#include "nmgs_cad/face_layout.h"
#include "nmgs_cad/inner_faces.h"
#include "nmgs_cad/layout_quality.h"
#include "nmgs_cad/solid_layout.h"
#include "nmgs_cad/sweepability.h"

#include <BRep_Tool.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>

#include <algorithm>
#include <map>
#include <set>

namespace nmgs::cad {
namespace {

constexpr double good = 0.3;
constexpr double least = 0.2;

SolidLayoutOptions without_cuts(const LayoutOptions &options, int attempts) {
    SolidLayoutOptions result;
    result.layout = options;
    result.layout.attempts = attempts;
    result.cuts = false;
    return result;
}

// Lays out the faces between two pieces first, so that what the pieces make of them agrees.
void layout_inner_faces(const CadShape &cad, double segments, Layout &layout,
                        const LayoutOptions &options, const Progress &progress) {
    std::vector<int> faces;
    std::set<int> edges;
    for (const auto &[f, solids] : inner_faces(cad)) {
        faces.push_back(f);
        for (TopExp_Explorer it(cad.faces(f), TopAbs_EDGE); it.More(); it.Next()) {
            if (!BRep_Tool::Degenerated(TopoDS::Edge(it.Current()))) {
                edges.insert(cad.edges.FindIndex(it.Current()));
            }
        }
    }
    double length = 0;
    for (const int e : edges) {
        length += EdgeCurve(cad.edge(e)).length() / static_cast<double>(edges.size());
    }
    LayoutOptions finer = options;
    finer.size = length / segments;
    std::vector<FitEntry> report;
    layout_faces(cad, faces, layout, finer, report, progress);
}

// Walls before caps: a cap takes any quads, a wall only rows of them.
std::vector<int> filling_order(const CadShape &cad) {
    std::vector<Sweepability> sweeps(1);
    for (int n = 1; n <= cad.solids.Extent(); ++n) {
        sweeps.push_back(sweepability(cad, n));
    }
    std::map<int, std::set<int>> before; // of each piece: those that go first
    for (const auto &[face, solids] : inner_faces(cad)) {
        const auto &a = sweeps[at(solids[0])].directions;
        const auto &b = sweeps[at(solids[1])].directions;
        if (a.empty() || b.empty()) {
            continue;
        }
        const bool wall_a = runs_along(cad.face(face), a.front().along);
        const bool wall_b = runs_along(cad.face(face), b.front().along);
        if (wall_a && !wall_b) {
            before[solids[1]].insert(solids[0]);
        } else if (wall_b && !wall_a) {
            before[solids[0]].insert(solids[1]);
        }
    }
    std::vector<int> order;
    std::set<int> left;
    for (int n = 1; n <= cad.solids.Extent(); ++n) {
        left.insert(n);
    }
    while (!left.empty()) {
        // The one that waits for fewest.
        int next = 0;
        std::size_t fewest = 0;
        for (const int n : left) {
            const auto &first = before[n];
            const auto waits = static_cast<std::size_t>(std::count_if(
                first.begin(), first.end(), [&](int other) { return left.contains(other); }));
            if (next == 0 || waits < fewest) {
                next = n;
                fewest = waits;
            }
        }
        order.push_back(next);
        left.erase(next);
    }
    return order;
}

// The pieces one after the other; one that does not come to terms with what is there already goes
// first in the next try.
std::optional<Layout> in_turn(const CadShape &cad, std::vector<int> order, const Layout &start,
                              const SolidLayoutOptions &options, int &culprit, Refusal &refusal,
                              const Progress &progress) {
    constexpr int tries = 3;
    std::set<std::vector<int>> tried;
    for (int n = 0; n < tries && tried.insert(order).second; ++n) {
        Layout layout = start;
        std::size_t done = 0;
        for (; done < order.size(); ++done) {
            const auto report =
                layout_solids(cad, {&order[done], 1}, layout, options, progress).front();
            if (report.method.empty() || report.quality <= least) {
                culprit = order[done];
                refusal = {report.method.empty() ? "a piece cannot be filled: " + report.reason
                                                 : "a piece cannot be filled well",
                           {}};
                break;
            }
        }
        if (done == order.size()) {
            return layout;
        }
        if (done == 0 || late(options.layout)) {
            break;
        }
        std::rotate(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(done),
                    order.begin() + static_cast<std::ptrdiff_t>(done) + 1);
    }
    return std::nullopt;
}

} // namespace

bool fills_alone(const CadShape &cad, int piece, const LayoutOptions &options, int attempts,
                 double quality, Refusal &refusal, const Progress &progress) {
    Layout alone(cad);
    const auto entry =
        layout_solids(cad, {&piece, 1}, alone, without_cuts(options, attempts), progress).front();
    refusal = {entry.method.empty() ? "a piece cannot be filled: " + entry.reason
                                    : "a piece cannot be filled well",
               {}};
    return !entry.method.empty() && entry.quality > quality;
}

std::optional<Layout> fill_pieces(const Pieces &pieces, const FillPiecesOptions &options,
                                  int &culprit, Refusal &refusal, const Progress &progress) {
    const CadShape &cad = pieces.cad;
    culprit = 0;
    for (const int piece : options.doubtful) {
        if (!fills_alone(cad, piece, options.layout, options.attempts, least, refusal, progress)) {
            culprit = piece;
            return std::nullopt;
        }
    }
    const SolidLayoutOptions how = without_cuts(options.layout, options.attempts);
    const std::vector<int> order = filling_order(cad);
    std::optional<Layout> best;
    double quality = least;
    for (const double segments : options.segments) {
        if (late(options.layout)) {
            break;
        }
        Layout start(cad);
        if (segments > 0) {
            layout_inner_faces(cad, segments, start, options.layout, progress);
        }
        auto layout = in_turn(cad, order, start, how, culprit, refusal, progress);
        const double worst = layout ? layout_quality(cad, *layout).worst : 0;
        if (worst > quality) {
            quality = worst;
            best = std::move(layout);
        } else if (layout) {
            refusal = {"the pieces cannot be filled well", {}};
        }
        if (quality > good) {
            break;
        }
    }
    if (best) {
        culprit = 0;
    }
    return best;
}

} // namespace nmgs::cad
