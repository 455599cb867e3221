// SPDX-License-Identifier: LGPL-2.1-or-later
// Solids that a plane section sweeps: along a line, or about an axis.
#pragma once

#include "nmgs_cad/cad_shape.h"
#include "nmgs_cad/hexas_on_cad.h"
#include "nmgs_cad/layout_options.h"

#include <TopoDS_Solid.hxx>
#include <gp_Ax1.hxx>

#include <functional>
#include <vector>

namespace nmgs::cad {

// A shift along an axis by lengths, or a turn about it by angles.
struct Motion {
    gp_Ax1 axis;
    bool turn = false;

    [[nodiscard]] Vec3 move(Vec3 p, double by) const;
    [[nodiscard]] TopoDS_Shape move(const TopoDS_Shape &shape, double by) const;
};

// The faces of a plane arrangement, and where along a motion the columns over them are solid. A
// solid whose faces are either walls, which the motion moves along themselves, or plane caps across
// it, is the union of such columns: extrusions with bosses, pockets, steps and holes are.
struct Section {
    CadShape cad;
    Motion motion;
    double base = 0;            // level at which cad lies
    std::vector<double> levels; // ascending; of all caps and vertices
    bool closed = false;        // a full turn: the last level is the first one again
    // Of face n (from 1) and the interval after level k: filled[n][k].
    std::vector<std::vector<char>> filled;

    struct Height {
        double level;
        bool exact; // on a cap; otherwise between the column's caps
    };
    // Where caps are not all across the motion: how high level k lies over a place of face n.
    // Asked of levels that the column reaches. Empty: levels are what they say.
    std::function<Height(int face, Vec3 place, std::size_t k)> height;
};

// The section of a solid along a direction. False and why: some face is neither wall nor cap, or an
// edge runs across a wall. Points of the layout along edges make levels too.
bool section_along(const CadShape &shape, int solid, const gp_Dir &direction, const Layout &layout,
                   Section &section, Refusal &refusal);

// The arrangement's faces over which the solid has anything become section.cad, and section.filled
// is found; levels, base and motion are given.
void fill_columns(const TopoDS_Solid &solid, const TopoDS_Shape &arrangement, Section &section);

// Hexahedra over the quads of a section.
struct Carried {
    HexaMesh mesh;
    // points[k][p]: the flat layout's point p at level k, -1 where nothing is.
    std::vector<std::vector<std::int32_t>> points;
};
Carried carry_section(const Section &section, const Layout &flat);

// Lays the section out in quads and carries them through the levels.
bool sweep_section(const CadShape &shape, int solid, const Section &section, Layout &layout,
                   const LayoutOptions &options, Refusal &refusal, const Progress &progress);

} // namespace nmgs::cad
