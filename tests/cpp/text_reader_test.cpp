// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs/support/text_reader.h"

#include "nmgs/support/error.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

namespace {

using nmgs::Comments;
using nmgs::TextReader;

class TextReaderTest : public ::testing::Test {
protected:
    std::string file(const std::string &text) {
        std::ofstream(path_, std::ios::binary) << text;
        return path_;
    }
    void TearDown() override { std::filesystem::remove(path_); }
    std::string path_ = ::testing::TempDir() + "nmgs_text_reader_" +
                        ::testing::UnitTest::GetInstance()->current_test_info()->name();
};

TEST_F(TextReaderTest, WordsOverLinesOfAnyKind) {
    TextReader reader(file("\xEF\xBB\xBF 1 2\r\n\r\n\t3\n4"));
    EXPECT_EQ(reader.integer("a"), 1);
    EXPECT_EQ(reader.integer("b"), 2);
    EXPECT_EQ(reader.line(), 1);
    EXPECT_EQ(reader.integer("c"), 3);
    EXPECT_EQ(reader.line(), 3);
    EXPECT_EQ(reader.integer("d"), 4);
    EXPECT_EQ(reader.line(), 4);
    EXPECT_TRUE(reader.word().empty());
}

TEST_F(TextReaderTest, ExplanationsAreLeftOut) {
    TextReader reader(file("--- start\n(two\nlines (nested) here)\n7 --- 8\n(end) 9\n"),
                      Comments::explanations);
    EXPECT_EQ(reader.integer("a"), 7);
    EXPECT_EQ(reader.line(), 4);
    EXPECT_EQ(reader.explanations(), 2);
    EXPECT_EQ(reader.word(), "---");
    EXPECT_EQ(reader.integer("b"), 8);
    EXPECT_EQ(reader.integer("c"), 9);
    reader.expect_end();
}

TEST_F(TextReaderTest, HashCommentsEndTheLine) {
    TextReader reader(file("# head\n4 3 # counts\n1 0.5 # no attribute\n2 1.5#tight"),
                      Comments::hash);
    EXPECT_EQ(reader.integer("n"), 4);
    EXPECT_FALSE(reader.at_line_end());
    EXPECT_EQ(reader.word_on_line(), "3");
    EXPECT_TRUE(reader.at_line_end());
    EXPECT_TRUE(reader.word_on_line().empty());
    EXPECT_EQ(reader.word(), "1");
    EXPECT_EQ(reader.word_on_line(), "0.5");
    EXPECT_TRUE(reader.at_line_end());
    EXPECT_EQ(reader.word(), "2");
    EXPECT_EQ(reader.word(), "1.5");
    EXPECT_TRUE(reader.at_line_end());
    reader.expect_end();
}

TEST_F(TextReaderTest, RawLinesInBothEncodings) {
    TextReader reader(file("caf\xE9\r\n caf\xC3\xA9 \n\nlast"));
    EXPECT_EQ(reader.raw_line().text, "caf\xC3\xA9");
    EXPECT_EQ(reader.raw_line().text, " caf\xC3\xA9 ");
    EXPECT_EQ(reader.raw_line().text, "");
    const auto last = reader.raw_line();
    EXPECT_EQ(last.text, "last");
    EXPECT_TRUE(last.more);
    EXPECT_FALSE(reader.raw_line().more);
}

TEST_F(TextReaderTest, WordsAcrossTheBuffersEnds) {
    std::string text;
    constexpr int count = 300000;
    for (int i = 0; i < count; ++i) {
        text += std::to_string(i) + (i % 7 == 0 ? "\r\n" : " ");
    }
    TextReader reader(file(text));
    for (int i = 0; i < count; ++i) {
        ASSERT_EQ(reader.integer("a number"), i);
    }
    reader.expect_end();
}

TEST_F(TextReaderTest, ErrorsNameTheLineAndWhatWasFound) {
    TextReader reader(file("1\nnan two\n"));
    EXPECT_EQ(reader.integer("a"), 1);
    try {
        reader.real("a coordinate");
        FAIL() << "expected FormatError";
    } catch (const nmgs::FormatError &e) {
        EXPECT_EQ(e.line, 2);
        EXPECT_EQ(e.path, path_);
        EXPECT_NE(std::string(e.what()).find("expected a coordinate"), std::string::npos);
        EXPECT_NE(std::string(e.what()).find("found 'nan'"), std::string::npos);
    }
    EXPECT_THROW(reader.integer("b"), nmgs::FormatError);
    EXPECT_THROW(reader.integer("c"), nmgs::FormatError); // the end
}

TEST_F(TextReaderTest, RefusesBeforeAllocation) {
    TextReader reader(file("1000000000000 1 2 3"));
    EXPECT_EQ(reader.integer("n"), 1000000000000);
    EXPECT_THROW(reader.require_numbers(1000000000000, "the nodes"), nmgs::FormatError);
    EXPECT_NO_THROW(reader.require_numbers(3, "the nodes"));
    EXPECT_THROW(reader.integer("m", 5, 9), nmgs::FormatError);
}

TEST_F(TextReaderTest, EndlessWordsAndOpenParenthesesAreErrors) {
    TextReader reader(file(std::string(1000000, '1')));
    EXPECT_THROW(reader.word(), nmgs::FormatError);
    TextReader open(file("(never closed\n1 2 3\n"), Comments::explanations);
    EXPECT_THROW(open.word(), nmgs::FormatError);
}

TEST_F(TextReaderTest, MissingFilesAndFolders) {
    EXPECT_THROW(TextReader("/nowhere/at/all"), std::filesystem::filesystem_error);
    EXPECT_THROW(TextReader(::testing::TempDir()), std::filesystem::filesystem_error);
}

} // namespace
