// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs/formats/setup_file.h"

#include "nmgs/element/hexa20.h"
#include "nmgs/support/error.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

namespace {

using nmgs::BlockModel;

class SetupFile : public testing::Test {
protected:
    std::string path(const std::string &name) const { return (folder_ / name).string(); }
    std::string text(const std::string &name) const {
        std::ifstream file(path(name), std::ios::binary);
        std::stringstream all;
        all << file.rdbuf();
        return all.str();
    }
    void write(const std::string &name, const std::string &content) const {
        std::ofstream(path(name), std::ios::binary) << content;
    }
    void SetUp() override {
        folder_ = std::filesystem::temp_directory_path() /
                  ("nmgs_setup_" +
                   std::string(testing::UnitTest::GetInstance()->current_test_info()->name()));
        std::filesystem::create_directories(folder_);
    }
    void TearDown() override { std::filesystem::remove_all(folder_); }

private:
    std::filesystem::path folder_;
};

BlockModel block() {
    BlockModel model;
    for (const auto &p : nmgs::hexa20::natural) {
        model.nodes.push_back({p[0] / 3, 0.1 * p[1], 1e-7 * p[2]});
    }
    model.divisions.push_back({2, 3, 4});
    return model;
}

TEST_F(SetupFile, ReadsWhatItWrites) {
    const BlockModel model = block();
    nmgs::write_setup_file(path("a.n3s"), model, "a reference");
    const auto read = nmgs::read_setup_file(path("a.n3s"), 3);
    EXPECT_EQ(read.reference, "a reference");
    EXPECT_EQ(read.model.divisions, model.divisions);
    ASSERT_EQ(read.model.nodes.size(), model.nodes.size());
    for (std::size_t i = 0; i < model.nodes.size(); ++i) { // to the bit
        EXPECT_EQ(read.model.nodes[i].x, model.nodes[i].x);
        EXPECT_EQ(read.model.nodes[i].y, model.nodes[i].y);
        EXPECT_EQ(read.model.nodes[i].z, model.nodes[i].z);
    }
    nmgs::write_setup_file(path("b.n3s"), read.model, read.reference);
    EXPECT_EQ(text("a.n3s"), text("b.n3s"));
}

TEST_F(SetupFile, EveryTruncationIsAnErrorWithItsFile) {
    nmgs::write_setup_file(path("a.n3s"), block(), "");
    const std::string whole = text("a.n3s");
    for (std::size_t size = 0; size + 3 < whole.size(); size += 7) {
        write("cut.n3s", whole.substr(0, size));
        try {
            nmgs::read_setup_file(path("cut.n3s"), 3);
            // A last number cut short is a number, too.
            EXPECT_GT(size + 30, whole.size());
        } catch (const nmgs::FormatError &e) {
            EXPECT_NE(std::string(e.what()).find("cut.n3s"), std::string::npos) << e.what();
        }
    }
}

TEST_F(SetupFile, TheOtherKindIsAnError) {
    nmgs::write_setup_file(path("a.n3s"), block(), "");
    EXPECT_THROW(nmgs::read_setup_file(path("a.n3s"), 2), nmgs::FormatError);
    EXPECT_THROW(nmgs::read_setup_file(path("none.n3s"), 3), std::filesystem::filesystem_error);
}

TEST_F(SetupFile, AReferenceOfTwoLinesIsRefused) {
    EXPECT_THROW(nmgs::write_setup_file(path("a.n3s"), block(), "one\ntwo"), nmgs::ArgumentError);
    EXPECT_FALSE(std::filesystem::exists(path("a.n3s")));
}

} // namespace
