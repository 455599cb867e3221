// SPDX-License-Identifier: AGPL-3.0-or-later
// TetGen's output as the arrays of an answer.
#pragma once

#include "nmgs_tet/frame.h"

#include <tetgen.h>

namespace nmgs::tet {

// Numbers of the answer's arrays. All indices are 0-based; -1 is "none".
enum class Out : std::uint32_t {
    points = 200,                // float64 (N, 3)
    point_attributes = 201,      // float64 (N, k)
    point_markers = 202,         // int32 (N)
    point_sizes = 203,           // float64 (N, 1 | 6)
    tetra = 210,                 // int32 (M, 4 | 10), VTK's node order
    tetra_attributes = 211,      // float64 (M, k)
    neighbours = 212,            // int32 (M, 4), opposite to each corner, -n
    triangles = 220,             // int32 (T, 3 | 6), VTK's node order, normals out of the volume
    triangle_markers = 221,      // int32 (T)
    triangle_tetra = 222,        // int32 (T, 2), on both sides, -nn
    edges = 230,                 // int32 (E, 2 | 3), VTK's node order
    edge_markers = 231,          // int32 (E)
    voronoi_points = 240,        // float64 (V, 3), -v
    voronoi_edges = 241,         // int32 (E, 2), -1 for a ray
    voronoi_rays = 242,          // float64 (E, 3), direction of a ray, else 0
    voronoi_facet_cells = 243,   // int32 (F, 2), the two points that a facet parts
    voronoi_facet_edges = 244,   // int32, edges of all facets; -1 closes over infinity
    voronoi_facet_offsets = 245, // int64 (F + 1)
    voronoi_cell_facets = 246,   // int32, facets of all cells
    voronoi_cell_offsets = 247,  // int64 (N + 1)
};

// Writes every array that TetGen made. Permutes nodes in place.
void write_result(int descriptor, tetgenio &result);

} // namespace nmgs::tet
