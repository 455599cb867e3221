// SPDX-License-Identifier: LGPL-2.1-or-later
// Improves layouts and meshes over CAD: nodes on vertices stay, those on edges and faces slide. See
// nmgs/quality/untangle.h for the algorithm.
#pragma once

#include "nmgs/mesh/mesh.h"
#include "nmgs/quality/untangle.h"
#include "nmgs_cad/layout.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace nmgs::cad {

// Least over the corners of the layout's hexahedra from number `first` on, or of its quads where it
// has no hexahedra, edges taken as straight; those of quads by their face's normal. 1 where there
// are none.
double worst_scaled_jacobian(const CadShape &shape, const Layout &layout, std::size_t first = 0);

// Moves the points of the hexahedra (of the quads, where there are no hexahedra) until the worst
// scaled Jacobian stops rising, or reaches options.good; gives it. Points that only other cells
// have stay. Middles beside moved points move along. Raises Cancelled.
double improve(const CadShape &shape, Layout &layout, const UntangleOptions &options = {},
               const Progress &progress = {});

// Whether any linear cell of a mesh has a scaled Jacobian below `bad`.
bool has_bad_cells(std::span<const Vec3> points, std::span<const std::int32_t> hexahedra,
                   std::span<const std::int32_t> quads, std::span<const std::int32_t> face_of,
                   double bad);

// As improve(), for the neighbourhoods of those linear cells of a mesh whose scaled Jacobian is
// below `bad`; nothing is done where there are none. on: of each node, the entity that it lies on,
// dimension 3 where it is free; a node of dimension -1 stays. Of a mesh of quads, face_of: each
// quad's CAD face. The numbers of the points that moved, ascending.
std::vector<std::int32_t>
improve_mesh(const CadShape &shape, std::span<Vec3> points, std::span<const CadEntity> on,
             std::span<const std::int32_t> hexahedra, std::span<const std::int32_t> quads,
             std::span<const std::int32_t> face_of, double bad, const UntangleOptions &options = {},
             const Progress &progress = {});

// Raises each corner of a mesh of hexahedra that is below `good`, as far as it will go; see
// UntangleOptions::each. Raises Cancelled.
void raise_mesh(const CadShape &shape, std::span<Vec3> points, std::span<const CadEntity> on,
                std::span<const std::array<std::int32_t, 8>> hexahedra, double good, int visits,
                const Progress &progress = {});

// Improves neighbourhoods of the hexahedra below `bad`, each by itself, the worst first, towards
// `good`: what nothing helps keeps the others from nothing. At most so many neighbourhoods. Whether
// there were any. Raises Cancelled.
bool improve_spots(const CadShape &shape, std::span<Vec3> points, std::span<const CadEntity> on,
                   std::span<const std::array<std::int32_t, 8>> hexahedra, double bad, double good,
                   int most, const Progress &progress = {});

} // namespace nmgs::cad
