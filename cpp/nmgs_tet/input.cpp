// SPDX-License-Identifier: AGPL-3.0-or-later
#include "nmgs_tet/input.h"

#include <cmath>
#include <limits>

namespace nmgs::tet {
namespace {

[[noreturn]] void fail(const std::string &what) {
    throw InputError(what);
}

void check_rows(const Request &request, In id, std::size_t rows, const char *name) {
    if (request.has(id) && request.rows(id) != rows) {
        fail(std::string(name) + ": expected " + std::to_string(rows) + " rows, got " +
             std::to_string(request.rows(id)));
    }
}

void check_columns(const Request &request, In id, std::size_t columns, const char *name) {
    if (request.rows(id) > 0 && request.columns(id) != columns) {
        fail(std::string(name) + ": expected " + std::to_string(columns) + " columns, got " +
             std::to_string(request.columns(id)));
    }
}

void check_finite(const double *values, std::size_t count, const char *name) {
    for (std::size_t i = 0; i < count; ++i) {
        if (!std::isfinite(values[i])) {
            fail(std::string(name) + ": value " + std::to_string(i) + " is not finite");
        }
    }
}

void check_nodes(const std::int32_t *nodes, std::size_t count, std::size_t points,
                 const char *name) {
    for (std::size_t i = 0; i < count; ++i) {
        if (nodes[i] < 0 || static_cast<std::size_t>(nodes[i]) >= points) {
            fail(std::string(name) + ": node " + std::to_string(nodes[i]) + " is outside 0 to " +
                 std::to_string(points) + " - 1");
        }
    }
}

void check_offsets(const Request &request, In id, std::size_t total, const char *name) {
    const std::int64_t *offsets = request.longs(id);
    const std::size_t count = request.rows(id);
    bool good =
        count > 0 && offsets[0] == 0 && offsets[count - 1] == static_cast<std::int64_t>(total);
    for (std::size_t i = 1; good && i < count; ++i) {
        good = offsets[i - 1] <= offsets[i];
    }
    if (!good) {
        fail(std::string(name) + ": expected ascending numbers from 0 to " + std::to_string(total));
    }
}

int as_int(std::size_t value, const char *name) {
    if (value > static_cast<std::size_t>(std::numeric_limits<int>::max())) {
        fail(std::string(name) + ": TetGen counts to 2147483647 only");
    }
    return static_cast<int>(value);
}

} // namespace

Input::Input(const Request &request) {
    try {
        add_points(request);
        add_facets(request);
        add_tetra(request);
        add_others(request);
    } catch (...) {
        main.initialize();
        added.initialize();
        background.initialize();
        throw;
    }
}

// The memory is the request's, not TetGen's: its destructor must find nothing.
Input::~Input() {
    main.initialize();
    added.initialize();
    background.initialize();
}

void Input::add_points(const Request &request) {
    const std::size_t n = request.rows(In::points);
    check_columns(request, In::points, 3, "points");
    check_finite(request.doubles(In::points), 3 * n, "points");
    main.firstnumber = 0;
    main.numberofpoints = as_int(n, "points");
    main.pointlist = request.doubles(In::points);
    check_rows(request, In::point_attributes, n, "point attributes");
    main.pointattributelist = request.doubles(In::point_attributes);
    main.numberofpointattributes =
        main.pointattributelist == nullptr ? 0 : as_int(request.columns(In::point_attributes), "");
    check_rows(request, In::point_markers, n, "point markers");
    main.pointmarkerlist = request.ints(In::point_markers);
    check_rows(request, In::point_sizes, n, "sizes");
    main.pointmtrlist = request.doubles(In::point_sizes);
    main.numberofpointmtrs =
        main.pointmtrlist == nullptr ? 0 : as_int(request.columns(In::point_sizes), "");
}

void Input::add_facets(const Request &request) {
    const std::size_t n = request.rows(In::points);
    if (request.has(In::facet_offsets)) {
        const std::size_t corners = request.rows(In::polygon_nodes);
        check_nodes(request.ints(In::polygon_nodes), corners, n, "facets");
        check_offsets(request, In::polygon_offsets, corners, "polygon offsets");
        const std::size_t polygons = request.rows(In::polygon_offsets) - 1;
        check_offsets(request, In::facet_offsets, polygons, "facet offsets");
        const std::size_t facets = request.rows(In::facet_offsets) - 1;
        check_columns(request, In::facet_holes, 3, "facet holes");
        if (request.has(In::facet_hole_offsets)) {
            check_rows(request, In::facet_hole_offsets, facets + 1, "facet hole offsets");
            check_offsets(request, In::facet_hole_offsets, request.rows(In::facet_holes),
                          "facet hole offsets");
        }
        std::int32_t *nodes = request.ints(In::polygon_nodes);
        const std::int64_t *ends = request.longs(In::polygon_offsets);
        polygons_.resize(polygons);
        for (std::size_t p = 0; p < polygons; ++p) {
            polygons_[p] = {nodes + ends[p], static_cast<int>(ends[p + 1] - ends[p])};
        }
        const std::int64_t *of = request.longs(In::facet_offsets);
        double *holes = request.doubles(In::facet_holes);
        const std::int64_t *hole_of = request.longs(In::facet_hole_offsets);
        facets_.resize(facets);
        for (std::size_t f = 0; f < facets; ++f) {
            facets_[f] = {polygons_.data() + of[f], static_cast<int>(of[f + 1] - of[f]), nullptr,
                          0};
            if (holes != nullptr && hole_of != nullptr && hole_of[f + 1] > hole_of[f]) {
                facets_[f].holelist = holes + 3 * hole_of[f];
                facets_[f].numberofholes = static_cast<int>(hole_of[f + 1] - hole_of[f]);
            }
        }
        main.numberoffacets = as_int(facets, "facets");
        main.facetlist = facets_.data();
        check_rows(request, In::facet_markers, facets, "facet markers");
        main.facetmarkerlist = request.ints(In::facet_markers);
    }
    check_columns(request, In::facet_constraints, 2, "facet constraints");
    main.facetconstraintlist = request.doubles(In::facet_constraints);
    main.numberoffacetconstraints =
        as_int(request.rows(In::facet_constraints), "facet constraints");
    check_columns(request, In::segment_constraints, 3, "segment constraints");
    main.segmentconstraintlist = request.doubles(In::segment_constraints);
    main.numberofsegmentconstraints =
        as_int(request.rows(In::segment_constraints), "segment constraints");
    check_columns(request, In::edges, 2, "edges");
    check_nodes(request.ints(In::edges), 2 * request.rows(In::edges), n, "edges");
    check_rows(request, In::edge_markers, request.rows(In::edges), "edge markers");
    main.edgelist = request.ints(In::edges);
    main.edgemarkerlist = request.ints(In::edge_markers);
    main.numberofedges = as_int(request.rows(In::edges), "edges");
    check_columns(request, In::holes, 3, "holes");
    check_finite(request.doubles(In::holes), 3 * request.rows(In::holes), "holes");
    main.holelist = request.doubles(In::holes);
    main.numberofholes = as_int(request.rows(In::holes), "holes");
    check_columns(request, In::regions, 5, "regions");
    check_finite(request.doubles(In::regions), 5 * request.rows(In::regions), "regions");
    main.regionlist = request.doubles(In::regions);
    main.numberofregions = as_int(request.rows(In::regions), "regions");
}

void Input::add_tetra(const Request &request) {
    const std::size_t n = request.rows(In::points);
    const std::size_t tetra = request.rows(In::tetra);
    const std::size_t corners = request.columns(In::tetra);
    if (tetra > 0 && corners != 4 && corners != 10) {
        fail("tetra: expected 4 or 10 columns, got " + std::to_string(corners));
    }
    check_nodes(request.ints(In::tetra), tetra * corners, n, "tetra");
    main.tetrahedronlist = request.ints(In::tetra);
    main.numberoftetrahedra = as_int(tetra, "tetra");
    main.numberofcorners = corners == 10 ? 10 : 4;
    check_rows(request, In::tetra_attributes, tetra, "tetra attributes");
    main.tetrahedronattributelist = request.doubles(In::tetra_attributes);
    main.numberoftetrahedronattributes = main.tetrahedronattributelist == nullptr
                                             ? 0
                                             : as_int(request.columns(In::tetra_attributes), "");
    check_rows(request, In::tetra_volumes, tetra, "tetra volumes");
    main.tetrahedronvolumelist = request.doubles(In::tetra_volumes);
    const std::size_t triangles = request.rows(In::triangles);
    check_columns(request, In::triangles, 3, "triangles");
    check_nodes(request.ints(In::triangles), 3 * triangles, n, "triangles");
    check_rows(request, In::triangle_markers, triangles, "triangle markers");
    main.trifacelist = request.ints(In::triangles);
    main.trifacemarkerlist = request.ints(In::triangle_markers);
    main.numberoftrifaces = as_int(triangles, "triangles");
}

void Input::add_others(const Request &request) {
    check_columns(request, In::added_points, 3, "added points");
    check_finite(request.doubles(In::added_points), 3 * request.rows(In::added_points),
                 "added points");
    added.pointlist = request.doubles(In::added_points);
    added.numberofpoints = as_int(request.rows(In::added_points), "added points");
    const std::size_t n = request.rows(In::background_points);
    check_columns(request, In::background_points, 3, "background points");
    check_finite(request.doubles(In::background_points), 3 * n, "background points");
    background.pointlist = request.doubles(In::background_points);
    background.numberofpoints = as_int(n, "background points");
    check_columns(request, In::background_tetra, 4, "background tetra");
    check_nodes(request.ints(In::background_tetra), 4 * request.rows(In::background_tetra), n,
                "background tetra");
    background.tetrahedronlist = request.ints(In::background_tetra);
    background.numberoftetrahedra = as_int(request.rows(In::background_tetra), "background tetra");
    check_rows(request, In::background_sizes, n, "background sizes");
    background.pointmtrlist = request.doubles(In::background_sizes);
    background.numberofpointmtrs =
        background.pointmtrlist == nullptr ? 0 : as_int(request.columns(In::background_sizes), "");
}

} // namespace nmgs::tet
