// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs_cad/cut_to_sweep.h"

#include "nmgs_cad/cut_proposals.h"
#include "nmgs_cad/edge_curve.h"
#include "nmgs_cad/face_layout.h"
#include "nmgs_cad/feature_boxes.h"
#include "nmgs_cad/layout_quality.h"
#include "nmgs_cad/solid_boundary.h"
#include "nmgs_cad/solid_layout.h"
#include "nmgs_cad/split.h"
#include "nmgs_cad/sweepability.h"

#include <BRepAlgoAPI_Common.hxx>
#include <BRepGProp.hxx>
#include <BRep_Tool.hxx>
#include <GProp_GProps.hxx>
#include <Standard_Failure.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>

#include <algorithm>
#include <optional>
#include <set>

namespace nmgs::cad {
namespace {

constexpr int most_cuts = 16;
constexpr int most_pieces = 80;
constexpr int most_work = 3000; // faces of all the pieces that are looked at
constexpr int most_fillings = 4;
constexpr std::size_t most_planes = 8;

struct Candidate {
    TopTools_ListOfShape faces;
    std::string name;
    double cost = 0; // of what it leaves
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

std::vector<Candidate> candidates_of(const CadShape &cad, const Sweepability &sweep,
                                     double margin) {
    std::vector<Candidate> result;
    constexpr std::size_t most_directions = 3;
    for (std::size_t d = 0; d < std::min(most_directions, sweep.directions.size()); ++d) {
        for (FeatureBox &box : feature_boxes(cad, 1, sweep.directions[d], margin)) {
            result.push_back({box.faces, std::move(box.name), 0});
        }
    }
    Refusal refusal;
    const auto boundary = boundary_of(cad, 1, refusal);
    if (!boundary) {
        return result;
    }
    Obstacles concave;
    for (const Coedge &c : boundary->coedges) {
        if (!c.degenerated && c.dihedral > std::numbers::pi + least_angle &&
            c.dihedral < 2 * std::numbers::pi - least_angle) {
            concave.edges.insert(c.edge);
        }
    }
    std::size_t planes = 0;
    for (const Cut &cut : candidates(cad, {1}, {concave}).cuts) {
        if (planes++ == most_planes) {
            break;
        }
        TopTools_ListOfShape faces;
        faces.Append(cut_face(cad, cut));
        result.push_back({faces, cut.name, 0});
    }
    return result;
}

// What is in the way of sweeping the pieces, and slivers.
double cost_of(const CadShape &cad, double diagonal) {
    double cost = 0.02 * cad.solids.Extent();
    for (int n = 1; n <= cad.solids.Extent(); ++n) {
        const int own = sweepability(cad, n).cost;
        TopTools_IndexedMapOfShape faces;
        TopExp::MapShapes(cad.solid(n), TopAbs_FACE, faces);
        cost += own > 0 ? own + 0.03 * faces.Extent() : 0; // what is apart is easier to see
    }
    for (int e = 1; e <= cad.edges.Extent(); ++e) {
        if (!BRep_Tool::Degenerated(cad.edge(e)) &&
            EdgeCurve(cad.edge(e)).length() < 2e-3 * diagonal) {
            cost += 0.5;
        }
    }
    return cost;
}

double area_between(const Pieces &pieces) {
    double area = 0;
    for (int f = 1; f <= pieces.cad.faces.Extent(); ++f) {
        if (pieces.face_on[static_cast<std::size_t>(f)].dimension == 3) {
            GProp_GProps properties;
            BRepGProp::SurfaceProperties(pieces.cad.face(f), properties);
            area += properties.Mass();
        }
    }
    return area;
}

// Cuts that make a solid that stands alone better, the best first.
std::vector<Candidate> good_cuts(const CadShape &one, double diagonal, double margin, int &work,
                                 const Progress &progress) {
    const double least = cost_of(one, diagonal) - 0.01;
    std::vector<Candidate> result;
    for (Candidate &candidate : candidates_of(one, sweepability(one, 1), margin)) {
        poll(progress, 0.3);
        if (work <= 0) {
            break;
        }
        Refusal ignored;
        const std::vector<int> alone{1};
        const auto pieces = split(one, alone, candidate.faces, ignored);
        work -= pieces ? pieces->cad.faces.Extent() : one.faces.Extent();
        if (!pieces || pieces->cad.solids.Extent() < 2) {
            continue;
        }
        // Of equals that which cuts least.
        candidate.cost =
            cost_of(pieces->cad, diagonal) + 0.1 * area_between(*pieces) / (diagonal * diagonal);
        if (candidate.cost < least) {
            result.push_back(std::move(candidate));
        }
    }
    std::stable_sort(result.begin(), result.end(),
                     [](const Candidate &a, const Candidate &b) { return a.cost < b.cost; });
    return result;
}

// Lays out the faces between two pieces first, so that what the pieces make of them agrees.
void layout_inner_faces(const Pieces &pieces, double segments, Layout &layout,
                        const LayoutOptions &options, const Progress &progress) {
    std::vector<int> faces;
    std::set<int> edges;
    for (int f = 1; f <= pieces.cad.faces.Extent(); ++f) {
        if (pieces.face_on[static_cast<std::size_t>(f)].dimension == 3) {
            faces.push_back(f);
            for (TopExp_Explorer it(pieces.cad.faces(f), TopAbs_EDGE); it.More(); it.Next()) {
                if (!BRep_Tool::Degenerated(TopoDS::Edge(it.Current()))) {
                    edges.insert(pieces.cad.edges.FindIndex(it.Current()));
                }
            }
        }
    }
    double length = 0;
    for (const int e : edges) {
        length += EdgeCurve(pieces.cad.edge(e)).length() / static_cast<double>(edges.size());
    }
    LayoutOptions finer = options;
    finer.size = length / segments;
    std::vector<FitEntry> report;
    layout_faces(pieces.cad, faces, layout, finer, report, progress);
}

// Fills the pieces one after the other: with what lies between them laid out first, else as they
// come.
std::optional<Layout> fill_pieces(const Pieces &pieces, const LayoutOptions &options,
                                  Refusal &refusal, const Progress &progress) {
    constexpr double good = 0.3;
    constexpr double least = 0.2;
    SolidLayoutOptions without_cuts;
    without_cuts.layout = options;
    without_cuts.cuts = false;
    without_cuts.layout.attempts = 3;
    std::optional<Layout> best;
    double quality = least;
    for (const double segments : {4.0, 0.0}) {
        Layout layout(pieces.cad);
        if (segments > 0) {
            layout_inner_faces(pieces, segments, layout, options, progress);
        }
        bool filled = true;
        for (int n = 1; filled && n <= pieces.cad.solids.Extent(); ++n) {
            const auto report =
                layout_solids(pieces.cad, {&n, 1}, layout, without_cuts, progress).front();
            filled = !report.method.empty() && report.quality > least;
            if (!filled) {
                refusal = {report.method.empty() ? "a piece cannot be filled: " + report.reason
                                                 : "a piece cannot be filled well",
                           {}};
            }
        }
        const double worst = filled ? layout_quality(pieces.cad, layout).worst : 0;
        if (worst > quality) {
            quality = worst;
            best = std::move(layout);
        }
        if (quality > good) {
            break;
        }
    }
    return best;
}

struct Budget {
    int work;
    int fillings;
};

// With boxes of one margin.
bool fill_with(const CadShape &shape, int solid, double margin, Budget &budget, Layout &layout,
               const LayoutOptions &options, Refusal &refusal, const Progress &progress) {
    const std::vector<int> solids{solid};
    const double diagonal = diagonal_of(shape.solid(solid));
    TopTools_ListOfShape tools;
    auto pieces = split(shape, solids, tools, refusal);
    const auto bad_pieces = [](const CadShape &cad) {
        std::vector<int> result;
        for (int n = 1; n <= cad.solids.Extent(); ++n) {
            if (sweepability(cad, n).cost > 0) {
                result.push_back(n);
            }
        }
        return result;
    };
    for (int round = 0; pieces && round < most_cuts && !late(options); ++round) {
        poll(progress, static_cast<double>(round) / most_cuts);
        const CadShape &cad = pieces->cad;
        const auto bad = bad_pieces(cad);
        if (bad.empty() || cad.solids.Extent() > most_pieces) {
            refusal = {"no cut makes it better for sweeping", {}};
            return false;
        }
        const CadShape one = make_shape(cad.solid(bad.front()));
        const auto cuts = good_cuts(one, diagonal, margin, budget.work, progress);
        std::optional<Pieces> best;
        TopTools_ListOfShape best_tools;
        for (const Candidate &cut : cuts) {
            // Those that leave nothing in the way are tried one after the other.
            const auto local = within(cut.faces, one.shape);
            if (local.IsEmpty()) {
                continue;
            }
            TopTools_ListOfShape all = tools;
            for (const TopoDS_Shape &face : local) {
                all.Append(face);
            }
            auto next = split(shape, solids, all, refusal);
            if (!next) {
                continue;
            }
            if (bad_pieces(next->cad).empty()) {
                if (--budget.fillings < 0 || late(options)) {
                    return false;
                }
                const auto of_pieces = fill_pieces(*next, options, refusal, progress);
                if (of_pieces && join(shape, *next, *of_pieces, layout, refusal)) {
                    return true;
                }
                continue;
            }
            best = std::move(next);
            best_tools = all;
            break;
        }
        if (!best) {
            refusal = {"no cut makes a piece better for sweeping: " + refusal.reason, {}};
            return false;
        }
        pieces = std::move(best);
        tools = best_tools;
    }
    return false;
}

} // namespace

bool fill_cut_to_sweep(const CadShape &shape, int solid, Layout &layout,
                       const LayoutOptions &options, Refusal &refusal, const Progress &progress) {
    const int work =
        options.cut_work != nullptr ? std::min(*options.cut_work, most_work) : most_work;
    Budget budget{work, most_fillings};
    bool filled = false;
    for (const double margin : {0.3, 0.15, 0.6}) {
        filled =
            filled || fill_with(shape, solid, margin, budget, layout, options, refusal, progress);
    }
    if (options.cut_work != nullptr) {
        *options.cut_work -= work - budget.work;
    }
    return filled;
}

} // namespace nmgs::cad
