// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs_cad/section_layout.h"

#include "nmgs_cad/face_layout.h"

#include <numeric>

namespace nmgs::cad {

bool layout_section(const CadShape &section, Layout &flat, const LayoutOptions &options,
                    Refusal &refusal, const Progress &progress) {
    std::vector<int> faces(static_cast<std::size_t>(section.faces.Extent()));
    std::iota(faces.begin(), faces.end(), 1);
    std::vector<FitEntry> report;
    layout_faces(section, faces, flat, options, report, progress);
    for (const FitEntry &entry : report) {
        if (entry.method.empty()) {
            refusal = {"the section cannot be laid out: " + entry.reason, {}};
            return false;
        }
    }
    return true;
}

} // namespace nmgs::cad
