// SPDX-License-Identifier: LGPL-2.1-or-later
// Twelve tetrahedra of each of a million hexahedra into touched memory, and the related nodes of
// the tetrahedra; one thread, so that the rates are a core's.
#include "nmgs/blocking/generate.h"
#include "nmgs/convert/hexa_to_tetra.h"
#include "nmgs/element/hexa20.h"
#include "nmgs/mesh/related_nodes.h"
#include "nmgs/support/parallel.h"

#include <benchmark/benchmark.h>

#include <algorithm>

namespace {

nmgs::Mesh cube(std::int32_t n, double bend) {
    nmgs::BlockModel model;
    for (const auto &p : nmgs::hexa20::natural) {
        model.nodes.push_back({p[0] + bend * p[1] * p[1], p[1] + bend * p[2], p[2]});
    }
    model.divisions.push_back({n, n, n});
    return nmgs::generate(model);
}

struct Tetrahedra {
    std::vector<nmgs::Vec3> points;
    std::vector<std::int32_t> cells;
    explicit Tetrahedra(const nmgs::Mesh &mesh)
        : points(mesh.points.size() + mesh.cells[0].size()), cells(48 * mesh.cells[0].size()) {
        std::copy(mesh.points.begin(), mesh.points.end(), points.begin());
    }
    void split(const nmgs::Mesh &mesh) {
        const std::size_t n = mesh.points.size();
        nmgs::split_hexahedra(
            {mesh.points.data(), n}, {mesh.cells[0].nodes.data(), mesh.cells[0].nodes.size()},
            static_cast<std::int32_t>(n), cells, {points.data() + n, points.size() - n});
    }
};

// bend 0: a cube, nothing but equal diagonals; else unequal ones.
void split_million(benchmark::State &state, double bend) {
    nmgs::set_threads(1);
    const auto mesh = cube(100, bend);
    Tetrahedra result(mesh);
    for (auto _ : state) {
        result.split(mesh);
        benchmark::ClobberMemory();
    }
    state.counters["tets/s"] =
        benchmark::Counter(12e6, benchmark::Counter::kIsIterationInvariantRate);
    nmgs::set_threads(0);
}
BENCHMARK_CAPTURE(split_million, cube, 0.0)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(split_million, bent, 0.2)->Unit(benchmark::kMillisecond)->UseRealTime();

void related_nodes_of_tetrahedra(benchmark::State &state) {
    nmgs::set_threads(1);
    const auto mesh = cube(100, 0.2);
    Tetrahedra result(mesh);
    result.split(mesh);
    const nmgs::CellView view{nmgs::CellType::tetra, result.cells};
    for (auto _ : state) {
        const auto related = nmgs::related_nodes(result.points.size(), {&view, 1});
        benchmark::DoNotOptimize(related.neighbours.data());
    }
    nmgs::set_threads(0);
}
BENCHMARK(related_nodes_of_tetrahedra)->Unit(benchmark::kMillisecond)->UseRealTime();

} // namespace
