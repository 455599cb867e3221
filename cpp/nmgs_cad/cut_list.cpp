// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs_cad/cut_list.h"

#include "nmgs_cad/cut_proposals.h"
#include "nmgs_cad/occt_vec.h"

#include <BRepBndLib.hxx>
#include <Bnd_Box.hxx>

namespace nmgs::cad {

std::vector<CutFigures> cut_list(const CadShape &shape, int solid) {
    Bnd_Box box;
    BRepBndLib::Add(shape.shape, box, Standard_False);
    const Vec3 middle = 0.5 * (vec(box.CornerMin()) + vec(box.CornerMax()));
    std::vector<CutFigures> result;
    for (const Cut &cut : propose_cuts(shape, solid)) {
        CutFigures figures;
        figures.direction = vec(cut.place.Direction().XYZ());
        const Vec3 place = vec(cut.place.Location());
        const double along = dot(middle - place, figures.direction);
        figures.origin =
            cut.cylinder ? place + along * figures.direction : middle - along * figures.direction;
        figures.radius = cut.cylinder ? cut.radius : 0.0;
        figures.name = cut.name;
        figures.entities = cut.entities;
        figures.resolves = cut.resolves;
        result.push_back(std::move(figures));
    }
    return result;
}

} // namespace nmgs::cad
