// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs_cad/section_layout.h"

#include <BRepTools_WireExplorer.hxx>
#include <BRep_Tool.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Iterator.hxx>
#include <TopoDS_Wire.hxx>

namespace nmgs::cad {

bool layout_section(const CadShape &section, Layout &flat, const LayoutOptions &, Refusal &refusal,
                    const Progress &) {
    for (int f = 1; f <= section.faces.Extent(); ++f) {
        int wires = 0;
        std::vector<std::int32_t> loop;
        for (TopoDS_Iterator it(section.face(f)); it.More(); it.Next()) {
            if (it.Value().ShapeType() != TopAbs_WIRE) {
                continue;
            }
            ++wires;
            for (BRepTools_WireExplorer e(TopoDS::Wire(it.Value()), section.face(f)); e.More();
                 e.Next()) {
                const int n = section.edges.FindIndex(e.Current());
                const std::vector<double> eighths{0.125, 0.25, 0.375, 0.5, 0.625, 0.75, 0.875};
                const std::vector<double> half{0.5};
                auto points = flat.divide_edge(
                    section, n, BRep_Tool::IsClosed(section.edge(n)) ? eighths : half);
                if (e.Current().Orientation() == TopAbs_REVERSED) {
                    std::reverse(points.begin(), points.end());
                }
                loop.insert(loop.end(), points.begin(), points.end() - 1);
            }
        }
        if (wires != 1) {
            refusal = {"holes are not laid out yet", {}};
            return false;
        }
        Vec3 centre{};
        for (const auto p : loop) {
            centre += flat.points[static_cast<std::size_t>(p)];
        }
        centre = (1.0 / static_cast<double>(loop.size())) * centre;
        const auto c = flat.add_point(centre, {2, f});
        for (std::size_t i = 0; i < loop.size(); i += 2) {
            flat.quads.push_back({{c, loop[(i + loop.size() - 1) % loop.size()], loop[i],
                                   loop[(i + 1) % loop.size()]},
                                  f});
        }
    }
    return true;
}

} // namespace nmgs::cad
