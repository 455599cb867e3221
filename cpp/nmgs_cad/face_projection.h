// SPDX-License-Identifier: LGPL-2.1-or-later
// Nearest points of a CAD face's surface.
#pragma once

#include "nmgs/support/vec3.h"

#include <ShapeAnalysis_Surface.hxx>
#include <TopoDS_Face.hxx>
#include <gp_Pnt2d.hxx>

namespace nmgs::cad {

// Remembers the last answer as the first guess of the next: ask for points in rows.
class FaceProjection {
public:
    explicit FaceProjection(const TopoDS_Face &face);

    // Nearest point of the surface that carries the face.
    Vec3 nearest(Vec3 p);

private:
    Handle(ShapeAnalysis_Surface) surface_;
    bool has_guess_ = false;
    gp_Pnt2d guess_;
    double precision_;
};

} // namespace nmgs::cad
