// SPDX-License-Identifier: LGPL-2.1-or-later
// A tree of boxes: finds all stored boxes near another one. Built once, top down, by halves along
// the longest side; read by any number of threads.
#pragma once

#include "nmgs/support/vec3.h"

#include <cstdint>
#include <vector>

namespace nmgs {

class BoxTree {
public:
    explicit BoxTree(const std::vector<Box> &boxes);

    // Calls visit(index) for every box within `gap` of the given one, in no set order.
    template <class Visit>
    void near(const Box &box, double gap, const Visit &visit) const {
        if (!nodes_.empty()) {
            descend(0, box, gap, visit);
        }
    }

private:
    static constexpr std::size_t leaf_size = 4;
    struct Node {
        Box box;
        std::uint32_t first; // of a leaf: place in order_; else the left child is the next node
        std::uint32_t count; // of a leaf; 0: inner node
        std::uint32_t right; // of an inner node
    };

    std::uint32_t build(std::size_t first, std::size_t last);

    template <class Visit>
    void descend(std::uint32_t at, const Box &box, double gap, const Visit &visit) const {
        const Node &node = nodes_[at];
        if (!node.box.near(box, gap)) {
            return;
        }
        if (node.count == 0) {
            descend(at + 1, box, gap, visit);
            descend(node.right, box, gap, visit);
            return;
        }
        for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
            if (boxes_[order_[i]].near(box, gap)) {
                visit(order_[i]);
            }
        }
    }

    std::vector<Box> boxes_;
    std::vector<std::uint32_t> order_;
    std::vector<Node> nodes_;
};

} // namespace nmgs
