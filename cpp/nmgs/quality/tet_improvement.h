// SPDX-License-Identifier: LGPL-2.1-or-later
// Improves the worst tetrahedra of a mesh that are to be split into four hexahedra each. Klingner
// and Shewchuk, Aggressive tetrahedral mesh improvement, Proc. 16th Int. Meshing Roundtable, 2007:
// edges are removed (the ring's best triangulation by Klincsek's dynamic programme), vertices are
// smoothed, and cavities round bad tetrahedra are filled anew from a vertex inside.
#pragma once

#include "nmgs/support/progress.h"
#include "nmgs/support/vec3.h"

#include <array>
#include <cstdint>
#include <map>
#include <vector>

namespace nmgs {

struct TetMesh {
    std::vector<Vec3> points;
    std::vector<char> fixed; // by point: neither moves nor goes
    struct Tet {
        std::array<std::int32_t, 4> p; // positive volume
        std::int32_t part;             // tetrahedra of different parts keep what they share
    };
    std::vector<Tet> tets;
    // Edges that stay, ascending ends, and where the hexahedra's point on each is; the others' is
    // their middle.
    std::map<std::array<std::int32_t, 2>, Vec3> middles;
    // Faces that stay, ascending corners, and the hexahedra's point on each. All faces of one
    // tetrahedron only and those between parts must be here, and their edges in middles.
    std::map<std::array<std::int32_t, 3>, Vec3> centres;
};

struct TetImprovementOptions {
    double good = 0.3; // tetrahedra with hexahedra no worse than this are left as they are
    int rounds = 8;    // over those that are not, at most
    long work = 0;     // tetrahedra that may be measured; 0: by their number
};

// Least hexas_quality() (hexas_of_tet.h) of the mesh after it. Points that go stay in the list, in
// no tetrahedron; new ones are appended. Never makes the worst worse. Raises Cancelled.
double improve_tets(TetMesh &mesh, const TetImprovementOptions &options = {},
                    const Progress &progress = {});

} // namespace nmgs
