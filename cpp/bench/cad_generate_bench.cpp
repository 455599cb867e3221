// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs_cad/face_layout.h"
#include "nmgs_cad/generate_on_cad.h"
#include "nmgs_cad/layout.h"
#include "nmgs_cad/refine.h"

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRep_Tool.hxx>
#include <GeomAPI_PointsToBSplineSurface.hxx>
#include <Geom_BSplineSurface.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <TopExp.hxx>

#include <benchmark/benchmark.h>

#include <cmath>
#include <numbers>
#include <numeric>

namespace {

using namespace nmgs;

// A bumpy sheet of 12 x 12 spans and n x n quads over it.
cad::CadShape sheet() {
    constexpr int count = 15;
    TColgp_Array2OfPnt points(1, count, 1, count);
    for (int i = 1; i <= count; ++i) {
        for (int j = 1; j <= count; ++j) {
            points.SetValue(i, j, gp_Pnt(i, j, std::sin(0.8 * i) * std::cos(0.6 * j)));
        }
    }
    return cad::make_shape(
        BRepBuilderAPI_MakeFace(GeomAPI_PointsToBSplineSurface(points).Surface(), 1e-7).Face());
}

cad::CadBlocks over_sheet(const cad::CadShape &shape, int n) {
    cad::Layout layout(shape);
    const Handle(Geom_Surface) surface = BRep_Tool::Surface(shape.face(1));
    double u0 = 0;
    double u1 = 0;
    double v0 = 0;
    double v1 = 0;
    surface->Bounds(u0, u1, v0, v1);
    const auto at = [&](int i, int j) { return i + (n + 1) * j; };
    for (int j = 0; j <= n; ++j) {
        for (int i = 0; i <= n; ++i) {
            const gp_Pnt p = surface->Value(u0 + (u1 - u0) * i / n, v0 + (v1 - v0) * j / n);
            layout.add_point({p.X(), p.Y(), p.Z()}, {2, 1});
        }
    }
    for (int j = 0; j < n; ++j) {
        for (int i = 0; i < n; ++i) {
            layout.quads.push_back({{at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)}, 1});
        }
    }
    return cad::blocks_of(shape, layout, 2);
}

// A million nodes on a B-spline face, of patches with range(0) x range(0) divisions.
void generate_on_spline(benchmark::State &state) {
    const auto divisions = static_cast<std::int32_t>(state.range(0));
    const cad::CadShape shape = sheet();
    cad::CadBlocks blocks = over_sheet(shape, 1000 / divisions);
    for (auto &g : blocks.model.divisions) {
        g = {divisions, divisions, 0};
    }
    for (auto _ : state) {
        benchmark::DoNotOptimize(cad::generate_on_cad(shape, blocks, 1));
    }
}
BENCHMARK(generate_on_spline)
    ->Arg(250)
    ->Arg(50)
    ->Arg(10)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

// A plate with 44 holes, on 50 faces: intervals, quads of all faces, the patches' middles.
void lay_out_skin(benchmark::State &state) {
    TopoDS_Shape plate = BRepPrimAPI_MakeBox(120.0, 50.0, 8.0).Shape();
    for (int n = 0; n < 44; ++n) {
        const gp_Ax2 axis(gp_Pnt(10 + 10 * (n % 11), 8 + 11.0 * (n / 11), -1), gp_Dir(0, 0, 1));
        plate =
            BRepAlgoAPI_Cut(plate, BRepPrimAPI_MakeCylinder(axis, 1.5 + 0.1 * (n % 5), 10).Shape())
                .Shape();
    }
    for (auto _ : state) {
        const cad::CadShape shape = cad::make_shape(plate);
        std::vector<int> faces(static_cast<std::size_t>(shape.faces.Extent()));
        std::iota(faces.begin(), faces.end(), 1);
        cad::Layout layout(shape);
        cad::LayoutOptions options;
        options.angle = std::numbers::pi / 4;
        std::vector<cad::FitEntry> report;
        cad::layout_faces(shape, faces, layout, options, report);
        benchmark::DoNotOptimize(cad::blocks_of(shape, layout, 2));
    }
    state.counters["faces"] = cad::make_shape(plate).faces.Extent();
}
BENCHMARK(lay_out_skin)->Unit(benchmark::kMillisecond)->UseRealTime();

// Blocks of one division in a box, as many as of a tetrahedral mesh that was split.
void many_blocks(benchmark::State &state) {
    const auto n = static_cast<int>(state.range(0));
    const cad::CadShape shape = cad::make_shape(BRepPrimAPI_MakeBox(1.0, 1.0, 1.0).Shape());
    cad::Layout layout(shape);
    const auto at = [&](int i, int j, int k) { return i + (n + 1) * (j + (n + 1) * k); };
    for (int k = 0; k <= n; ++k) {
        for (int j = 0; j <= n; ++j) {
            for (int i = 0; i <= n; ++i) {
                layout.add_point({1.0 * i / n, 1.0 * j / n, 1.0 * k / n}, {3, 1});
            }
        }
    }
    for (int k = 0; k < n; ++k) {
        for (int j = 0; j < n; ++j) {
            for (int i = 0; i < n; ++i) {
                layout.hexas.push_back({{at(i, j, k), at(i + 1, j, k), at(i + 1, j + 1, k),
                                         at(i, j + 1, k), at(i, j, k + 1), at(i + 1, j, k + 1),
                                         at(i + 1, j + 1, k + 1), at(i, j + 1, k + 1)},
                                        1});
            }
        }
    }
    for (auto _ : state) {
        cad::CadBlocks blocks = cad::blocks_of(shape, layout, 3);
        blocks.report.push_back({{3, 1}, "bench", "", {}, 0, n * n * n});
        blocks = cad::refine_to_tolerance(shape, std::move(blocks), 1e-3, 6);
        benchmark::DoNotOptimize(cad::generate_on_cad(shape, blocks, 1));
    }
}
BENCHMARK(many_blocks)->Arg(34)->Unit(benchmark::kMillisecond)->UseRealTime();

} // namespace
