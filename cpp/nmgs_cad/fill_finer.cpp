// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs_cad/fill_finer.h"

#include "nmgs/support/at.h"
#include "nmgs_cad/entity_locator.h"

#include <algorithm>
#include <iterator>
#include <span>

namespace nmgs::cad {

std::optional<LayoutQuality>
fill_finer(const CadShape &shape, int solid, Layout &layout, const LayoutOptions &options,
           Refusal &refusal, const Progress &progress,
           const std::function<bool(Layout &, const LayoutOptions &, Refusal &)> &fill,
           double good) {
    struct Step {
        double angle;  // of the one asked for
        double pieces; // of the solid's extent, 0: any length
    };
    constexpr Step steps[] = {{1, 0}, {0.5, 0}, {1, 10}, {0.5, 20}, {0.25, 30}};
    constexpr std::size_t enough = 3000; // hexahedra: no finer than this
    std::optional<Layout> best;
    LayoutQuality quality;
    const auto most = std::min<std::size_t>(std::size(steps), at(std::max(options.attempts, 1)));
    // What neighbours have laid out may ask for a finer layout than the first.
    for (const Step &step : std::span(steps).first(most)) {
        poll(progress, 0.0);
        if (best && late(options)) {
            break;
        }
        LayoutOptions finer = options;
        finer.attempts = 1; // the steps here are what is tried
        finer.angle *= step.angle;
        if (step.pieces > 0) {
            const double size = extent_of(shape.solid(solid)) / step.pieces;
            finer.size = options.size > 0 ? std::min(options.size, size) : size;
        }
        Layout trial = layout;
        Refusal why;
        if (!fill(trial, finer, why)) {
            if (!best) {
                refusal = why;
                if (&step != &steps[0]) {
                    return std::nullopt;
                }
            }
            continue;
        }
        const LayoutQuality found = layout_quality(shape, trial, layout.hexas.size());
        const std::size_t count = trial.hexas.size() - layout.hexas.size();
        if (!best || found.worst > quality.worst) {
            quality = found;
            best = std::move(trial);
        }
        if (quality.reaches(good) || count > enough) {
            break;
        }
    }
    if (!best) {
        return std::nullopt;
    }
    if (quality.worst <= 0) {
        refusal = {"its blocks would be folded", {entity_name(3, solid)}};
        return std::nullopt;
    }
    layout = std::move(*best);
    return quality;
}

} // namespace nmgs::cad
