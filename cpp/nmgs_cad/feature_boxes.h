// SPDX-License-Identifier: LGPL-2.1-or-later
// Boxes round what crosses a sweep: a hole from the side, a boss on a wall. What is left is swept
// past the box, and what is in the box along the feature.
#pragma once

#include "nmgs_cad/sweepability.h"

#include <TopTools_ListOfShape.hxx>

#include <array>
#include <string>
#include <vector>

namespace nmgs::cad {

struct FeatureBox {
    TopTools_ListOfShape faces; // of the box, plane
    std::string name;           // "box round Face3"
    Vec3 middle{};
    std::array<double, 3> sizes{}; // ascending
};

// Whether two boxes are one, whichever way they were made.
bool same(const FeatureBox &a, const FeatureBox &b);

// Round each group of faces that are joined and stand in the way of the sweep, if they run along a
// line square to it: once as long as they are, and once through the whole solid. margin: how far
// the box's sides are from the faces, of the faces' greater width; they keep to planes of the
// solid.
std::vector<FeatureBox> feature_boxes(const CadShape &shape, int solid,
                                      const SweepDirection &direction, double margin);

} // namespace nmgs::cad
