// SPDX-License-Identifier: LGPL-2.1-or-later
// N3R written and read by one thread, and the same numbers through printf and scanf.
#include "nmgs/blocking/generate.h"
#include "nmgs/element/hexa20.h"
#include "nmgs/formats/result_file.h"
#include "nmgs/support/numbers.h"
#include "nmgs/support/parallel.h"
#include "nmgs/support/text_reader.h"

#include <benchmark/benchmark.h>

#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace {

constexpr std::int32_t divisions = 24;

struct Example {
    nmgs::BlockModel model;
    nmgs::Mesh mesh;
    std::string path = (std::filesystem::temp_directory_path() / "nmgs_files_bench.n3r").string();
    std::string peer_path = path + ".peer";

    Example() {
        for (const auto &p : nmgs::hexa20::natural) {
            // A bent block, so that the coordinates have all their digits.
            model.nodes.push_back(
                {p[0] + 0.1 * p[1] * p[1] + 0.03 * p[2], p[1] + 0.1 * p[2], p[2] + 0.07 * p[0]});
        }
        model.divisions.push_back({divisions, divisions, divisions});
        mesh = nmgs::generate(model);
    }
    ~Example() {
        std::filesystem::remove(path);
        std::filesystem::remove(peer_path);
    }
    Example(const Example &) = delete;
    Example &operator=(const Example &) = delete;

    void write() const {
        nmgs::write_result_file(path, model, "bench", {mesh.points.data(), mesh.points.size()},
                                {mesh.cells[0].nodes.data(), mesh.cells[0].nodes.size()});
    }
};

void count_bytes(benchmark::State &state, const std::string &path) {
    state.SetBytesProcessed(static_cast<std::int64_t>(state.iterations()) *
                            static_cast<std::int64_t>(std::filesystem::file_size(path)));
}

void write_n3r(benchmark::State &state) {
    nmgs::set_threads(1);
    const Example example;
    for (auto _ : state) {
        example.write();
    }
    count_bytes(state, example.path);
    nmgs::set_threads(0);
}
BENCHMARK(write_n3r)->Unit(benchmark::kMillisecond)->UseRealTime();

void read_n3r(benchmark::State &state) {
    const Example example;
    example.write();
    for (auto _ : state) {
        const auto file = nmgs::read_result_file(example.path, 3);
        benchmark::DoNotOptimize(file.points.data());
    }
    count_bytes(state, example.path);
}
BENCHMARK(read_n3r)->Unit(benchmark::kMillisecond)->UseRealTime();

struct Number {
    double value;
    bool whole;
};

std::vector<Number> numbers_of(const std::string &path) {
    nmgs::TextReader reader(path);
    reader.skip_line();
    reader.skip_line();
    std::vector<Number> numbers;
    for (auto word = reader.word(); !word.empty(); word = reader.word()) {
        numbers.push_back(
            {nmgs::parse_double(word).value(), nmgs::parse_integer(word).has_value()});
    }
    return numbers;
}

using File = std::unique_ptr<std::FILE, int (*)(std::FILE *)>;

void print_numbers(const std::vector<Number> &numbers, const std::string &path) {
    const File file(std::fopen(path.c_str(), "wb"), &std::fclose);
    for (const Number &n : numbers) {
        if (n.whole) {
            std::fprintf(file.get(), "%d\n", static_cast<int>(n.value));
        } else {
            std::fprintf(file.get(), "%.17g\n", n.value);
        }
    }
}

void printf_peer(benchmark::State &state) {
    const Example example;
    example.write();
    const auto numbers = numbers_of(example.path);
    for (auto _ : state) {
        print_numbers(numbers, example.peer_path);
    }
    count_bytes(state, example.peer_path);
}
BENCHMARK(printf_peer)->Unit(benchmark::kMillisecond)->UseRealTime();

void scanf_peer(benchmark::State &state) {
    const Example example;
    example.write();
    const auto numbers = numbers_of(example.path);
    print_numbers(numbers, example.peer_path);
    for (auto _ : state) {
        const File file(std::fopen(example.peer_path.c_str(), "rb"), &std::fclose);
        double sum = 0;
        for (const Number &n : numbers) {
            int whole = 0;
            double value = 0;
            const int got = n.whole ? std::fscanf(file.get(), "%d", &whole)
                                    : std::fscanf(file.get(), "%lf", &value);
            sum += got == 1 ? whole + value : 0;
        }
        benchmark::DoNotOptimize(sum);
    }
    count_bytes(state, example.peer_path);
}
BENCHMARK(scanf_peer)->Unit(benchmark::kMillisecond)->UseRealTime();

} // namespace
