// SPDX-License-Identifier: LGPL-2.1-or-later
// One million hexahedra from one 20-node block into touched memory, against memset of the same.
#include "nmgs/blocking/generate.h"
#include "nmgs/element/hexa20.h"
#include "nmgs/support/parallel.h"

#include <benchmark/benchmark.h>

#include <cstring>

namespace {

nmgs::BlockModel cube(std::int32_t n) {
    nmgs::BlockModel model;
    for (const auto &p : nmgs::hexa20::natural) {
        model.nodes.push_back({p[0], p[1], p[2]});
    }
    model.divisions.push_back({n, n, n});
    return model;
}

void generate_million(benchmark::State &state) {
    const auto model = cube(100);
    const auto topology = nmgs::find_topology(model);
    const nmgs::Lattice lattice(model, topology);
    std::vector<nmgs::Vec3> points(static_cast<std::size_t>(lattice.node_count()));
    std::vector<std::int32_t> cells(8 * static_cast<std::size_t>(nmgs::cell_count(model)));
    for (auto _ : state) {
        nmgs::fill_points(model, lattice, points);
        nmgs::fill_cells(model, lattice, cells);
        benchmark::ClobberMemory();
    }
}
BENCHMARK(generate_million)->Unit(benchmark::kMillisecond)->UseRealTime();

void memset_million(benchmark::State &state) {
    std::vector<char> bytes(24 * 101 * 101 * 101 + 32 * 1000000);
    for (auto _ : state) {
        nmgs::parallel_for(bytes.size(), bytes.size() / 64,
                           [&](std::size_t first, std::size_t last) {
                               std::memset(bytes.data() + first, 1, last - first);
                           });
        benchmark::ClobberMemory();
    }
}
BENCHMARK(memset_million)->Unit(benchmark::kMillisecond)->UseRealTime();

// A box of 250 x 250 x 160 hexahedra, ten million, of nx * ny * nz blocks: all of generate(),
// checks, common nodes and new memory included.
nmgs::BlockModel box_of_blocks(int nx, int ny, int nz) {
    nmgs::BlockModel model;
    for (int k = 0; k < nz; ++k) {
        for (int j = 0; j < ny; ++j) {
            for (int i = 0; i < nx; ++i) {
                for (const auto &p : nmgs::hexa20::natural) {
                    model.nodes.push_back({250.0 / nx * (i + 0.5 * (p[0] + 1)),
                                           250.0 / ny * (j + 0.5 * (p[1] + 1)),
                                           160.0 / nz * (k + 0.5 * (p[2] + 1))});
                }
                model.divisions.push_back({250 / nx, 250 / ny, 160 / nz});
            }
        }
    }
    return model;
}

void generate_ten_million(benchmark::State &state, int nx, int ny, int nz) {
    const auto model = box_of_blocks(nx, ny, nz);
    for (auto _ : state) {
        const auto mesh = nmgs::generate(model);
        if (mesh.points.size() != 251U * 251 * 161) {
            state.SkipWithError("the common nodes are not one");
        }
        benchmark::DoNotOptimize(mesh.points.data());
    }
}
BENCHMARK_CAPTURE(generate_ten_million, one_block, 1, 1, 1)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime()
    ->MinTime(2);
BENCHMARK_CAPTURE(generate_ten_million, hundred_blocks, 5, 5, 4)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime()
    ->MinTime(2);

} // namespace
