// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs_cad/imprint_sweeps.h"

#include "nmgs/support/at.h"
#include "nmgs_cad/edge_curve.h"
#include "nmgs_cad/entity_locator.h"
#include "nmgs_cad/inner_faces.h"
#include "nmgs_cad/occt_vec.h"
#include "nmgs_cad/sweepability.h"

#include <BRepAlgoAPI_Section.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRep_Tool.hxx>
#include <Standard_Failure.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <gp_Pln.hxx>

#include <algorithm>
#include <cmath>

namespace nmgs::cad {
namespace {

struct Painter {
    const CadShape &cad;
    std::vector<std::optional<Vec3>> along; // of each piece, from 1
    double tolerance;
    TopTools_ListOfShape lines;

    // Levels of the piece's vertices.
    [[nodiscard]] std::vector<double> levels(int piece, Vec3 direction) const {
        std::vector<double> found;
        TopTools_IndexedMapOfShape vertices;
        TopExp::MapShapes(cad.solids(piece), TopAbs_VERTEX, vertices);
        for (int v = 1; v <= vertices.Extent(); ++v) {
            found.push_back(dot(vec(BRep_Tool::Pnt(TopoDS::Vertex(vertices(v))).XYZ()), direction));
        }
        std::sort(found.begin(), found.end());
        found.erase(std::unique(found.begin(), found.end(),
                                [&](double a, double b) { return b - a < 10 * tolerance; }),
                    found.end());
        return found;
    }
    // Where the face and the surface meet, other than along what is there already.
    void draw(int face, const TopoDS_Shape &surface, std::vector<EdgeCurve> &there) {
        BRepAlgoAPI_Section section(cad.face(face), surface, Standard_False);
        section.Build();
        if (!section.IsDone()) {
            return;
        }
        for (TopExp_Explorer it(section.Shape(), TopAbs_EDGE); it.More(); it.Next()) {
            const TopoDS_Edge edge = TopoDS::Edge(it.Current());
            EdgeCurve curve(edge);
            if (curve.length() < 20 * tolerance) {
                continue;
            }
            const bool known = std::any_of(there.begin(), there.end(), [&](EdgeCurve &other) {
                return std::all_of(std::begin(places), std::end(places), [&](double f) {
                    const Vec3 p = curve.at(f);
                    return distance(other.at(other.fraction(p)), p) < 10 * tolerance;
                });
            });
            if (!known) {
                lines.Append(edge);
                there.push_back(std::move(curve));
            }
        }
    }
    void of_levels(int face, int piece, Vec3 direction, std::vector<EdgeCurve> &there) {
        const double reach = 2 * extent;
        double low = 1e300;
        double high = -1e300;
        for (const EdgeCurve &curve : there) {
            for (int i = 0; i <= 8; ++i) {
                const double t = dot(curve.at(i / 8.0), direction);
                low = std::min(low, t);
                high = std::max(high, t);
            }
        }
        for (const double t : levels(piece, direction)) {
            if (t > low + 20 * tolerance && t < high - 20 * tolerance) {
                const Vec3 q = there.front().at(0);
                const Vec3 p = q + (t - dot(q, direction)) * direction;
                const gp_Pln plane(gp_Pnt(p.x, p.y, p.z),
                                   gp_Dir(direction.x, direction.y, direction.z));
                draw(face, BRepBuilderAPI_MakeFace(plane, -reach, reach, -reach, reach).Shape(),
                     there);
            }
        }
    }
    void of_walls(int face, int piece, Vec3 direction, std::vector<EdgeCurve> &there) {
        TopTools_IndexedMapOfShape own;
        TopExp::MapShapes(cad.face(face), TopAbs_EDGE, own);
        TopTools_IndexedMapOfShape edges;
        TopExp::MapShapes(cad.solids(piece), TopAbs_EDGE, edges);
        const gp_Vec reach(2 * extent * direction.x, 2 * extent * direction.y,
                           2 * extent * direction.z);
        for (int e = 1; e <= edges.Extent(); ++e) {
            const TopoDS_Edge edge = TopoDS::Edge(edges(e));
            if (own.Contains(edge) || BRep_Tool::Degenerated(edge)) {
                continue;
            }
            const EdgeCurve curve(edge);
            const double level = dot(curve.at(0), direction);
            if (std::any_of(std::begin(places), std::end(places), [&](double f) {
                    return std::abs(dot(curve.at(f), direction) - level) > 2 * tolerance;
                })) {
                continue; // along the sweep, or on a slope
            }
            gp_Trsf back;
            back.SetTranslation(-1.0 * reach);
            draw(face,
                 BRepPrimAPI_MakePrism(BRepBuilderAPI_Transform(edge, back).Shape(), 2.0 * reach)
                     .Shape(),
                 there);
        }
    }
    double extent = 1;
    static constexpr double places[] = {0.13, 0.5, 0.77};
};

} // namespace

std::optional<Pieces> imprint_sweeps(const CadShape &shape, const Pieces &pieces) {
    std::optional<Pieces> result;
    constexpr int rounds = 3; // lines go on through pieces to the faces on their other sides
    for (int round = 0; round < rounds; ++round) {
        const Pieces &now = result ? *result : pieces;
        const CadShape &cad = now.cad;
        Painter painter{cad, {std::nullopt}, 0, {}};
        painter.extent = extent_of(cad.shape);
        painter.tolerance = 1e-6 * painter.extent;
        for (int n = 1; n <= cad.solids.Extent(); ++n) {
            const auto directions = sweepability(cad, n).directions;
            painter.along.push_back(directions.empty() ? std::nullopt
                                                       : std::optional(directions.front().along));
        }
        try {
            for (const auto &[face, solids] : inner_faces(cad)) {
                std::vector<EdgeCurve> there;
                for (TopExp_Explorer it(cad.faces(face), TopAbs_EDGE); it.More(); it.Next()) {
                    if (!BRep_Tool::Degenerated(TopoDS::Edge(it.Current()))) {
                        there.emplace_back(TopoDS::Edge(it.Current()));
                    }
                }
                for (const int n : solids) {
                    if (!painter.along[at(n)]) {
                        continue;
                    }
                    const Vec3 along = *painter.along[at(n)];
                    if (runs_along(cad.face(face), along)) {
                        painter.of_levels(face, n, along, there);
                    } else {
                        painter.of_walls(face, n, along, there);
                    }
                }
            }
        } catch (const Standard_Failure &) {
            return result;
        }
        constexpr int most_lines = 60;
        if (painter.lines.IsEmpty() || painter.lines.Extent() > most_lines) {
            return result;
        }
        Refusal refusal;
        auto next = split(shape, now, painter.lines, refusal);
        if (!next || next->cad.solids.Extent() != cad.solids.Extent()) {
            return result;
        }
        result = std::move(next);
    }
    return result;
}

} // namespace nmgs::cad
