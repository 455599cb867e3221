// SPDX-License-Identifier: LGPL-2.1-or-later
#include "block_model.h"
#include "core.h"
#include "mesh_arrays.h"

#include "nmgs/convert/hexa_to_tetra.h"
#include "nmgs/convert/mid_sides_on_model.h"
#include "nmgs/convert/quad_to_triangle.h"
#include "nmgs/convert/raise_order.h"
#include "nmgs/convert/tetra_to_hexa.h"
#include "nmgs/convert/triangle_to_quad.h"
#include "nmgs/support/error.h"
#include "nmgs/support/memory.h"

#include <limits>
#include <optional>

namespace nmgs::bindings {
namespace {

// Moves rows of N numbers into an (M, N) array.
template <std::size_t N>
py::array_t<std::int32_t> give_rows(std::vector<std::array<std::int32_t, N>> &&rows) {
    using Rows = std::vector<std::array<std::int32_t, N>>;
    auto owner = std::make_unique<Rows>(std::move(rows));
    const std::vector<py::ssize_t> shape{static_cast<py::ssize_t>(owner->size()),
                                         static_cast<py::ssize_t>(N)};
    auto *data = reinterpret_cast<std::int32_t *>(owner->data());
    const py::capsule capsule(owner.release(), [](void *memory) {
        const std::unique_ptr<Rows> end(static_cast<Rows *>(memory));
    });
    return py::array_t<std::int32_t>(shape, data, capsule);
}

EqualDiagonals rule_of(bool lowest_node) {
    return lowest_node ? EqualDiagonals::lowest_node : EqualDiagonals::second_and_fourth;
}

py::array_t<std::int32_t> quads_to_triangles(const DoubleArray &points, const IntArray &quads,
                                             bool lowest_node, const py::object &progress) {
    const auto p = points_of(points);
    const auto q = cells_of(quads, 4, "quads");
    Array<std::int32_t> triangles;
    {
        const Progress listener = progress_of(progress);
        const py::gil_scoped_release release;
        const CellView view{CellType::quad, q};
        check_nodes({&view, 1}, p.size());
        triangles = Array<std::int32_t>(q.size() / 4 * 6);
        split_quads(p, q, rule_of(lowest_node), {triangles.data(), triangles.size()}, listener);
    }
    return give_cells(std::move(triangles), 3);
}

py::array_t<std::uint8_t> parameters(const DoubleArray &points, const IntArray &quads,
                                     bool lowest_node) {
    const auto p = points_of(points);
    const auto q = cells_of(quads, 4, "quads");
    Array<std::uint8_t> values;
    {
        const py::gil_scoped_release release;
        const CellView view{CellType::quad, q};
        check_nodes({&view, 1}, p.size());
        values = Array<std::uint8_t>(q.size() / 4);
        triangulation_parameters(p, q, rule_of(lowest_node), {values.data(), values.size()});
    }
    const auto count = static_cast<py::ssize_t>(values.size());
    return give<std::uint8_t>(std::move(values), {count});
}

py::tuple hexahedra_to_tetrahedra(const DoubleArray &points, const IntArray &hexahedra,
                                  const py::object &progress) {
    const auto p = points_of(points);
    const auto h = cells_of(hexahedra, 8, "hexahedra");
    const std::size_t count = h.size() / 8;
    Array<Vec3> all;
    Array<std::int32_t> tetrahedra;
    std::vector<FlippedFace> flipped;
    {
        const Progress listener = progress_of(progress);
        const py::gil_scoped_release release;
        const CellView view{CellType::hexahedron, h};
        check_nodes({&view, 1}, p.size());
        if (p.size() + count > std::numeric_limits<std::int32_t>::max()) {
            throw ArgumentError("hexahedra: the mesh would have " +
                                std::to_string(p.size() + count) +
                                " nodes; node numbers end at 2147483647");
        }
        require_memory(static_cast<std::int64_t>(192 * count + 24 * (p.size() + count)),
                       "the tetrahedra");
        all = Array<Vec3>(p.size() + count);
        std::copy(p.begin(), p.end(), all.begin());
        tetrahedra = Array<std::int32_t>(48 * count);
        flipped = split_hexahedra(p, h, static_cast<std::int32_t>(p.size()),
                                  {tetrahedra.data(), tetrahedra.size()},
                                  {all.data() + p.size(), count}, listener);
    }
    return py::make_tuple(give_points(std::move(all)), give_cells(std::move(tetrahedra), 4),
                          give_rows(std::move(flipped)));
}

// model: None or (nodes, divisions, spacing).
py::dict quadratic(const DoubleArray &points, const py::dict &cells, const py::object &model,
                   const py::object &progress) {
    const auto p = points_of(points);
    const CellArrays input = cell_arrays_of(cells);
    std::optional<BlockModel> blocks;
    if (!model.is_none()) {
        const auto parts = model.cast<py::tuple>();
        blocks = block_model_of(parts[0].cast<DoubleArray>(), parts[1].cast<IntArray>(), parts[2]);
    }
    QuadraticMesh mesh;
    {
        const Progress listener = progress_of(progress);
        const py::gil_scoped_release release;
        PlaceOnEdge place;
        if (blocks) {
            place = mid_sides_on_model(*blocks, p, input.views).value_or(PlaceOnEdge());
        }
        mesh = raise_order(p, input.views, place, listener);
    }
    py::dict result;
    result["points"] = give_points(std::move(mesh.points));
    result["cells"] = give_blocks(std::move(mesh.cells));
    result["ends"] = give_rows(std::move(mesh.ends));
    return result;
}

py::tuple pairs(const DoubleArray &points, const IntArray &triangles, const IntArray &labels,
                const py::object &progress) {
    const auto p = points_of(points);
    const auto t = cells_of(triangles, 3, "triangles");
    if (labels.size() != 0 && labels.size() != triangles.shape(0)) {
        throw py::value_error("labels: expected one for each of " +
                              std::to_string(triangles.shape(0)) + " triangles, got " +
                              std::to_string(labels.size()));
    }
    const std::span<const std::int32_t> l{labels.data(), static_cast<std::size_t>(labels.size())};
    PairedTriangles result;
    {
        const Progress listener = progress_of(progress);
        const py::gil_scoped_release release;
        result = pair_triangles(p, t, l, listener);
    }
    const auto left = static_cast<py::ssize_t>(result.left.size());
    return py::make_tuple(give_rows(std::move(result.quads)), give_rows(std::move(result.parents)),
                          give(std::move(result.left), {left}));
}

py::array_t<std::int32_t> corner_quads(const IntArray &cells, std::int32_t first_centre) {
    const int corners = cells.ndim() == 2 && cells.shape(1) == 6 ? 3 : 4;
    const auto c = cells_of(cells, 2 * corners, "cells");
    Array<std::int32_t> quads;
    {
        const py::gil_scoped_release release;
        quads = Array<std::int32_t>(2 * c.size());
        split_at_corners(corners, c, first_centre, {quads.data(), quads.size()});
    }
    return give_cells(std::move(quads), 4);
}

py::tuple tetrahedra_to_hexahedra(std::int32_t first_face, const IntArray &tetrahedra,
                                  const IntArray &triangles, const py::object &progress) {
    const auto t = cells_of(tetrahedra, 10, "tetrahedra");
    const auto f = cells_of(triangles, 3, "triangles");
    HexahedraOfTetrahedra result;
    {
        const Progress listener = progress_of(progress);
        const py::gil_scoped_release release;
        result = split_tetrahedra(first_face, t, f, listener);
    }
    const auto count = static_cast<py::ssize_t>(result.face_of_triangle.size());
    return py::make_tuple(give_cells(std::move(result.hexahedra), 8),
                          give_rows(std::move(result.face_corners)),
                          give(std::move(result.face_of_triangle), {count}));
}

} // namespace

void bind_convert(py::module_ &module) {
    module.def("quads_to_triangles", &quads_to_triangles, py::arg("points"), py::arg("quads"),
               py::arg("lowest_node"), py::arg("progress") = py::none(),
               "(2 M, 3) triangles by the shorter diagonal. lowest_node: of equal diagonals the "
               "one at the lowest node, as faces of hexahedra do; else nodes 2 and 4.");
    module.def("triangulation_parameters", &parameters, py::arg("points"), py::arg("quads"),
               py::arg("lowest_node") = false,
               "uint8 (M,): 1 where nodes 2 and 4 are joined, 0 where 1 and 3 are.");
    module.def(
        "hexahedra_to_tetrahedra", &hexahedra_to_tetrahedra, py::arg("points"),
        py::arg("hexahedra"), py::arg("progress") = py::none(),
        "(points with one centroid a hexahedron behind them, (12 M, 4) tetrahedra, corners (F, 4) "
        "of faces that had to be split by the longer diagonal).");
    module.def("pair_triangles", &pairs, py::arg("points"), py::arg("triangles"), py::arg("labels"),
               py::arg("progress") = py::none(),
               "(quads (P, 4), their triangles (P, 2), triangles without a partner); labels: int32 "
               "(M,) that partners must share, or empty.");
    module.def("corner_quads", &corner_quads, py::arg("cells"), py::arg("first_centre"),
               "Quads at the corners of triangle6 or quad8 cells, round their centres.");
    module.def("tetrahedra_to_hexahedra", &tetrahedra_to_hexahedra, py::arg("first_face"),
               py::arg("tetrahedra"), py::arg("triangles"), py::arg("progress") = py::none(),
               "(hexahedra (4 M, 8), corners of the face nodes (F, 3), face of each triangle).");
    module.def("raise_order", &quadratic, py::arg("points"), py::arg("cells"),
               py::arg("model") = py::none(), py::arg("progress") = py::none(),
               "{'points', 'cells', 'ends'}: quadratic cells; ends (E, 2) of each new node. model: "
               "(nodes, divisions, spacing) of the blocks on whose mapping the new nodes lie.");
}

} // namespace nmgs::bindings
