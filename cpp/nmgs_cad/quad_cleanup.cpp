// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs_cad/quad_cleanup.h"

#include "nmgs/support/at.h"
#include "nmgs_cad/quad_steps.h"

#include <algorithm>

namespace nmgs::cad {
namespace {

bool pass(QuadSteps &work) {
    std::vector<QuadStep> steps;
    for (const auto &[ends, q] : work.of_edge) {
        if (ends[0] < ends[1]) {
            work.rotations(ends[0], ends[1], steps);
        }
    }
    for (std::size_t q = 0; q < work.mesh.quads.size(); ++q) {
        work.closings(static_cast<std::int32_t>(q), steps);
    }
    for (std::size_t n = 0; n < work.mesh.points.size(); ++n) {
        work.openings(static_cast<std::int32_t>(n), steps);
    }
    std::erase_if(steps, [](const QuadStep &s) { return s.gain > -0.5; });
    std::stable_sort(steps.begin(), steps.end(),
                     [](const QuadStep &s, const QuadStep &t) { return s.gain < t.gain; });
    std::vector<char> busy(work.mesh.points.size(), 0);
    bool any = false;
    for (const QuadStep &step : steps) {
        const auto nodes = work.touched(step);
        if (std::any_of(nodes.begin(), nodes.end(),
                        [&](std::int32_t n) { return busy[at(n)] != 0; })) {
            continue;
        }
        for (const std::int32_t n : nodes) {
            busy[at(n)] = 1;
        }
        work.apply(step);
        any = true;
    }
    work.commit();
    return any;
}

} // namespace

void clean_up_quads(FaceMesh &mesh, const FaceSurface &surface,
                    const std::set<std::array<std::int32_t, 2>> &kept) {
    QuadSteps work(mesh, surface, kept);
    constexpr int passes = 30;
    for (int i = 0; i < passes && pass(work); ++i) {
    }
}

} // namespace nmgs::cad
