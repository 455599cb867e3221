// SPDX-License-Identifier: LGPL-2.1-or-later
#include "arrays.h"
#include "block_model.h"
#include "cad_cuts.h"
#include "cad_fit.h"
#include "cad_refit.h"
#include "cad_tessellate.h"
#include "cad_tets.h"
#include "errors.h"
#include "mesh.h"

#include "nmgs_cad/face_layout.h"
#include "nmgs_cad/generate_on_cad.h"
#include "nmgs_cad/occt_failure.h"
#include "nmgs_cad/refine.h"
#include "nmgs_cad/solid_groups.h"
#include "nmgs_cad/solid_layout.h"
#include "nmgs_cad/split_tips.h"
#include "nmgs_cad/version.h"

#include <pybind11/stl.h>

#include <map>
#include <memory>
#include <numbers>
#include <set>

namespace nmgs::bindings {
namespace {

using cad::CadBlocks;
using cad::CadShape;

std::shared_ptr<CadShape> read_brep(const py::bytes &bytes) {
    return std::make_shared<CadShape>(cad::read_brep(std::string_view(bytes)));
}

// {nodes, corners, offsets, entities, report} of faces (dimension 2) or solids (3). counts:
// segments of edges (n of EdgeN) that a layout of faces keeps to.
py::dict fit(const CadShape &shape, int dimension, const std::vector<int> &indices,
             double tolerance, const std::string &method, const py::object &progress,
             double share_of_size, const std::map<int, int> &counts) {
    CadBlocks blocks;
    blocks.model.dimension = dimension;
    std::set<int> counted;
    {
        const Progress listener = progress_of(progress);
        const py::gil_scoped_release release;
        if (dimension == 2) {
            cad::Layout layout(shape);
            cad::LayoutOptions options;
            options.angle = std::numbers::pi / 4;
            for (const auto &[edge, count] : counts) {
                cad::divide_evenly(shape, edge, count, layout);
                counted.insert(edge);
            }
            std::vector<cad::FitEntry> report;
            cad::layout_faces(shape, indices, layout, options, report, listener, method);
            blocks = cad::blocks_of(shape, layout, 2);
            blocks.report = std::move(report);
        } else {
            cad::Layout layout(shape);
            cad::SolidLayoutOptions options;
            options.method = method;
            auto report = cad::layout_solids(shape, indices, layout, options, listener);
            blocks = cad::blocks_of(shape, layout, 3);
            blocks.report = std::move(report);
        }
        constexpr int rounds = 6;
        constexpr std::size_t most_blocks = 4096;
        blocks = cad::refine_to_tolerance(shape, std::move(blocks), tolerance, rounds, listener,
                                          most_blocks, share_of_size, counted);
        // Elements are as long as this where no size is given.
        blocks = cad::split_tips(shape, std::move(blocks), shape.diagonal() / 30, listener);
    }
    return fit_dict(std::move(blocks));
}

py::dict generate_mesh(const CadShape &shape, const DoubleArray &nodes, const IntArray &divisions,
                       const py::object &spacing, const IntArray &offsets, const IntArray &entities,
                       int order, double tolerance, bool force, const py::object &progress,
                       const std::optional<IntArray> &corners) {
    CadBlocks blocks;
    blocks.model = block_model_of(nodes, divisions, spacing, corners);
    blocks.binding.offsets.assign(offsets.data(), offsets.data() + offsets.size());
    const auto view = entities.unchecked<2>();
    for (py::ssize_t e = 0; e < view.shape(0); ++e) {
        blocks.binding.entities.push_back({view(e, 0), view(e, 1)});
    }
    Mesh mesh;
    std::vector<std::int32_t> off_cad;
    {
        const Progress listener = progress_of(progress);
        const py::gil_scoped_release release;
        mesh = cad::generate_on_cad(shape, blocks, order, {tolerance, force}, listener, &off_cad);
    }
    py::dict result = give_mesh(std::move(mesh));
    const auto count = static_cast<py::ssize_t>(off_cad.size());
    result["off_cad"] = give<std::int32_t>(std::move(off_cad), {count});
    return result;
}

// What OpenCASCADE throws where nobody looked for it; its failures are no std::exception.
void register_failures() {
    // NOLINTNEXTLINE(performance-unnecessary-value-param): pybind11's signature.
    py::register_local_exception_translator([](std::exception_ptr pointer) {
        if (!pointer) {
            return;
        }
        const auto text = cad::occt_failure(pointer);
        if (!text) {
            std::rethrow_exception(pointer);
        }
        const py::object error = py::module_::import("freecad.NMGSWorkbench.nmgs.errors")
                                     .attr("GeometryError")("OpenCASCADE failed: " + *text);
        PyErr_SetObject(py::type::of(error).ptr(), error.ptr());
    });
}

} // namespace
} // namespace nmgs::bindings

PYBIND11_MODULE(cad, module) {
    using namespace nmgs::bindings;
    module.doc() = "Kernel of the NMGS Workbench with OpenCASCADE.";
    register_errors();
    register_failures();
    module.attr("occt_version") = nmgs::cad::occt_version();
    py::class_<nmgs::cad::CadShape, std::shared_ptr<nmgs::cad::CadShape>>(
        module, "CadShape", "A shape whose FaceN, EdgeN, VertexN are FreeCAD's.")
        .def(py::init(&read_brep), py::arg("brep"), "From the bytes of a BREP of OpenCASCADE.")
        .def_property_readonly("solids",
                               [](const nmgs::cad::CadShape &s) { return s.solids.Extent(); })
        .def_property_readonly("faces",
                               [](const nmgs::cad::CadShape &s) { return s.faces.Extent(); })
        .def_property_readonly("edges",
                               [](const nmgs::cad::CadShape &s) { return s.edges.Extent(); })
        .def_property_readonly("vertices",
                               [](const nmgs::cad::CadShape &s) { return s.vertices.Extent(); })
        .def_property_readonly("diagonal", &nmgs::cad::CadShape::diagonal);
    module.def("fit", &fit, py::arg("shape"), py::arg("dimension"), py::arg("indices"),
               py::arg("tolerance"), py::arg("method"), py::arg("progress") = py::none(),
               py::arg("share_of_size") = 0.0, py::arg("counts") = std::map<int, int>());
    module.def(
        "joined_solids",
        [](const nmgs::cad::CadShape &shape, const std::vector<int> &solids) {
            return nmgs::cad::joined_solids(shape, solids);
        },
        py::arg("shape"), py::arg("solids"), "Groups of solids (n of SolidN) that touch.");
    module.def("solid_strategies", [] {
        std::vector<std::string> names;
        for (const auto &strategy : nmgs::cad::solid_strategies()) {
            names.emplace_back(strategy.name);
        }
        return names;
    });
    module.def("generate", &generate_mesh, py::arg("shape"), py::arg("nodes"), py::arg("divisions"),
               py::arg("spacing"), py::arg("offsets"), py::arg("entities"), py::arg("order") = 1,
               py::arg("tolerance") = -1.0, py::arg("force") = false,
               py::arg("progress") = py::none(), py::arg("corners") = py::none());
    bind_cuts(module);
    bind_refit(module);
    bind_tessellate(module);
    bind_tets(module);
}
