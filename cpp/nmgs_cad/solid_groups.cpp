// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs_cad/solid_groups.h"

#include "nmgs/support/at.h"

#include <TopExp.hxx>

#include <algorithm>
#include <map>
#include <numeric>

namespace nmgs::cad {

std::vector<std::vector<int>> joined_solids(const CadShape &shape, std::span<const int> solids) {
    std::vector<int> ordered(solids.begin(), solids.end());
    std::sort(ordered.begin(), ordered.end());
    // Of each solid the one that stands for its group: the first.
    std::vector<std::size_t> root(ordered.size());
    std::iota(root.begin(), root.end(), std::size_t{0});
    const auto find = [&](std::size_t n) {
        while (root[n] != n) {
            n = root[n];
        }
        return n;
    };
    // What two solids share has its vertices in common as well. (A closed edge has one, and so has
    // a face without a rim.)
    std::vector<std::size_t> user(at(shape.vertices.Extent()) + 1, ordered.size());
    for (std::size_t s = 0; s < ordered.size(); ++s) {
        TopTools_IndexedMapOfShape vertices;
        TopExp::MapShapes(shape.solid(ordered[s]), TopAbs_VERTEX, vertices);
        for (int v = 1; v <= vertices.Extent(); ++v) {
            auto &known = user[at(shape.vertices.FindIndex(vertices(v)))];
            if (known == ordered.size()) {
                known = s;
                continue;
            }
            const std::size_t a = find(s);
            const std::size_t b = find(known);
            root[std::max(a, b)] = std::min(a, b);
        }
    }
    std::map<std::size_t, std::vector<int>> groups;
    for (std::size_t s = 0; s < ordered.size(); ++s) {
        groups[find(s)].push_back(ordered[s]);
    }
    std::vector<std::vector<int>> result;
    result.reserve(groups.size());
    for (auto &[first, group] : groups) {
        result.push_back(std::move(group));
    }
    return result;
}

} // namespace nmgs::cad
