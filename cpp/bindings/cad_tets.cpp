// SPDX-License-Identifier: LGPL-2.1-or-later
#include "cad_tets.h"

#include "arrays.h"
#include "cad_fit.h"

#include "nmgs_cad/cad_tets.h"
#include "nmgs_cad/inner_edges.h"
#include "nmgs_cad/layout.h"
#include "nmgs_cad/refine.h"
#include "nmgs_cad/skin.h"
#include "nmgs_cad/solid_boundary.h"
#include "nmgs_cad/tets_to_hexas.h"

#include <pybind11/stl.h>

#include <cmath>
#include <memory>

namespace nmgs::bindings {
namespace {

// (N, 5) x, y, z, radius, size.
std::vector<cad::SkinOptions::Limit> limits_of(const DoubleArray &rows) {
    if (rows.size() % 5 != 0) {
        throw py::value_error("limits: expected shape (N, 5), got " + shape_text(rows));
    }
    std::vector<cad::SkinOptions::Limit> limits;
    for (py::ssize_t i = 0; i < rows.size(); i += 5) {
        const double *row = rows.data() + i;
        limits.push_back({{row[0], row[1], row[2]}, row[3], row[4]});
    }
    return limits;
}

std::unique_ptr<cad::SkinBuilder> skin_builder(const cad::CadShape &shape,
                                               const std::vector<int> &faces, double size,
                                               double angle, double stretch,
                                               const py::object &progress) {
    cad::SkinOptions options;
    options.stretch = stretch;
    options.size = size;
    options.angle = angle;
    const Progress listener = progress_of(progress);
    const py::gil_scoped_release release;
    return std::make_unique<cad::SkinBuilder>(shape, faces, options, listener);
}

std::shared_ptr<cad::Skin> make_skin(const cad::CadShape &shape, const std::vector<int> &faces,
                                     double size, double angle, const DoubleArray &limits,
                                     const py::object &progress) {
    cad::SkinOptions options;
    options.size = size;
    options.angle = angle;
    options.limits = limits_of(limits);
    const Progress listener = progress_of(progress);
    const py::gil_scoped_release release;
    return std::make_shared<cad::Skin>(cad::make_skin(shape, faces, options, listener));
}

void refine_skin(cad::SkinBuilder &builder, const DoubleArray &limits, const py::object &progress) {
    const auto rows = limits_of(limits);
    const Progress listener = progress_of(progress);
    const py::gil_scoped_release release;
    builder.refine(rows, listener);
}

// solids: (n of SolidN, inner points (K, 3), tetrahedra (M, 4)) each.
py::tuple tets_to_hexas(const cad::CadShape &shape, const cad::Skin &skin, const py::list &solids,
                        cad::Layout &layout, const py::object &progress, bool split) {
    std::vector<cad::SolidTets> all;
    for (const auto &item : solids) {
        const auto entry = item.cast<std::tuple<int, DoubleArray, IntArray>>();
        cad::SolidTets tets{std::get<0>(entry), {}, {}};
        const auto inner = points_of(std::get<1>(entry), "inner");
        tets.inner.assign(inner.begin(), inner.end());
        const auto cells = cells_of(std::get<2>(entry), 4, "tets");
        const auto limit = static_cast<std::int32_t>(skin.points.size() + inner.size());
        for (std::size_t c = 0; c < cells.size(); c += 4) {
            std::array<std::int32_t, 4> t{};
            for (std::size_t i = 0; i < 4; ++i) {
                t[i] = cells[c + i];
                if (t[i] < 0 || t[i] >= limit) {
                    throw py::value_error("tets: row " + std::to_string(c / 4) + " has point " +
                                          std::to_string(t[i]) + ", but there are " +
                                          std::to_string(limit));
                }
            }
            tets.tets.push_back(t);
        }
        all.push_back(std::move(tets));
    }
    cad::TetHexas result;
    {
        const Progress listener = progress_of(progress);
        const py::gil_scoped_release release;
        result = cad::tets_to_hexas(shape, skin, all, layout, listener, split);
    }
    std::vector<double> limits;
    for (const auto &f : result.folded) {
        limits.insert(limits.end(), {f.place.x, f.place.y, f.place.z, f.radius, f.size});
    }
    const auto rows = static_cast<py::ssize_t>(result.folded.size());
    return py::make_tuple(result.worst, result.inside, give<double>(std::move(limits), {rows, 5}),
                          result.off_cad);
}

// The errors of the report from about two thousand blocks.
void measure_some(const cad::CadShape &shape, cad::CadBlocks &blocks, const Progress &progress) {
    const auto step = static_cast<std::int32_t>(blocks.model.size() / 2000 + 1);
    for (cad::FitEntry &entry : blocks.report) {
        const std::int32_t last = entry.first_block + entry.blocks;
        for (std::int32_t b = entry.first_block; b < last; b += step) {
            poll(progress, 1.0);
            const cad::FitError error = cad::measure(shape, blocks, b, b + 1);
            if (error.distance > entry.error) {
                entry.error = error.distance;
                entry.place = error.place;
            }
        }
    }
}

// What fit() returns, of the hexahedra that tets_to_hexas wrote.
py::dict tet_blocks(const cad::CadShape &shape, const cad::Layout &layout,
                    const std::vector<int> &solids, double tolerance, const py::object &progress) {
    cad::CadBlocks blocks;
    {
        const Progress listener = progress_of(progress);
        const py::gil_scoped_release release;
        blocks = cad::blocks_of(shape, layout, 3);
        for (const int solid : solids) {
            cad::FitEntry entry;
            entry.entity = {3, solid};
            entry.method = "tet-to-hex";
            for (std::size_t h = 0; h < layout.hexas.size(); ++h) {
                if (layout.hexas[h].solid == solid) {
                    entry.first_block =
                        entry.blocks == 0 ? static_cast<std::int32_t>(h) : entry.first_block;
                    ++entry.blocks;
                }
            }
            blocks.report.push_back(std::move(entry));
        }
        // The skin's sizes follow the curvature, so that many blocks are near enough as they are.
        if (std::isfinite(tolerance)) {
            constexpr int rounds = 2;
            blocks =
                cad::refine_to_tolerance(shape, std::move(blocks), tolerance, rounds, listener);
        } else {
            measure_some(shape, blocks, listener);
        }
    }
    return fit_dict(std::move(blocks));
}

// (N, 3) places of the vertices inside a solid.
py::array_t<double> inner_points(const cad::CadShape &shape, int solid) {
    return table<double>(cad::inner_vertex_places(shape, solid));
}

} // namespace

void bind_tets(py::module_ &module) {
    py::class_<cad::Skin, std::shared_ptr<cad::Skin>>(
        module, "Skin", "Well-shaped triangles over CAD faces, points tagged with their entity.")
        .def_property_readonly("points", [](const cad::Skin &s) { return table<double>(s.points); })
        .def_property_readonly("on", [](const cad::Skin &s) { return table<std::int32_t>(s.on); })
        .def_property_readonly("triangles",
                               [](const cad::Skin &s) { return table<std::int32_t>(s.triangles); })
        .def_property_readonly(
            "faces", [](const cad::Skin &s) { return table<std::int32_t>(s.faces).reshape({-1}); })
        .def_property_readonly("edges", [](const cad::Skin &s) { return s.edges; });
    py::class_<cad::SkinBuilder>(module, "SkinBuilder", "Makes skins, each finer than the last.")
        .def(py::init(&skin_builder), py::arg("shape"), py::arg("faces"), py::arg("size") = 0.0,
             py::arg("angle") = 0.45, py::arg("stretch") = 2.5, py::arg("progress") = py::none(),
             py::keep_alive<1, 2>())
        .def("refine", &refine_skin, py::arg("limits"), py::arg("progress") = py::none(),
             "limits: (N, 5) x, y, z, radius, and the longest edge there.")
        .def("skin", [](const cad::SkinBuilder &builder) {
            const py::gil_scoped_release release;
            return std::make_shared<cad::Skin>(builder.skin());
        });
    module.def("make_skin", &make_skin, py::arg("shape"), py::arg("faces"), py::arg("size") = 0.0,
               py::arg("angle") = 0.45, py::arg("limits") = DoubleArray(),
               py::arg("progress") = py::none(), "Coarse triangles over faces that meet at edges.");
    py::class_<cad::Layout, std::shared_ptr<cad::Layout>>(
        module, "Layout", "A coarse conforming mesh over CAD that strategies write into.")
        .def(py::init<const cad::CadShape &>(), py::arg("shape"));
    module.def("solid_faces", &cad::solid_faces, py::arg("shape"), py::arg("solid"),
               "(n of FaceN, whether it bounds the solid) of each face of a solid.");
    module.def("inner_edges", &cad::inner_edges, py::arg("shape"), py::arg("solid"),
               "n of each EdgeN inside a solid, on none of its faces.");
    module.def("inner_points", &inner_points, py::arg("shape"), py::arg("solid"),
               "Places of the vertices inside a solid, on none of its faces.");
    module.def("tet_blocks", &tet_blocks, py::arg("shape"), py::arg("layout"), py::arg("solids"),
               py::arg("tolerance"), py::arg("progress") = py::none(),
               "Blocks of the hexahedra in a layout, as fit() gives them, halved where the "
               "tolerance is finite.");
    module.def("tets_to_hexas", &tets_to_hexas, py::arg("shape"), py::arg("skin"),
               py::arg("solids"), py::arg("layout"), py::arg("progress") = py::none(),
               py::arg("split") = false,
               "Adds four hexahedra a tetrahedron; split: those are split before that would fold. "
               "(worst scaled Jacobian, also of their inside, where it folds, points off the CAD)");
}

} // namespace nmgs::bindings
