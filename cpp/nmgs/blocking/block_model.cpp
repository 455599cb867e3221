// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs/blocking/block_model.h"

#include "nmgs/support/error.h"

#include <limits>

namespace nmgs {
namespace {

std::string element_name(std::size_t e) {
    return "element " + std::to_string(e + 1);
}

constexpr const char *direction_names[] = {"xi", "eta", "zeta"};

void validate_spacing(const BlockModel &model, std::size_t e, int d) {
    const std::size_t at =
        e * static_cast<std::size_t>(model.dimension) + static_cast<std::size_t>(d);
    if (at >= model.spacing.size() || model.spacing[at].empty()) {
        return;
    }
    const auto &values = model.spacing[at];
    const std::string where =
        "spacing of " + element_name(e) + " along " + direction_names[d] + ": ";
    const auto expected =
        static_cast<std::size_t>(model.divisions[e][static_cast<std::size_t>(d)]) + 1;
    if (values.size() != expected) {
        throw ArgumentError(where + "expected " + std::to_string(expected) + " positions, got " +
                            std::to_string(values.size()));
    }
    if (values.front() != 0.0 || values.back() != 1.0) {
        throw ArgumentError(where + "expected positions from 0 to 1, got " +
                            std::to_string(values.front()) + " to " +
                            std::to_string(values.back()));
    }
    for (std::size_t i = 1; i < values.size(); ++i) {
        if (!(values[i] > values[i - 1])) {
            throw ArgumentError(where + "positions must ascend, but position " + std::to_string(i) +
                                " is " + std::to_string(values[i]) + " after " +
                                std::to_string(values[i - 1]));
        }
    }
}

} // namespace

void validate(const BlockModel &model) {
    if (model.dimension != 2 && model.dimension != 3) {
        throw ArgumentError("dimension: expected 2 or 3, got " + std::to_string(model.dimension));
    }
    const auto per_element = static_cast<std::size_t>(model.nodes_per_element());
    if (model.nodes.size() != model.size() * per_element) {
        throw ArgumentError("nodes: expected " + std::to_string(per_element) + " for each of " +
                            std::to_string(model.size()) + " elements, got " +
                            std::to_string(model.nodes.size()));
    }
    const std::size_t corners =
        model.size() * static_cast<std::size_t>(model.corners_per_element());
    if (!model.corners.empty() && model.corners.size() != corners) {
        throw ArgumentError("corners: expected " + std::to_string(corners) + " numbers, got " +
                            std::to_string(model.corners.size()));
    }
    for (std::size_t n = 0; n < model.corners.size(); ++n) {
        if (model.corners[n] < 0) {
            throw ArgumentError(
                "corners: " +
                element_name(n / static_cast<std::size_t>(model.corners_per_element())) + " has " +
                std::to_string(model.corners[n]) + "; expected numbers from 0 on");
        }
    }
    for (std::size_t e = 0; e < model.size(); ++e) {
        for (int d = 0; d < model.dimension; ++d) {
            const std::int32_t count = model.divisions[e][static_cast<std::size_t>(d)];
            if (count < 1) {
                throw ArgumentError("divisions: " + element_name(e) + " has " +
                                    std::to_string(count) + " along " + direction_names[d] +
                                    "; at least 1 is needed");
            }
            validate_spacing(model, e, d);
        }
        const auto nodes = model.element(e);
        for (std::size_t n = 0; n < nodes.size(); ++n) {
            if (!is_finite(nodes[n])) {
                throw ArgumentError("nodes: node " + std::to_string(n + 1) + " of " +
                                    element_name(e) + " is not finite");
            }
        }
    }
}

std::vector<double> natural_positions(const BlockModel &model, std::size_t element, int direction) {
    const int n = model.divisions[element][static_cast<std::size_t>(direction)];
    std::vector<double> positions(static_cast<std::size_t>(n) + 1);
    const std::size_t at =
        element * static_cast<std::size_t>(model.dimension) + static_cast<std::size_t>(direction);
    const bool uniform = at >= model.spacing.size() || model.spacing[at].empty();
    for (int i = 0; i <= n; ++i) {
        // 2 i - n is exact, so that the positions are symmetric about 0 to the bit.
        positions[static_cast<std::size_t>(i)] =
            uniform ? static_cast<double>(2 * static_cast<std::int64_t>(i) - n) / n
                    : 2 * model.spacing[at][static_cast<std::size_t>(i)] - 1;
    }
    return positions;
}

namespace {

// Sums of products of divisions + extra that stop at the largest integer.
std::int64_t saturated_count(const BlockModel &model, std::int32_t extra) {
    constexpr std::int64_t limit = std::numeric_limits<std::int64_t>::max();
    std::int64_t total = 0;
    for (const auto &g : model.divisions) {
        std::int64_t product = 1;
        for (int d = 0; d < model.dimension; ++d) {
            const std::int64_t n = std::int64_t{g[static_cast<std::size_t>(d)]} + extra;
            product = product > limit / n ? limit : product * n;
        }
        total = total > limit - product ? limit : total + product;
    }
    return total;
}

} // namespace

std::int64_t cell_count(const BlockModel &model) {
    return saturated_count(model, 0);
}

std::int64_t lattice_count(const BlockModel &model) {
    return saturated_count(model, 1);
}

} // namespace nmgs
