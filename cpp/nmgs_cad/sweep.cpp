// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs_cad/sweep.h"

#include "nmgs_cad/face_normals.h"
#include "nmgs_cad/fill_finer.h"
#include "nmgs_cad/loft.h"
#include "nmgs_cad/section.h"

#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>

#include <algorithm>
#include <optional>

namespace nmgs::cad {
namespace {

// Normals of the solid's plane faces, each line of directions once, those of most faces last: few
// caps make few levels.
std::vector<gp_Dir> directions(const CadShape &shape, int solid) {
    std::vector<std::pair<int, Vec3>> found;
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
    std::vector<gp_Dir> result;
    for (const auto &[count, n] : found) {
        if (count > 1) {
            result.emplace_back(n.x, n.y, n.z);
        }
    }
    return result;
}

} // namespace

bool fill_sweep(const CadShape &shape, int solid, Layout &layout, const LayoutOptions &options,
                Refusal &refusal, const Progress &progress) {
    refusal = {"no two of its plane faces are parallel", {entity_name(3, solid)}};
    for (const gp_Dir &direction : directions(shape, solid)) {
        poll(progress, 0.0);
        Section section;
        if (section_along(shape, solid, direction, section, refusal) &&
            fill_finer(shape, solid, layout, options, refusal, progress,
                       [&](Layout &trial, const LayoutOptions &finer, Refusal &why) {
                           return sweep_section(shape, solid, section, trial, finer, why, progress);
                       })) {
            return true;
        }
    }
    Refusal other;
    if (fill_finer(shape, solid, layout, options, other, progress,
                   [&](Layout &trial, const LayoutOptions &finer, Refusal &why) {
                       return fill_loft(shape, solid, trial, finer, why, progress);
                   })) {
        return true;
    }
    refusal.reason += "; " + other.reason;
    return false;
}

} // namespace nmgs::cad
