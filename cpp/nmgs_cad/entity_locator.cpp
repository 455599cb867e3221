// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs_cad/entity_locator.h"

#include "nmgs_cad/occt_vec.h"

#include <BRepAdaptor_Curve.hxx>
#include <BRepBndLib.hxx>
#include <BRepTopAdaptor_FClass2d.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <Extrema_ExtPC.hxx>
#include <Precision.hxx>
#include <ShapeAnalysis_Surface.hxx>
#include <TopExp.hxx>

#include <algorithm>
#include <cmath>
#include <limits>

namespace nmgs::cad {
namespace {

Box box_of(const TopoDS_Shape &shape, double gap) {
    Bnd_Box bounds;
    BRepBndLib::Add(shape, bounds, Standard_False);
    Box box;
    if (!bounds.IsVoid()) {
        double a[6];
        bounds.Get(a[0], a[1], a[2], a[3], a[4], a[5]);
        box.add({a[0] - gap, a[1] - gap, a[2] - gap});
        box.add({a[3] + gap, a[4] + gap, a[5] + gap});
    }
    return box;
}

std::vector<int> numbers(const TopTools_IndexedMapOfShape &all, const TopoDS_Shape &in,
                         TopAbs_ShapeEnum type) {
    TopTools_IndexedMapOfShape map;
    TopExp::MapShapes(in, type, map);
    std::vector<int> result;
    for (int i = 1; i <= map.Extent(); ++i) {
        result.push_back(all.FindIndex(map(i)));
    }
    std::sort(result.begin(), result.end());
    return result;
}

} // namespace

double extent_of(const TopoDS_Shape &shape) {
    return box_of(shape, 0).diagonal();
}

struct EntityLocator::Curves {
    struct Curve {
        BRepAdaptor_Curve curve;
        Box box;
        double tolerance;
    };
    std::vector<Curve> list;
};

struct EntityLocator::Surfaces {
    struct Surface {
        Handle(ShapeAnalysis_Surface) surface;
        std::unique_ptr<BRepTopAdaptor_FClass2d> inside;
        Box box;
        double tolerance;
    };
    std::vector<Surface> list;
};

EntityLocator::EntityLocator(const CadShape &shape, int solid, double tolerance)
    : solid_(solid), curves_(new Curves), surfaces_(new Surfaces) {
    const TopoDS_Solid in = shape.solid(solid);
    vertices_ = numbers(shape.vertices, in, TopAbs_VERTEX);
    for (const int n : vertices_) {
        places_.push_back(shape.point(n));
        vertex_tolerance_.push_back(tolerance + BRep_Tool::Tolerance(shape.vertex(n)));
    }
    for (const int n : numbers(shape.edges, in, TopAbs_EDGE)) {
        const TopoDS_Edge edge = shape.edge(n);
        if (BRep_Tool::Degenerated(edge)) {
            continue;
        }
        const double gap = tolerance + BRep_Tool::Tolerance(edge);
        edges_.push_back(n);
        curves_->list.push_back({BRepAdaptor_Curve(edge), box_of(edge, gap), gap});
    }
    faces_ = numbers(shape.faces, in, TopAbs_FACE);
    for (const int n : faces_) {
        const TopoDS_Face face = shape.face(n);
        const double gap = tolerance + BRep_Tool::Tolerance(face);
        surfaces_->list.push_back({new ShapeAnalysis_Surface(BRep_Tool::Surface(face)),
                                   std::make_unique<BRepTopAdaptor_FClass2d>(face, 1e-9),
                                   box_of(face, gap), gap});
    }
}

EntityLocator::~EntityLocator() = default;

double EntityLocator::distance_to_edge(std::size_t at, Vec3 p) const {
    const auto &[curve, box, gap] = curves_->list[at];
    constexpr double far = std::numeric_limits<double>::infinity();
    if (!box.near(p, 0)) {
        return far;
    }
    const gp_Pnt q = pnt(p);
    double best = std::min(q.Distance(curve.Value(curve.FirstParameter())),
                           q.Distance(curve.Value(curve.LastParameter())));
    const Extrema_ExtPC extrema(q, curve);
    if (extrema.IsDone()) {
        for (int i = 1; i <= extrema.NbExt(); ++i) {
            best = std::min(best, std::sqrt(extrema.SquareDistance(i)));
        }
    }
    return best <= gap ? best : far;
}

double EntityLocator::distance_to_face(std::size_t at, Vec3 p) const {
    const auto &[surface, inside, box, gap] = surfaces_->list[at];
    constexpr double far = std::numeric_limits<double>::infinity();
    if (!box.near(p, 0)) {
        return far;
    }
    const gp_Pnt2d uv = surface->ValueOfUV(pnt(p), Precision::Confusion());
    if (surface->Gap() > gap) {
        return far;
    }
    const TopAbs_State state = inside->Perform(uv);
    return state == TopAbs_IN || state == TopAbs_ON ? surface->Gap() : far;
}

CadEntity EntityLocator::at(Vec3 p, int least_dimension) const {
    double best = std::numeric_limits<double>::infinity();
    CadEntity found{3, solid_};
    if (least_dimension <= 0) {
        for (std::size_t i = 0; i < vertices_.size(); ++i) {
            const double d = distance(p, places_[i]);
            if (d <= vertex_tolerance_[i] && d < best) {
                best = d;
                found = {0, vertices_[i]};
            }
        }
    }
    if (found.dimension == 3 && least_dimension <= 1) {
        for (std::size_t i = 0; i < edges_.size(); ++i) {
            const double d = distance_to_edge(i, p);
            if (d < best) {
                best = d;
                found = {1, edges_[i]};
            }
        }
    }
    if (found.dimension == 3 && least_dimension <= 2) {
        for (std::size_t i = 0; i < faces_.size(); ++i) {
            const double d = distance_to_face(i, p);
            if (d < best) {
                best = d;
                found = {2, faces_[i]};
            }
        }
    }
    return found;
}

bool EntityLocator::on_edge(Vec3 p, int n) const {
    const auto it = std::lower_bound(edges_.begin(), edges_.end(), n);
    return it != edges_.end() && *it == n &&
           std::isfinite(distance_to_edge(static_cast<std::size_t>(it - edges_.begin()), p));
}

bool EntityLocator::on_face(Vec3 p, int n) const {
    const auto it = std::lower_bound(faces_.begin(), faces_.end(), n);
    return it != faces_.end() && *it == n &&
           std::isfinite(distance_to_face(static_cast<std::size_t>(it - faces_.begin()), p));
}

} // namespace nmgs::cad
