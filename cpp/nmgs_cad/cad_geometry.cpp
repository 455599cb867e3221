// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs_cad/cad_geometry.h"

#include <BRepBndLib.hxx>
#include <Bnd_Box.hxx>
#include <Standard_Failure.hxx>

#include <cmath>
#include <utility>

namespace nmgs::cad {

CadGeometry::CadGeometry(const CadShape &shape)
    : curves_(static_cast<std::size_t>(shape.edges.Extent()) + 1),
      faces_(static_cast<std::size_t>(shape.faces.Extent()) + 1) {
    edge_shapes_.emplace_back();
    for (int n = 1; n <= shape.edges.Extent(); ++n) {
        edge_shapes_.push_back(shape.edge(n));
    }
    face_shapes_.emplace_back();
    for (int n = 1; n <= shape.faces.Extent(); ++n) {
        face_shapes_.push_back(shape.face(n));
    }
}

EdgeCurve &CadGeometry::curve(int n) {
    const auto i = static_cast<std::size_t>(n);
    if (!curves_[i]) {
        curves_[i] = std::make_unique<EdgeCurve>(edge_shapes_[i]);
    }
    return *curves_[i];
}

FaceProjection &CadGeometry::face(int n) {
    const auto i = static_cast<std::size_t>(n);
    if (!faces_[i]) {
        faces_[i] = std::make_unique<FaceProjection>(face_shapes_[i]);
    }
    faces_[i]->forget();
    return *faces_[i];
}

std::unique_ptr<CadGeometry> CadGeometryPool::take(const CadShape &shape) {
    {
        const std::scoped_lock lock(mutex_);
        if (!free_.empty()) {
            auto geometry = std::move(free_.back());
            free_.pop_back();
            return geometry;
        }
    }
    return std::make_unique<CadGeometry>(shape);
}

void CadGeometryPool::give_back(std::unique_ptr<CadGeometry> geometry) {
    const std::scoped_lock lock(mutex_);
    free_.push_back(std::move(geometry));
}

double CadGeometryPool::diagonal(const TopoDS_Shape &shape) {
    const std::scoped_lock lock(mutex_);
    if (!diagonal_) {
        Bnd_Box box;
        try {
            BRepBndLib::AddOptimal(shape, box, Standard_False, Standard_False);
        } catch (const Standard_Failure &) { // it has no box for some faces; the other is larger
            box = Bnd_Box();
            BRepBndLib::Add(shape, box, Standard_False);
        }
        diagonal_ = box.IsVoid() ? 0.0 : std::sqrt(box.SquareExtent());
    }
    return *diagonal_;
}

BorrowedGeometry::BorrowedGeometry(const CadShape &shape)
    : pool_(shape.geometry), geometry_(pool_->take(shape)) {}

BorrowedGeometry::~BorrowedGeometry() {
    pool_->give_back(std::move(geometry_));
}

} // namespace nmgs::cad
