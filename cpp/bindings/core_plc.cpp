// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core.h"
#include "plc.h"

#include "nmgs/formats/gid.h"
#include "nmgs/formats/medit.h"
#include "nmgs/formats/off.h"
#include "nmgs/formats/stl.h"
#include "nmgs/formats/tetgen_cells.h"
#include "nmgs/formats/tetgen_node.h"
#include "nmgs/formats/tetgen_poly.h"
#include "nmgs/plc/check.h"
#include "nmgs/plc/mend.h"

#include <pybind11/stl.h>

#include <algorithm>

namespace nmgs::bindings {
namespace {

template <class Call>
auto without_gil(const Call &call) {
    const py::gil_scoped_release release;
    return call();
}

py::tuple node_file(const std::string &path) {
    std::int32_t first = 0;
    Plc plc = without_gil([&] { return read_node(path, &first); });
    return py::make_tuple(give_plc(std::move(plc)), first);
}

TetgenList list_of(const std::string &name) {
    if (name == "ele") {
        return TetgenList::ele;
    }
    if (name == "face") {
        return TetgenList::face;
    }
    if (name == "edge") {
        return TetgenList::edge;
    }
    if (name == "neigh") {
        return TetgenList::neigh;
    }
    throw py::value_error("list: no such list '" + name + "'");
}

py::dict cell_file(const std::string &path, const std::string &list, std::int32_t first,
                   std::int64_t nodes) {
    const TetgenList kind = list_of(list);
    TetgenCells cells = without_gil([&] { return read_cells(path, kind, first, nodes); });
    const auto rows = static_cast<py::ssize_t>(cells.size());
    py::dict result;
    result["nodes"] = give(std::move(cells.nodes), {rows, cells.columns});
    if (cells.attribute_count > 0) {
        result["attributes"] = give(std::move(cells.attributes), {rows, cells.attribute_count});
    }
    if (!cells.markers.empty()) {
        result["markers"] = give(std::move(cells.markers), {rows});
    }
    return result;
}

void save_cells(const std::string &path, const std::string &list, const IntArray &nodes,
                const py::object &attributes, const py::object &markers, std::int32_t first) {
    TetgenCells cells;
    if (nodes.ndim() != 2) {
        throw py::value_error("nodes: expected shape (M, k), got " + shape_text(nodes));
    }
    cells.columns = static_cast<int>(nodes.shape(1));
    cells.nodes.assign(nodes.data(), nodes.data() + nodes.size());
    if (!attributes.is_none()) {
        const auto values = attributes.cast<DoubleArray>();
        if (values.ndim() != 2 || values.shape(0) != nodes.shape(0)) {
            throw py::value_error("attributes: wrong shape " + shape_text(values));
        }
        cells.attribute_count = static_cast<int>(values.shape(1));
        cells.attributes.assign(values.data(), values.data() + values.size());
    }
    if (!markers.is_none()) {
        const auto values = markers.cast<IntArray>();
        if (values.size() != nodes.shape(0)) {
            throw py::value_error("markers: wrong shape " + shape_text(values));
        }
        cells.markers.assign(values.data(), values.data() + values.size());
    }
    const TetgenList kind = list_of(list);
    const py::gil_scoped_release release;
    write_cells(path, kind, cells, first);
}

py::tuple gid_file(const std::string &path) {
    GidMesh mesh = without_gil([&] { return read_gid(path); });
    Array<Vec3> points(mesh.points.size());
    std::copy(mesh.points.begin(), mesh.points.end(), points.begin());
    const auto rows = static_cast<py::ssize_t>(mesh.nodes.size()) / mesh.columns;
    return py::make_tuple(give_points(std::move(points)),
                          give(std::move(mesh.nodes), {rows, mesh.columns}));
}

void save_gid(const std::string &path, const DoubleArray &points, const IntArray &nodes) {
    GidMesh mesh;
    const auto view = points_of(points);
    mesh.points.assign(view.begin(), view.end());
    if (nodes.ndim() != 2) {
        throw py::value_error("nodes: expected shape (M, k), got " + shape_text(nodes));
    }
    mesh.columns = static_cast<int>(nodes.shape(1));
    mesh.nodes.assign(nodes.data(), nodes.data() + nodes.size());
    const py::gil_scoped_release release;
    write_gid(path, mesh);
}

// (points, [(cell name, nodes (M, k), references (M))]).
py::tuple medit_file(const std::string &path) {
    MeditMesh mesh = without_gil([&] { return read_medit(path); });
    Array<Vec3> points(mesh.points.size());
    std::copy(mesh.points.begin(), mesh.points.end(), points.begin());
    py::list blocks;
    for (MeditCells &cells : mesh.cells) {
        const auto rows = static_cast<py::ssize_t>(cells.references.size());
        blocks.append(py::make_tuple(std::string(name(cells.type)),
                                     give(std::move(cells.nodes), {rows, node_count(cells.type)}),
                                     give(std::move(cells.references), {rows})));
    }
    return py::make_tuple(give_points(std::move(points)), blocks);
}

CheckOptions options_of(const py::object &tolerance, double planarity, std::size_t limit,
                        bool equal_points) {
    return {tolerance.is_none() ? -1.0 : tolerance.cast<double>(), planarity, limit, equal_points};
}

py::list problems_of(const py::object &source, const py::object &tolerance, double planarity,
                     std::size_t limit, bool equal_points, const py::object &progress) {
    const Plc plc = plc_of(source);
    const CheckOptions options = options_of(tolerance, planarity, limit, equal_points);
    const Progress listener = progress_of(progress);
    const auto problems = without_gil([&] { return check(plc, options, listener); });
    py::list list;
    for (const PlcProblem &problem : problems) {
        const Vec3 p = problem.place;
        list.append(py::make_tuple(std::string(name(problem.fault)), problem.facets, problem.points,
                                   py::make_tuple(p.x, p.y, p.z), problem.amount));
    }
    return list;
}

py::tuple mended_of(const py::object &source, const py::object &tolerance,
                    const py::object &progress) {
    const Plc plc = plc_of(source);
    const CheckOptions options = options_of(tolerance, 1e-6, 1000, false);
    const Progress listener = progress_of(progress);
    Mended mended = without_gil([&] { return mend(plc, options, listener); });
    return py::make_tuple(give_plc(std::move(mended.plc)), mended.facet_of, mended.done);
}

} // namespace

void bind_plc(py::module_ &module) {
    const auto path = py::arg("path");
    const auto source = py::arg("plc");
    module.def("read_node", &node_file, path, "(arrays of a PLC without facets, first number).");
    module.def(
        "write_node",
        [](const std::string &name, const py::object &plc, std::int32_t first) {
            write_node(name, plc_of(plc), first);
        },
        path, source, py::arg("first") = 1, "TetGen's .node.");
    for (const auto kind : {PolyKind::poly, PolyKind::smesh}) {
        const std::string name = kind == PolyKind::poly ? "poly" : "smesh";
        module.def(("read_" + name).c_str(),
                   [kind](const std::string &file) {
                       return give_plc(without_gil([&] { return read_poly(file, kind); }));
                   },
                   path, "Arrays of the PLC in a file of TetGen's.");
        module.def(("write_" + name).c_str(),
                   [kind](const std::string &file, const py::object &plc, std::int32_t first) {
                       write_poly(file, plc_of(plc), kind, first);
                   },
                   path, source, py::arg("first") = 1, "A PLC as TetGen's file.");
    }
    module.def(
        "read_off",
        [](const std::string &file) {
            return give_plc(without_gil([&] { return read_off(file); }));
        },
        path, "Arrays of the PLC of an OFF file's polygons.");
    module.def(
        "write_off",
        [](const std::string &file, const py::object &plc) { write_off(file, plc_of(plc)); }, path,
        source, "A PLC of plain polygons as OFF.");
    module.def(
        "read_stl",
        [](const std::string &file) {
            return give_plc(without_gil([&] { return read_stl(file); }));
        },
        path, "Arrays of the PLC of an STL file's triangles, each with points of its own.");
    module.def(
        "write_stl",
        [](const std::string &file, const py::object &plc, bool binary) {
            write_stl(file, plc_of(plc), binary);
        },
        path, source, py::arg("binary") = true, "A PLC of triangles as STL.");
    module.def("read_cells", &cell_file, path, py::arg("list"), py::arg("first"), py::arg("nodes"),
               "Rows of an .ele, .face, .edge or .neigh: {'nodes', 'attributes', 'markers'}.");
    module.def("write_cells", &save_cells, path, py::arg("list"), py::arg("nodes"),
               py::arg("attributes") = py::none(), py::arg("markers") = py::none(),
               py::arg("first") = 1, "Rows of an .ele, .face, .edge or .neigh.");
    module.def("read_medit", &medit_file, path,
               "(points (N, 3), [(cell name, nodes (M, k), references (M))]) of a .mesh file.");
    module.def("check_plc", &problems_of, source, py::arg("tolerance") = py::none(),
               py::arg("planarity") = 1e-6, py::arg("limit") = 1000,
               py::arg("equal_points") = false, py::arg("progress") = py::none(),
               "Problems of a PLC: [(fault, facets, points, place, amount)].");
    module.def("mend_plc", &mended_of, source, py::arg("tolerance") = py::none(),
               py::arg("progress") = py::none(),
               "(arrays of the mended PLC, old facet of each new one, what was done).");
    module.def("read_gid", &gid_file, path, "(points (N, 3), nodes (M, k)) of a GiD file.");
    module.def("write_gid", &save_gid, path, py::arg("points"), py::arg("nodes"),
               "Triangles or tetrahedra as GiD file.");
}

} // namespace nmgs::bindings
