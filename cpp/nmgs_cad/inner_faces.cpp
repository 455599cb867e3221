// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs_cad/inner_faces.h"

#include "nmgs_cad/face_normals.h"

#include <TopExp_Explorer.hxx>

#include <algorithm>
#include <cmath>

namespace nmgs::cad {

std::map<int, std::vector<int>> inner_faces(const CadShape &cad) {
    std::map<int, std::vector<int>> result;
    for (int n = 1; n <= cad.solids.Extent(); ++n) {
        for (TopExp_Explorer it(cad.solids(n), TopAbs_FACE); it.More(); it.Next()) {
            auto &list = result[cad.faces.FindIndex(it.Current())];
            if (std::find(list.begin(), list.end(), n) == list.end()) {
                list.push_back(n);
            }
        }
    }
    for (auto it = result.begin(); it != result.end();) {
        it = it->second.size() < 2 ? result.erase(it) : std::next(it);
    }
    return result;
}

bool runs_along(const TopoDS_Face &face, Vec3 direction) {
    const auto samples = sample_normals(face);
    return std::all_of(samples.begin(), samples.end(), [&](const PointNormal &s) {
        return std::abs(dot(s.normal, direction)) < 1e-3;
    });
}

} // namespace nmgs::cad
