// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs_cad/sweep_cuts.h"

#include "nmgs/support/at.h"
#include "nmgs_cad/cut_proposals.h"
#include "nmgs_cad/edge_curve.h"
#include "nmgs_cad/feature_boxes.h"
#include "nmgs_cad/solid_boundary.h"
#include "nmgs_cad/sweepability.h"

#include <BRepAlgoAPI_Splitter.hxx>
#include <BRepGProp.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <GProp_GProps.hxx>
#include <Standard_Failure.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>

namespace nmgs::cad {
namespace {

// The pieces, without account of where they come from.
std::optional<CadShape> pieces_of(const CadShape &one, const TopTools_ListOfShape &tools) {
    try {
        BRepAlgoAPI_Splitter splitter;
        TopTools_ListOfShape arguments;
        arguments.Append(one.solid(1));
        splitter.SetArguments(arguments);
        splitter.SetTools(tools);
        splitter.SetNonDestructive(Standard_True);
        splitter.SetRunParallel(Standard_False);
        splitter.SetToFillHistory(Standard_False);
        splitter.Build();
        if (!splitter.IsDone() || splitter.HasErrors()) {
            return std::nullopt;
        }
        return make_shape(splitter.Shape());
    } catch (const Standard_Failure &) {
        return std::nullopt;
    }
}

// Edges that cuts should go through: concave ones, and smooth ones round what is in the way, such
// as the ends of bends and of rounded edges.
Obstacles places_of(const CadShape &one, const Sweepability &sweep) {
    Obstacles result;
    Refusal refusal;
    const auto boundary = boundary_of(one, 1, refusal);
    if (!boundary) {
        return result;
    }
    std::set<int> in_the_way;
    constexpr std::size_t most_directions = 2;
    for (std::size_t d = 0; d < std::min(most_directions, sweep.directions.size()); ++d) {
        in_the_way.insert(sweep.directions[d].faces.begin(), sweep.directions[d].faces.end());
    }
    for (const Coedge &c : boundary->coedges) {
        if (c.degenerated || c.mate < 0) {
            continue;
        }
        const int other = boundary->coedges[at(c.mate)].face;
        const bool concave = c.dihedral > std::numbers::pi + least_angle &&
                             c.dihedral < 2 * std::numbers::pi - least_angle;
        const bool smooth = std::abs(c.dihedral - std::numbers::pi) < least_angle;
        if (concave ||
            (smooth && c.face != other && in_the_way.contains(boundary->faces[at(c.face)]))) {
            result.edges.insert(c.edge);
        }
    }
    return result;
}

struct Proposed {
    SweepCut cut;
    std::vector<FeatureBox> others; // the same box of another margin
};

std::vector<Proposed> planes_of(const CadShape &one, const Sweepability &sweep) {
    std::vector<Proposed> result;
    constexpr std::size_t most_planes = 16;
    const Obstacles places = places_of(one, sweep);
    if (!places.edges.empty()) {
        for (const Cut &cut : candidates(one, {1}, {places}).cuts) {
            if (result.size() == most_planes) {
                break;
            }
            TopTools_ListOfShape faces;
            faces.Append(cut_face(one, cut));
            result.push_back({{faces, cut.name, 0}, {}});
        }
    }
    return result;
}

std::vector<Proposed> boxes_of(const CadShape &one, const Sweepability &sweep) {
    std::vector<Proposed> result;
    constexpr std::size_t most_directions = 3;
    constexpr std::size_t most_boxes = 12;
    std::vector<FeatureBox> known;
    const auto is_new = [&](const FeatureBox &box) {
        return std::none_of(known.begin(), known.end(),
                            [&](const FeatureBox &other) { return same(box, other); });
    };
    for (std::size_t d = 0; d < std::min(most_directions, sweep.directions.size()); ++d) {
        std::vector<std::vector<FeatureBox>> of_margin;
        for (const double margin : {0.3, 0.15, 0.6}) {
            of_margin.push_back(feature_boxes(one, 1, sweep.directions[d], margin));
        }
        for (std::size_t b = 0; b < of_margin[0].size() && known.size() < most_boxes; ++b) {
            const FeatureBox &box = of_margin[0][b];
            if (!is_new(box)) {
                continue;
            }
            known.push_back(box);
            Proposed proposed{{box.faces, box.name, 0}, {}};
            for (std::size_t m = 1; m < of_margin.size(); ++m) {
                for (const FeatureBox &other : of_margin[m]) {
                    if (other.name == box.name && is_new(other)) {
                        proposed.others.push_back(other);
                        break;
                    }
                }
            }
            result.push_back(std::move(proposed));
        }
    }
    return result;
}

double area_between(const CadShape &pieces) {
    std::map<int, int> solids_of;
    for (int n = 1; n <= pieces.solids.Extent(); ++n) {
        for (TopExp_Explorer it(pieces.solids(n), TopAbs_FACE); it.More(); it.Next()) {
            ++solids_of[pieces.faces.FindIndex(it.Current())];
        }
    }
    double area = 0;
    for (const auto &[face, count] : solids_of) {
        if (count > 1) {
            GProp_GProps properties;
            BRepGProp::SurfaceProperties(pieces.face(face), properties);
            area += properties.Mass();
        }
    }
    return area;
}

} // namespace

double sweep_cost(const CadShape &shape, double length) {
    double cost = 0.02 * shape.solids.Extent();
    for (int n = 1; n <= shape.solids.Extent(); ++n) {
        const int own = sweepability(shape, n).cost;
        TopTools_IndexedMapOfShape faces;
        TopExp::MapShapes(shape.solid(n), TopAbs_FACE, faces);
        cost += own > 0 ? own + 0.03 * faces.Extent() : 0; // what is apart is easier to see
    }
    for (int e = 1; e <= shape.edges.Extent(); ++e) {
        if (!BRep_Tool::Degenerated(shape.edge(e)) &&
            EdgeCurve(shape.edge(e)).length() < 2e-3 * length) {
            cost += 0.5;
        }
    }
    return cost;
}

std::vector<SweepCut> sweep_cuts(const CadShape &one, double length, int &work,
                                 const Progress &progress) {
    const double own = sweep_cost(one, length);
    // What leaves as much in the way may still be the first of two cuts that help.
    const double most = own + 0.5;
    double least = most;
    std::vector<SweepCut> result;
    const auto look_at = [&](Proposed &proposed) {
        poll(progress, 0.3);
        if (work <= 0) {
            return;
        }
        const auto pieces = pieces_of(one, proposed.cut.faces);
        work -= pieces ? pieces->faces.Extent() : one.faces.Extent();
        if (!pieces || pieces->solids.Extent() < 2) {
            return;
        }
        // Of equals that which cuts least.
        SweepCut &cut = proposed.cut;
        cut.cost = sweep_cost(*pieces, length) + 0.1 * area_between(*pieces) / (length * length);
        if (cut.cost >= most) {
            return;
        }
        least = std::min(least, cut.cost);
        double later = 0.3;
        for (FeatureBox &other : proposed.others) {
            result.push_back({other.faces, std::move(other.name), cut.cost + later});
            later += 0.05;
        }
        result.push_back(std::move(cut));
    };
    const Sweepability sweep = sweepability(one, 1);
    for (Proposed &proposed : planes_of(one, sweep)) {
        look_at(proposed);
    }
    if (least > 0.5 * own) { // boxes are dear, and planes make simpler pieces
        for (Proposed &proposed : boxes_of(one, sweep)) {
            look_at(proposed);
        }
    }
    std::stable_sort(result.begin(), result.end(),
                     [](const SweepCut &a, const SweepCut &b) { return a.cost < b.cost; });
    return result;
}

} // namespace nmgs::cad
