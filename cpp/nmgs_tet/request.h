// SPDX-License-Identifier: AGPL-3.0-or-later
// What the worker is asked: TetGen's switches and its input, as the arrays of one request.
#pragma once

#include "nmgs_tet/frame.h"

#include <map>
#include <memory>

namespace nmgs::tet {

// Numbers of the request's arrays. All indices are 0-based.
enum class In : std::uint32_t {
    switches = 100,            // bytes
    points = 101,              // float64 (N, 3)
    point_attributes = 102,    // float64 (N, k)
    point_markers = 103,       // int32 (N)
    point_sizes = 104,         // float64 (N, 1 | 6), -m
    polygon_nodes = 110,       // int32 (S), corners of all polygons
    polygon_offsets = 111,     // int64 (P + 1), into polygon_nodes
    facet_offsets = 112,       // int64 (F + 1), into the polygons
    facet_markers = 113,       // int32 (F)
    facet_holes = 114,         // float64 (H, 3)
    facet_hole_offsets = 115,  // int64 (F + 1), into facet_holes
    facet_constraints = 116,   // float64 (C, 2): marker, largest area
    segment_constraints = 117, // float64 (C, 3): two nodes, longest length
    edges = 118,               // int32 (E, 2), segments beside the facets' own
    edge_markers = 119,        // int32 (E)
    holes = 120,               // float64 (H, 3)
    regions = 121,             // float64 (R, 5): point, attribute, largest volume
    stl = 122,                 // int32 (1): not 0 where facets are an STL file's triangles
    tetra = 130,               // int32 (M, 4 | 10), TetGen's node order, -r
    tetra_attributes = 131,    // float64 (M, k)
    tetra_volumes = 132,       // float64 (M), largest volume of each, -ra
    triangles = 133,           // int32 (T, 3), boundary of tetra
    triangle_markers = 134,    // int32 (T)
    added_points = 140,        // float64 (N, 3), -i
    background_points = 150,   // float64 (N, 3), -m
    background_tetra = 151,    // int32 (M, 4)
    background_sizes = 152,    // float64 (N, 1 | 6)
};

// Memory of one array, as it came.
struct InArray {
    Scalar scalar = Scalar::bytes;
    std::size_t rows = 0;
    std::size_t columns = 0;
    std::unique_ptr<std::byte[]> data;
};

struct Request {
    std::int64_t memory_limit = 0; // bytes of address space; 0 for none
    std::map<In, InArray> arrays;

    [[nodiscard]] bool has(In id) const { return arrays.contains(id); }
    [[nodiscard]] std::size_t rows(In id) const;
    [[nodiscard]] std::size_t columns(In id) const;
    // Null where the array is absent or empty. Raises ProtocolError on another scalar.
    [[nodiscard]] double *doubles(In id) const;
    [[nodiscard]] std::int32_t *ints(In id) const;
    [[nodiscard]] std::int64_t *longs(In id) const;
    [[nodiscard]] std::string text(In id) const;

private:
    [[nodiscard]] void *data(In id, Scalar scalar) const;
};

// Reads a request up to 'go'. The memory limit holds from its first frame on.
// Raises ProtocolError, EndOfInput, std::bad_alloc.
Request read_request(int descriptor);

} // namespace nmgs::tet
