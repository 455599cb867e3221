// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs/blocking/patch_area.h"

#include "nmgs/element/quad8.h"

namespace nmgs {

PatchArea patch_area(const BlockModel &model, std::size_t block,
                     const std::array<std::int32_t, 3> &divisions) {
    const auto nodes = model.element(block).first<8>();
    const auto at = [&](std::int32_t i, std::int32_t j) {
        return quad8::map(nodes, 2.0 * i / divisions[0] - 1, 2.0 * j / divisions[1] - 1);
    };
    PatchArea area;
    for (std::int32_t j = 0; j < divisions[1]; ++j) {
        for (std::int32_t i = 0; i < divisions[0]; ++i) {
            area.linear +=
                0.5 * norm(cross(at(i + 1, j + 1) - at(i, j), at(i, j + 1) - at(i + 1, j)));
        }
    }
    constexpr std::array<double, 3> place{-0.7745966692414834, 0, 0.7745966692414834};
    constexpr std::array<double, 3> weight{5.0 / 9, 8.0 / 9, 5.0 / 9};
    for (std::size_t i = 0; i < 9; ++i) {
        const auto [a, b] = quad8::tangents(nodes, place[i % 3], place[i / 3]);
        area.exact += weight[i % 3] * weight[i / 3] * norm(cross(a, b));
    }
    return area;
}

} // namespace nmgs
