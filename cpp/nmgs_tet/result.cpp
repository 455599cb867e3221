// SPDX-License-Identifier: AGPL-3.0-or-later
#include "nmgs_tet/result.h"

#include <algorithm>
#include <array>
#include <utility>

namespace nmgs::tet {
namespace {

void send(int descriptor, Out id, const double *data, std::uint64_t rows, std::uint64_t columns) {
    if (data != nullptr && columns > 0) {
        write_frame(descriptor, static_cast<std::uint32_t>(id), Scalar::float64, data, rows,
                    columns);
    }
}

void send(int descriptor, Out id, const int *data, std::uint64_t rows, std::uint64_t columns) {
    if (data != nullptr && columns > 0) {
        write_frame(descriptor, static_cast<std::uint32_t>(id), Scalar::int32, data, rows, columns);
    }
}

template <class T>
void send_list(int descriptor, Out id, const std::vector<T> &values, std::uint64_t columns) {
    write_frame(descriptor, static_cast<std::uint32_t>(id),
                std::is_same_v<T, double>         ? Scalar::float64
                : std::is_same_v<T, std::int64_t> ? Scalar::int64
                                                  : Scalar::int32,
                values.data(), values.size() / columns, columns);
}

// TetGen's mid-nodes lie on the edges 23, 03, 01, 12, 13, 02; VTK's on 01, 12, 02, 03, 13, 23.
void to_vtk_order(int *nodes, int count) {
    constexpr std::array<int, 6> from{2, 3, 5, 1, 4, 0};
    for (int t = 0; t < count; ++t) {
        int *middle = nodes + 10L * t + 4;
        const std::array<int, 6> old{middle[0], middle[1], middle[2],
                                     middle[3], middle[4], middle[5]};
        for (std::size_t i = 0; i < from.size(); ++i) {
            middle[i] = old[static_cast<std::size_t>(from[i])];
        }
    }
}

void send_tetra(int descriptor, tetgenio &result) {
    if (result.numberofcorners == 10 && result.tetrahedronlist != nullptr) {
        to_vtk_order(result.tetrahedronlist, result.numberoftetrahedra);
    }
    const auto count = static_cast<std::uint64_t>(result.numberoftetrahedra);
    send(descriptor, Out::tetra, result.tetrahedronlist, count,
         static_cast<std::uint64_t>(result.numberofcorners));
    send(descriptor, Out::tetra_attributes, result.tetrahedronattributelist, count,
         static_cast<std::uint64_t>(result.numberoftetrahedronattributes));
    send(descriptor, Out::neighbours, result.neighborlist, count, 4);
}

// TetGen's normals point into the volume; the field's point out of it.
void send_triangles(int descriptor, tetgenio &result) {
    const auto count = static_cast<std::size_t>(result.numberoftrifaces);
    if (result.trifacelist == nullptr) {
        return;
    }
    if (result.o2facelist != nullptr) {
        std::vector<int> nodes(6 * count);
        for (std::size_t t = 0; t < count; ++t) {
            const int *corner = result.trifacelist + 3 * t;
            const int *middle = result.o2facelist + 3 * t;
            const std::array<int, 6> row{corner[0], corner[2], corner[1],
                                         middle[2], middle[1], middle[0]};
            std::copy(row.begin(), row.end(), nodes.begin() + static_cast<std::ptrdiff_t>(6 * t));
        }
        send_list(descriptor, Out::triangles, nodes, 6);
    } else {
        for (std::size_t t = 0; t < count; ++t) {
            std::swap(result.trifacelist[3 * t + 1], result.trifacelist[3 * t + 2]);
        }
        send(descriptor, Out::triangles, result.trifacelist, count, 3);
    }
    send(descriptor, Out::triangle_markers, result.trifacemarkerlist, count, 1);
    // TetGen 1.5 and 1.6 name the same list differently.
    const auto both_sides = [](auto &io) -> const int * {
        if constexpr (requires { io.face2tetlist; }) {
            return io.face2tetlist;
        } else {
            return io.adjtetlist;
        }
    };
    send(descriptor, Out::triangle_tetra, both_sides(result), count, 2);
}

void send_edges(int descriptor, const tetgenio &result) {
    const auto count = static_cast<std::size_t>(result.numberofedges);
    if (result.edgelist == nullptr) {
        return;
    }
    if (result.o2edgelist != nullptr) {
        std::vector<int> nodes;
        nodes.reserve(3 * count);
        for (std::size_t e = 0; e < count; ++e) {
            nodes.insert(nodes.end(), {result.edgelist[2 * e], result.edgelist[2 * e + 1],
                                       result.o2edgelist[e]});
        }
        send_list(descriptor, Out::edges, nodes, 3);
    } else {
        send(descriptor, Out::edges, result.edgelist, count, 2);
    }
    send(descriptor, Out::edge_markers, result.edgemarkerlist, count, 1);
}

void send_voronoi(int descriptor, const tetgenio &result) {
    if (result.vpointlist == nullptr) {
        return;
    }
    send(descriptor, Out::voronoi_points, result.vpointlist,
         static_cast<std::uint64_t>(result.numberofvpoints), 3);
    std::vector<int> edges;
    std::vector<double> rays;
    for (int e = 0; e < result.numberofvedges; ++e) {
        const tetgenio::voroedge &edge = result.vedgelist[e];
        edges.insert(edges.end(), {edge.v1, edge.v2});
        for (const double v : edge.vnormal) {
            rays.push_back(edge.v2 < 0 ? v : 0.0);
        }
    }
    send_list(descriptor, Out::voronoi_edges, edges, 2);
    send_list(descriptor, Out::voronoi_rays, rays, 3);
    std::vector<int> cells;
    std::vector<int> list;
    std::vector<std::int64_t> offsets{0};
    for (int f = 0; f < result.numberofvfacets; ++f) {
        const tetgenio::vorofacet &facet = result.vfacetlist[f];
        cells.insert(cells.end(), {facet.c1, facet.c2});
        list.insert(list.end(), facet.elist + 1, facet.elist + 1 + facet.elist[0]);
        offsets.push_back(static_cast<std::int64_t>(list.size()));
    }
    send_list(descriptor, Out::voronoi_facet_cells, cells, 2);
    send_list(descriptor, Out::voronoi_facet_edges, list, 1);
    send_list(descriptor, Out::voronoi_facet_offsets, offsets, 1);
    list.clear();
    offsets.assign(1, 0);
    for (int c = 0; c < result.numberofvcells; ++c) {
        const int *cell = result.vcelllist[c];
        list.insert(list.end(), cell + 1, cell + 1 + cell[0]);
        offsets.push_back(static_cast<std::int64_t>(list.size()));
    }
    send_list(descriptor, Out::voronoi_cell_facets, list, 1);
    send_list(descriptor, Out::voronoi_cell_offsets, offsets, 1);
}

} // namespace

void write_result(int descriptor, tetgenio &result) {
    const auto n = static_cast<std::uint64_t>(result.numberofpoints);
    send(descriptor, Out::points, result.pointlist, n, 3);
    send(descriptor, Out::point_attributes, result.pointattributelist, n,
         static_cast<std::uint64_t>(result.numberofpointattributes));
    send(descriptor, Out::point_markers, result.pointmarkerlist, n, 1);
    send(descriptor, Out::point_sizes, result.pointmtrlist, n,
         static_cast<std::uint64_t>(result.numberofpointmtrs));
    send_tetra(descriptor, result);
    send_triangles(descriptor, result);
    send_edges(descriptor, result);
    send_voronoi(descriptor, result);
}

} // namespace nmgs::tet
