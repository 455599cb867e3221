// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs_cad/tets_to_hexas.h"

#include "nmgs/mesh/cell_topology.h"
#include "nmgs/quality/volume_metrics.h"

#include <BRepGProp.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRep_Tool.hxx>
#include <GProp_GProps.hxx>

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

namespace {

using nmgs::Vec3;
using nmgs::cad::CadShape;

std::size_t at(std::int32_t n) {
    return static_cast<std::size_t>(n);
}

// Of a convex body: every triangle of its skin with a point inside.
nmgs::cad::SolidTets star(const nmgs::cad::Skin &skin) {
    nmgs::cad::SolidTets tets{1, {}, {}};
    Vec3 middle{0, 0, 0};
    for (const Vec3 p : skin.points) {
        middle += (1.0 / static_cast<double>(skin.points.size())) * p;
    }
    tets.inner.push_back(middle);
    const auto inside = static_cast<std::int32_t>(skin.points.size());
    for (const auto &t : skin.triangles) {
        tets.tets.push_back({t[0], t[2], t[1], inside});
    }
    return tets;
}

TEST(TetsToHexas, FillConvexBodiesWithTheirVolume) {
    for (const TopoDS_Shape &body :
         {BRepPrimAPI_MakeBox(3.0, 2.0, 2.0).Shape(), BRepPrimAPI_MakeCylinder(1.0, 2.0).Shape(),
          BRepPrimAPI_MakeSphere(1.0).Shape()}) {
        const CadShape shape = nmgs::cad::make_shape(body);
        std::vector<int> faces(at(shape.faces.Extent()));
        std::iota(faces.begin(), faces.end(), 1);
        const nmgs::cad::Skin skin = nmgs::cad::make_skin(shape, faces);
        const std::vector<nmgs::cad::SolidTets> solids{star(skin)};
        nmgs::cad::Layout layout(shape);
        const auto result = nmgs::cad::tets_to_hexas(shape, skin, solids, layout);
        EXPECT_GT(result.worst, 0);
        EXPECT_EQ(layout.hexas.size() % 4, 0U);
        EXPECT_GE(layout.hexas.size(), 4 * skin.triangles.size());
        EXPECT_EQ(layout.quads.size() % 3, 0U);
        double volume = 0;
        double worst = 1;
        for (const auto &hexa : layout.hexas) {
            std::array<Vec3, 8> p{};
            for (std::size_t i = 0; i < 8; ++i) {
                p[i] = layout.points[at(hexa.points[i])];
            }
            volume += nmgs::solid::volume(nmgs::CellType::hexahedron, p.data());
            worst = std::min(worst, nmgs::hexahedron::scaled_jacobian(p.data()));
        }
        EXPECT_GT(worst, 0);
        EXPECT_LE(result.worst, worst + 1e-12); // the corners are among Verdict's places
        GProp_GProps properties;
        BRepGProp::VolumeProperties(body, properties);
        EXPECT_NEAR(volume, properties.Mass(), 0.03 * properties.Mass());
        for (int e = 1; e <= shape.edges.Extent(); ++e) {
            const bool pole = BRep_Tool::Degenerated(shape.edge(e));
            // Two segments for one of the skin.
            EXPECT_EQ(layout.edges[at(e)].size(), pole ? 0 : 2 * skin.edges[at(e)].size() - 1);
        }
    }
}

TEST(TetsToHexas, PartsATetrahedronWithTwoFacesInOneFace) {
    // The ball's skin with points, a tetrahedron on two neighbouring triangles of it.
    const CadShape shape = nmgs::cad::make_shape(BRepPrimAPI_MakeSphere(1.0).Shape());
    const std::vector<int> faces{1};
    const nmgs::cad::Skin skin = nmgs::cad::make_skin(shape, faces);
    auto tets = star(skin);
    std::size_t other = 0;
    std::array<std::int32_t, 2> hinge{};
    const auto &first = skin.triangles[0];
    for (std::size_t t = 1; t < skin.triangles.size() && other == 0; ++t) {
        for (std::size_t i = 0; i < 3; ++i) {
            for (std::size_t k = 0; k < 3; ++k) {
                const auto &second = skin.triangles[t];
                if (first[i] == second[(k + 1) % 3] && first[(i + 1) % 3] == second[k] &&
                    skin.on[at(first[i])].dimension == 2) {
                    other = t;
                    hinge = {first[i], first[(i + 1) % 3]};
                }
            }
        }
    }
    if (other == 0) {
        GTEST_SKIP() << "the first triangle lies at the seam";
    }
    const auto apex = [&](const std::array<std::int32_t, 3> &t) {
        return *std::find_if(t.begin(), t.end(),
                             [&](std::int32_t n) { return n != hinge[0] && n != hinge[1]; });
    };
    const std::int32_t a = apex(first);
    const std::int32_t b = apex(skin.triangles[other]);
    // The hinge's two tetrahedra become three: one under both triangles, two under its new faces.
    const std::int32_t inside = tets.tets[0][3];
    tets.tets[0] = {hinge[0], a, b, inside};
    tets.tets[other] = {hinge[1], b, a, inside};
    tets.tets.push_back({hinge[0], hinge[1], b, a});
    const auto volume = [&](std::array<std::int32_t, 4> &t) {
        const auto p = [&](std::int32_t n) {
            return n == inside ? tets.inner[0] : skin.points[at(n)];
        };
        return determinant(p(t[1]) - p(t[0]), p(t[2]) - p(t[0]), p(t[3]) - p(t[0]));
    };
    for (auto *t : {&tets.tets[0], &tets.tets[other], &tets.tets.back()}) {
        if (volume(*t) < 0) {
            std::swap((*t)[0], (*t)[1]);
        }
    }
    nmgs::cad::Layout layout(shape);
    const std::vector<nmgs::cad::SolidTets> solids{tets};
    const auto result = nmgs::cad::tets_to_hexas(shape, skin, solids, layout);
    EXPECT_GT(layout.hexas.size(), 4 * tets.tets.size());
    EXPECT_GT(result.worst, 0);
}

} // namespace
