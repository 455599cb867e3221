// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs_cad/face_projection.h"

#include <BRep_Tool.hxx>
#include <Geom_Surface.hxx>
#include <Precision.hxx>

namespace nmgs::cad {

FaceProjection::FaceProjection(const TopoDS_Face &face)
    : surface_(new ShapeAnalysis_Surface(BRep_Tool::Surface(face))),
      precision_(Precision::Confusion()) {}

Vec3 FaceProjection::nearest(Vec3 p) {
    const gp_Pnt point(p.x, p.y, p.z);
    guess_ = has_guess_ ? surface_->NextValueOfUV(guess_, point, precision_)
                        : surface_->ValueOfUV(point, precision_);
    has_guess_ = true;
    const gp_Pnt q = surface_->Value(guess_);
    return {q.X(), q.Y(), q.Z()};
}

} // namespace nmgs::cad
