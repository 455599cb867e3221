// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs/support/box_tree.h"

#include <algorithm>
#include <numeric>

namespace nmgs {

BoxTree::BoxTree(const std::vector<Box> &boxes) : boxes_(boxes), order_(boxes.size()) {
    std::iota(order_.begin(), order_.end(), 0U);
    nodes_.reserve(boxes.size());
    if (!boxes.empty()) {
        build(0, boxes.size());
    }
}

std::uint32_t BoxTree::build(std::size_t first, std::size_t last) {
    const auto at = static_cast<std::uint32_t>(nodes_.size());
    Box box;
    for (std::size_t i = first; i < last; ++i) {
        box.add(boxes_[order_[i]].low);
        box.add(boxes_[order_[i]].high);
    }
    nodes_.push_back({box, static_cast<std::uint32_t>(first), 0, 0});
    if (last - first <= leaf_size) {
        nodes_[at].count = static_cast<std::uint32_t>(last - first);
        return at;
    }
    const Vec3 size = box.high - box.low;
    const auto key = [&](std::uint32_t b) {
        const Vec3 twice = boxes_[b].low + boxes_[b].high;
        return size.x >= size.y && size.x >= size.z ? twice.x
               : size.y >= size.z                   ? twice.y
                                                    : twice.z;
    };
    const std::size_t middle = first + (last - first) / 2;
    const auto begin = order_.begin();
    std::nth_element(begin + static_cast<std::ptrdiff_t>(first),
                     begin + static_cast<std::ptrdiff_t>(middle),
                     begin + static_cast<std::ptrdiff_t>(last),
                     [&](std::uint32_t a, std::uint32_t b) { return key(a) < key(b); });
    build(first, middle);
    nodes_[at].right = build(middle, last);
    return at;
}

} // namespace nmgs
