// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs/support/atomic_file.h"

#include "nmgs/support/parallel.h"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

namespace {

namespace fs = std::filesystem;

class AtomicFileTest : public ::testing::Test {
protected:
    void SetUp() override {
        folder_ = fs::path(::testing::TempDir()) /
                  (std::string("nmgs_atomic_") +
                   ::testing::UnitTest::GetInstance()->current_test_info()->name());
        fs::remove_all(folder_);
        fs::create_directory(folder_);
    }
    void TearDown() override { fs::remove_all(folder_); }
    [[nodiscard]] static std::string text(const fs::path &path) {
        std::ifstream file(path, std::ios::binary);
        return {std::istreambuf_iterator<char>(file), {}};
    }
    [[nodiscard]] std::size_t files() const {
        return static_cast<std::size_t>(
            std::distance(fs::directory_iterator(folder_), fs::directory_iterator{}));
    }
    fs::path folder_;
};

TEST_F(AtomicFileTest, AppearsOnCommitOnly) {
    const fs::path path = folder_ / "a.txt";
    {
        nmgs::AtomicFile file(path.string());
        file.write("new");
        EXPECT_FALSE(fs::exists(path));
        file.commit();
    }
    EXPECT_EQ(text(path), "new");
    EXPECT_EQ(files(), 1U);
}

TEST_F(AtomicFileTest, WithoutCommitTheOldFileStays) {
    const fs::path path = folder_ / "a.txt";
    std::ofstream(path) << "old";
    {
        nmgs::AtomicFile file(path.string());
        file.write("half");
    }
    EXPECT_EQ(text(path), "old");
    EXPECT_EQ(files(), 1U);
}

TEST_F(AtomicFileTest, FollowsLinksAndKeepsPermissions) {
    const fs::path path = folder_ / "a.txt";
    const fs::path link = folder_ / "link.txt";
    std::ofstream(path) << "old";
    fs::permissions(path, fs::perms::owner_read | fs::perms::owner_write);
    fs::create_symlink("a.txt", link);
    nmgs::AtomicFile file(link.string());
    file.write("new");
    file.commit();
    EXPECT_TRUE(fs::is_symlink(link));
    EXPECT_EQ(text(path), "new");
    EXPECT_EQ(fs::status(path).permissions(), fs::perms::owner_read | fs::perms::owner_write);
}

TEST_F(AtomicFileTest, RefusesFoldersThatAreNot) {
    EXPECT_THROW(nmgs::AtomicFile((folder_ / "none" / "a.txt").string()), fs::filesystem_error);
    EXPECT_THROW(nmgs::AtomicFile(folder_.string()), fs::filesystem_error);
}

TEST_F(AtomicFileTest, ItemsComeInOrderForAnyNumberOfThreads) {
    std::string expected;
    for (int i = 0; i < 10007; ++i) {
        expected += std::to_string(i) + "\n";
    }
    for (const int threads : {1, 3}) {
        nmgs::set_threads(threads);
        const fs::path path = folder_ / "items.txt";
        nmgs::AtomicFile file(path.string());
        nmgs::write_items(file, 10007, 10,
                          [](std::int64_t first, std::int64_t last, nmgs::TextBuffer &out) {
                              for (std::int64_t i = first; i < last; ++i) {
                                  out.add(i);
                                  out.add('\n');
                              }
                          });
        file.commit();
        EXPECT_EQ(text(path), expected);
    }
    nmgs::set_threads(0);
}

TEST_F(AtomicFileTest, CancelLeavesNothing) {
    {
        nmgs::AtomicFile file((folder_ / "a.txt").string());
        EXPECT_THROW(nmgs::write_items(
                         file, 100, 1, [](std::int64_t, std::int64_t, nmgs::TextBuffer &) {},
                         [](double) { return false; }),
                     nmgs::Cancelled);
    }
    EXPECT_EQ(files(), 0U);
}

} // namespace
