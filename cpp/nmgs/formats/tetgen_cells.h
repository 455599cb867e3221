// SPDX-License-Identifier: LGPL-2.1-or-later
// TetGen's lists of cells: .ele, .face, .edge, .neigh (TetGen manual 5.2.4 to 5.2.7). Their nodes
// are in the .node file of the same name.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace nmgs {

enum class TetgenList { ele, face, edge, neigh };

// Row r has nodes[r * columns] ... , 0-based and in TetGen's order; -1 in a .neigh is "none".
struct TetgenCells {
    int columns = 0; // .ele 4 or 10, .face 3 or 6, .edge 2 or 3, .neigh 4
    std::vector<std::int32_t> nodes;
    int attribute_count = 0;
    std::vector<double> attributes;    // attribute_count a row, of an .ele
    std::vector<std::int32_t> markers; // one a row or none, of a .face or .edge
    [[nodiscard]] std::size_t size() const {
        return columns > 0 ? nodes.size() / static_cast<std::size_t>(columns) : 0;
    }
};

// first: number of the first node (0 or 1). nodes: how many there are; a .neigh counts tetrahedra
// and takes its own length. Raises FormatError with file and line, filesystem_error.
TetgenCells read_cells(const std::string &path, TetgenList list, std::int32_t first,
                       std::int64_t nodes);

void write_cells(const std::string &path, TetgenList list, const TetgenCells &cells,
                 std::int32_t first = 1);

} // namespace nmgs
