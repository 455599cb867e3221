// SPDX-License-Identifier: LGPL-2.1-or-later
// Most of the files' tests are tests/api/test_nmgs_files.py; here what needs no Python.
#include "nmgs/formats/result_file.h"

#include "nmgs/blocking/generate.h"
#include "nmgs/element/hexa20.h"
#include "nmgs/support/parallel.h"

#include <gtest/gtest.h>

#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>

namespace {

TEST(ResultFile, RoundTripAndSameBytesForAnyNumberOfThreads) {
    nmgs::BlockModel model;
    for (int b = 0; b < 2; ++b) {
        for (const auto &p : nmgs::hexa20::natural) {
            model.nodes.push_back({p[0] / 3 + 2.0 / 3 * b, p[1] + 0.1 * p[2], p[2] / 7});
        }
        model.divisions.push_back({12, 11, 10});
    }
    const auto mesh = nmgs::generate(model);
    const std::string path = ::testing::TempDir() + "nmgs_result_file_test.n3r";
    std::string texts[2];
    for (int threads = 1; threads <= 2; ++threads) {
        nmgs::set_threads(threads == 1 ? 1 : 5);
        nmgs::write_result_file(path, model, "reference", {mesh.points.data(), mesh.points.size()},
                                {mesh.cells[0].nodes.data(), mesh.cells[0].nodes.size()});
        std::ifstream file(path, std::ios::binary);
        texts[threads - 1].assign(std::istreambuf_iterator<char>(file), {});
    }
    nmgs::set_threads(0);
    EXPECT_EQ(texts[0], texts[1]);
    const auto back = nmgs::read_result_file(path, 3);
    std::filesystem::remove(path);
    EXPECT_EQ(back.reference, "reference");
    ASSERT_EQ(back.points.size(), mesh.points.size());
    EXPECT_EQ(std::memcmp(back.points.data(), mesh.points.data(), 24 * mesh.points.size()), 0);
    ASSERT_EQ(back.cells.size(), mesh.cells[0].nodes.size());
    EXPECT_EQ(std::memcmp(back.cells.data(), mesh.cells[0].nodes.data(), 4 * back.cells.size()), 0);
    EXPECT_EQ(back.model.divisions, model.divisions);
}

TEST(ResultFile, RefusesAnotherMesh) {
    nmgs::BlockModel model;
    for (const auto &p : nmgs::hexa20::natural) {
        model.nodes.push_back({p[0], p[1], p[2]});
    }
    model.divisions.push_back({2, 2, 2});
    const auto mesh = nmgs::generate(model);
    model.divisions[0] = {2, 2, 3};
    const std::string path = ::testing::TempDir() + "nmgs_result_file_refused.n3r";
    EXPECT_THROW(nmgs::write_result_file(path, model, "", {mesh.points.data(), mesh.points.size()},
                                         {mesh.cells[0].nodes.data(), mesh.cells[0].nodes.size()}),
                 nmgs::ArgumentError);
    EXPECT_FALSE(std::filesystem::exists(path));
}

} // namespace
