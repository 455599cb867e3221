// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs_cad/sweep.h"

#include "nmgs_cad/face_normals.h"
#include "nmgs_cad/fill_finer.h"
#include "nmgs_cad/loft.h"
#include "nmgs_cad/section.h"
#include "nmgs_cad/section_slopes.h"

#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>

#include <algorithm>
#include <optional>

namespace nmgs::cad {
namespace {

struct Directions {
    // Normals of at least two plane faces, each line of directions once, those of most faces last:
    // few caps make few levels.
    std::vector<gp_Dir> normals;
    std::vector<gp_Dir> axes; // of extruded faces, where they are no such normals
};

Directions directions(const CadShape &shape, int solid) {
    std::vector<std::pair<int, Vec3>> found;
    std::vector<Vec3> axes;
    for (TopExp_Explorer it(shape.solid(solid), TopAbs_FACE); it.More(); it.Next()) {
        const auto samples = sample_normals(TopoDS::Face(it.Current()));
        if (samples.empty()) {
            continue;
        }
        const Vec3 n = samples.front().normal;
        const bool plane = std::all_of(samples.begin(), samples.end(), [&](const auto &s) {
            return norm(cross(s.normal, n)) < 1e-4;
        });
        if (!plane) {
            const auto other = std::find_if(samples.begin(), samples.end(), [&](const auto &s) {
                return norm(cross(s.normal, n)) > 0.1;
            });
            if (other != samples.end()) {
                const Vec3 axis = unit(cross(n, other->normal));
                if (std::all_of(samples.begin(), samples.end(), [&](const auto &s) {
                        return std::abs(dot(s.normal, axis)) < 1e-4;
                    })) {
                    axes.push_back(axis);
                }
            }
            continue;
        }
        const auto known = std::find_if(found.begin(), found.end(), [&](const auto &f) {
            return norm(cross(f.second, n)) < 1e-4;
        });
        if (known == found.end()) {
            found.push_back({1, n});
        } else {
            ++known->first;
        }
    }
    std::stable_sort(found.begin(), found.end(),
                     [](const auto &a, const auto &b) { return a.first < b.first; });
    Directions result;
    for (const auto &[count, n] : found) {
        if (count > 1) {
            result.normals.emplace_back(n.x, n.y, n.z);
        }
    }
    for (const Vec3 a : axes) {
        const gp_Dir axis(a.x, a.y, a.z);
        const auto parallel = [&](const gp_Dir &d) { return d.IsParallel(axis, 1e-4); };
        constexpr std::size_t most = 3;
        if (result.axes.size() < most &&
            std::none_of(result.normals.begin(), result.normals.end(), parallel) &&
            std::none_of(result.axes.begin(), result.axes.end(), parallel)) {
            result.axes.push_back(axis);
        }
    }
    return result;
}

} // namespace

bool fill_sweep(const CadShape &shape, int solid, Layout &layout, const LayoutOptions &options,
                Refusal &refusal, const Progress &progress) {
    refusal = {"no two of its plane faces are parallel", {entity_name(3, solid)}};
    Directions found = directions(shape, solid);
    constexpr double good = 0.1; // a sweep that is worse may be better in another direction
    std::optional<Layout> best;
    double quality = 0;
    // Whether a sweep is good enough; the best one is kept.
    const auto attempt = [&](Refusal &why, const auto &fill) {
        Layout trial = layout;
        const auto reached = fill_finer(shape, solid, trial, options, why, progress,
                                        [&](Layout &finer, const LayoutOptions &how, Refusal &no) {
                                            return fill(finer, how, no);
                                        });
        if (reached && reached->worst > quality) {
            quality = reached->worst;
            best = std::move(trial);
        }
        return reached && reached->reaches(good);
    };
    const auto sweep = [&](const Section &section, Refusal &why) {
        return attempt(why, [&](Layout &trial, const LayoutOptions &finer, Refusal &no) {
            return sweep_section(shape, solid, section, trial, finer, no, progress);
        });
    };
    const auto done = [&] {
        if (best) {
            layout = std::move(*best);
        }
        return best.has_value();
    };
    for (const gp_Dir &direction : found.normals) {
        if (late(options)) {
            return done();
        }
        poll(progress, 0.0);
        Section section;
        if (section_along(shape, solid, direction, layout, section, refusal) &&
            sweep(section, refusal)) {
            return done();
        }
    }
    found.normals.insert(found.normals.end(), found.axes.begin(), found.axes.end());
    for (const gp_Dir &direction : found.normals) {
        if (late(options)) {
            return done();
        }
        poll(progress, 0.0);
        Section section;
        Refusal why;
        if (section_over(shape, solid, direction, layout, section, why) && sweep(section, why)) {
            return done();
        }
        refusal.reason += "; " + why.reason;
    }
    Refusal other;
    attempt(other, [&](Layout &trial, const LayoutOptions &finer, Refusal &why) {
        return fill_loft(shape, solid, trial, finer, why, progress);
    });
    refusal.reason += "; " + other.reason;
    return done();
}

} // namespace nmgs::cad
