// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs/formats/tetgen_cells.h"

#include "nmgs/support/atomic_file.h"
#include "nmgs/support/error.h"
#include "nmgs/support/text_reader.h"

#include <limits>
#include <optional>

namespace nmgs {
namespace {

constexpr std::int64_t most = std::numeric_limits<std::int32_t>::max();

struct RowShape {
    int columns;
    bool marker;
};

// The header of .face and .edge does not tell second order nor adjacent tetrahedra; the number of
// words behind a row's own number does, together with the header's marker flag.
std::optional<RowShape> row_shape(TetgenList list, int words, bool marker) {
    if (list == TetgenList::face) {
        switch (words) {
        case 3:
        case 5:
            return RowShape{3, false};
        case 4:
            return RowShape{3, true};
        case 6:
            return marker ? RowShape{3, true} : RowShape{6, false};
        case 7:
        case 9:
            return RowShape{6, true};
        case 8:
            return RowShape{6, false};
        default:
            return std::nullopt;
        }
    }
    const int columns = words - (marker ? 1 : 0);
    return columns == 2 || columns == 3 ? std::optional(RowShape{columns, marker}) : std::nullopt;
}

struct Reading {
    TextReader &reader;
    TetgenList list;
    std::int32_t first;
    std::int64_t nodes;

    std::int32_t node(std::string_view word) {
        const bool neigh = list == TetgenList::neigh;
        const std::int64_t low = neigh ? -1 : first;
        const char *what = neigh ? "a neighbour" : "a node";
        const std::int64_t number = reader.integer(word, what, low, first + nodes - 1);
        return static_cast<std::int32_t>(number < 0 ? -1 : number - first);
    }

    void rows(TetgenCells &cells, std::int64_t count, bool flag) {
        const bool open = list == TetgenList::face || list == TetgenList::edge;
        bool marker = false;
        std::vector<std::string> words;
        for (std::int64_t r = 0; r < count; ++r) {
            reader.integer("the number of a row", 0, most);
            if (open && r == 0) {
                for (auto w = reader.word_on_line(); !w.empty(); w = reader.word_on_line()) {
                    words.emplace_back(w);
                }
                const auto shape = row_shape(list, static_cast<int>(words.size()), flag);
                if (!shape) {
                    reader.fail("a row of a .face or .edge file",
                                std::to_string(words.size() + 1) + " numbers");
                }
                cells.columns = shape->columns;
                marker = shape->marker;
            }
            const auto next = [&](int place) {
                return open && r == 0 ? std::string_view(words[static_cast<std::size_t>(place)])
                                      : reader.word();
            };
            for (int k = 0; k < cells.columns; ++k) {
                cells.nodes.push_back(node(next(k)));
            }
            for (int k = 0; k < cells.attribute_count; ++k) {
                const std::string_view word = reader.word_on_line();
                cells.attributes.push_back(word.empty() ? 0.0 : reader.real(word, "an attribute"));
            }
            if (marker) {
                cells.markers.push_back(static_cast<std::int32_t>(
                    reader.integer(next(cells.columns), "a marker", -most - 1, most)));
            }
            if (!open || r > 0) {
                reader.skip_line();
            }
        }
    }
};

} // namespace

TetgenCells read_cells(const std::string &path, TetgenList list, std::int32_t first,
                       std::int64_t nodes) {
    TextReader reader(path, Comments::hash);
    TetgenCells cells;
    const std::int64_t count = reader.integer("the number of rows", 0, most);
    const std::string_view second = reader.word_on_line();
    const std::int64_t number = second.empty() ? 0 : reader.integer(second, "a number", 0, most);
    if (list == TetgenList::ele) {
        cells.columns = static_cast<int>(number == 0 ? 4 : number);
        if (cells.columns != 4 && cells.columns != 10) {
            reader.fail("4 or 10 nodes of a tetrahedron", std::to_string(number));
        }
        const std::string_view third = reader.word_on_line();
        cells.attribute_count = static_cast<int>(
            third.empty() ? 0 : reader.integer(third, "the number of attributes", 0, 1000000));
    } else if (list == TetgenList::neigh) {
        cells.columns = 4;
        nodes = count;
    }
    reader.skip_line();
    reader.require_numbers(3 * count, "the rows");
    Reading{reader, list, first, nodes}.rows(cells, count, number == 1);
    if (cells.columns == 0) {
        cells.columns = list == TetgenList::face ? 3 : 2;
    }
    reader.expect_end();
    return cells;
}

void write_cells(const std::string &path, TetgenList list, const TetgenCells &cells,
                 std::int32_t first) {
    AtomicFile file(path);
    std::string header = std::to_string(cells.size());
    if (list == TetgenList::ele) {
        header += " " + std::to_string(cells.columns) + " " + std::to_string(cells.attribute_count);
    } else if (list == TetgenList::neigh) {
        header += " 4";
    } else {
        header += cells.markers.empty() ? " 0" : " 1";
    }
    file.write(header + "\n");
    const auto k = static_cast<std::size_t>(cells.columns);
    const auto a = static_cast<std::size_t>(cells.attribute_count);
    write_items(file, static_cast<std::int64_t>(cells.size()), 4096,
                [&](std::int64_t begin, std::int64_t end, TextBuffer &text) {
                    for (auto r = static_cast<std::size_t>(begin);
                         r < static_cast<std::size_t>(end); ++r) {
                        text.add(static_cast<std::int64_t>(r) + first);
                        for (std::size_t c = 0; c < k; ++c) {
                            const std::int32_t node = cells.nodes[r * k + c];
                            text.add(' ');
                            text.add(node < 0 ? node : node + first);
                        }
                        for (std::size_t c = 0; c < a; ++c) {
                            text.add(' ');
                            text.add(cells.attributes[r * a + c]);
                        }
                        if (!cells.markers.empty()) {
                            text.add(' ');
                            text.add(cells.markers[r]);
                        }
                        text.add('\n');
                    }
                });
    file.commit();
}

} // namespace nmgs
