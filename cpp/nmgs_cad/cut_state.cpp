// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs_cad/cut_state.h"

#include "nmgs_cad/edge_curve.h"

#include <BRepAdaptor_Surface.hxx>
#include <BRep_Tool.hxx>

namespace nmgs::cad {

std::optional<CutState> cut_further(const CadShape &shape, std::span<const int> solids,
                                    const CutState *before, std::span<const Cut> more,
                                    Refusal &refusal) {
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
    CutState state{std::move(cuts), std::move(*pieces), {}, {}, {}, 0};
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

} // namespace nmgs::cad
