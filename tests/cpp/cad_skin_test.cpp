// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs_cad/skin.h"

#include "nmgs/plc/check.h"
#include "nmgs/support/error.h"
#include "nmgs_cad/skin_mesh.h"
#include "nmgs_cad/skin_start.h"

#include <BRepAlgoAPI_Common.hxx>
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepGProp.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <BRep_Tool.hxx>
#include <GProp_GProps.hxx>

#include <gtest/gtest.h>

#include <map>
#include <numeric>
#include <set>

namespace {

using nmgs::Vec3;
using nmgs::cad::CadShape;
using nmgs::cad::Skin;

std::size_t at(std::int32_t n) {
    return static_cast<std::size_t>(n);
}

std::vector<int> all_faces(const CadShape &shape) {
    std::vector<int> faces(at(shape.faces.Extent()));
    std::iota(faces.begin(), faces.end(), 1);
    return faces;
}

double area(const Skin &skin) {
    double sum = 0;
    for (const auto &t : skin.triangles) {
        const Vec3 a = skin.points[at(t[0])];
        sum += 0.5 * norm(cross(skin.points[at(t[1])] - a, skin.points[at(t[2])] - a));
    }
    return sum;
}

struct Case {
    const char *name;
    TopoDS_Shape shape;
    int euler; // V - E + F of the closed surface
};

std::vector<Case> cases() {
    const TopoDS_Shape box = BRepPrimAPI_MakeBox(10.0, 6.0, 4.0).Shape();
    const TopoDS_Shape hole =
        BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(5, 3, -1), gp_Dir(0, 0, 1)), 1.0, 6.0).Shape();
    return {{"box", box, 2},
            {"cylinder", BRepPrimAPI_MakeCylinder(1.0, 8.0).Shape(), 2},
            {"ball", BRepPrimAPI_MakeSphere(2.0).Shape(), 2},
            {"torus", BRepPrimAPI_MakeTorus(5.0, 1.5).Shape(), 0},
            {"box with a hole", BRepAlgoAPI_Cut(box, hole).Shape(), 0}};
}

TEST(Skin, IsClosedLikeItsShapeAndNearIt) {
    for (const Case &c : cases()) {
        SCOPED_TRACE(c.name);
        const CadShape shape = nmgs::cad::make_shape(c.shape);
        const Skin skin = nmgs::cad::make_skin(shape, all_faces(shape));
        std::map<std::array<std::int32_t, 2>, int> sides; // directed
        for (const auto &t : skin.triangles) {
            for (std::size_t i = 0; i < 3; ++i) {
                ++sides[{t[i], t[(i + 1) % 3]}];
            }
        }
        for (const auto &[ends, count] : sides) {
            EXPECT_EQ(count, 1);
            EXPECT_TRUE(sides.contains({ends[1], ends[0]}));
        }
        EXPECT_EQ(static_cast<int>(skin.points.size()) - static_cast<int>(sides.size() / 2) +
                      static_cast<int>(skin.triangles.size()),
                  c.euler);
        GProp_GProps properties;
        BRepGProp::SurfaceProperties(c.shape, properties);
        EXPECT_NEAR(area(skin), properties.Mass(), 0.05 * properties.Mass());
        nmgs::Plc plc;
        plc.points = skin.points;
        for (const auto &t : skin.triangles) {
            plc.polygon_nodes.insert(plc.polygon_nodes.end(), t.begin(), t.end());
            plc.end_polygon();
            plc.end_facet();
        }
        EXPECT_TRUE(nmgs::check(plc).empty());
    }
}

TEST(Skin, EdgesAreChainsBetweenTheirVerticesInOrder) {
    for (const Case &c : cases()) {
        SCOPED_TRACE(c.name);
        const CadShape shape = nmgs::cad::make_shape(c.shape);
        const Skin skin = nmgs::cad::make_skin(shape, all_faces(shape));
        std::set<std::array<std::int32_t, 2>> sides;
        for (const auto &t : skin.triangles) {
            for (std::size_t i = 0; i < 3; ++i) {
                sides.insert({t[i], t[(i + 1) % 3]});
            }
        }
        for (int e = 1; e <= shape.edges.Extent(); ++e) {
            const auto &chain = skin.edges[at(e)];
            if (BRep_Tool::Degenerated(shape.edge(e))) {
                EXPECT_TRUE(chain.empty());
                continue;
            }
            ASSERT_GE(chain.size(), BRep_Tool::IsClosed(shape.edge(e)) ? 4U : 2U);
            for (std::size_t k = 0; k < chain.size(); ++k) {
                const bool end = k == 0 || k + 1 == chain.size();
                EXPECT_EQ(skin.on[at(chain[k])].dimension, end ? 0 : 1);
                if (k > 0) {
                    EXPECT_TRUE(sides.contains({chain[k - 1], chain[k]}));
                    EXPECT_LT(skin.parameters[at(e)][k - 1], skin.parameters[at(e)][k]);
                }
            }
        }
    }
}

TEST(Skin, KeepsAGivenDivisionOfEdges) {
    const CadShape shape = nmgs::cad::make_shape(BRepPrimAPI_MakeCylinder(1.0, 2.0).Shape());
    nmgs::cad::Layout layout(shape);
    const std::vector<double> fractions{0.2, 0.4, 0.6, 0.8};
    for (int e = 1; e <= shape.edges.Extent(); ++e) {
        layout.divide_edge(shape, e, fractions);
    }
    nmgs::cad::SkinOptions options;
    options.fixed = &layout;
    const std::vector<int> one{1};
    const Skin skin = nmgs::cad::make_skin(shape, one, options);
    for (int e = 1; e <= shape.edges.Extent(); ++e) {
        const auto &chain = skin.edges[at(e)];
        ASSERT_EQ(chain.size(), 6U);
        for (std::size_t k = 1; k < 5; ++k) {
            EXPECT_EQ(skin.source[at(chain[k])], layout.edges[at(e)][k]);
        }
    }
}

TEST(Skin, IsFinerWhereALimitSaysSo) {
    const CadShape shape = nmgs::cad::make_shape(BRepPrimAPI_MakeBox(10.0, 10.0, 10.0).Shape());
    nmgs::cad::SkinOptions options;
    options.limits.push_back({{0, 0, 0}, 2.0, 0.4});
    const Skin coarse = nmgs::cad::make_skin(shape, all_faces(shape));
    const Skin fine = nmgs::cad::make_skin(shape, all_faces(shape), options);
    EXPECT_GT(fine.triangles.size(), 2 * coarse.triangles.size());
}

TEST(Skin, StopsWhenAsked) {
    const CadShape shape = nmgs::cad::make_shape(BRepPrimAPI_MakeBox(1.0, 1.0, 1.0).Shape());
    EXPECT_THROW(nmgs::cad::make_skin(shape, all_faces(shape), {}, [](double) { return false; }),
                 nmgs::Cancelled);
}

// A slice of a cylinder: its caps are segments of a circle, a tenth as high as the circle is wide.
TopoDS_Shape slice() {
    return BRepAlgoAPI_Common(BRepPrimAPI_MakeCylinder(10.0, 4.0).Shape(),
                              BRepPrimAPI_MakeBox(gp_Pnt(9, -10, 0), 10.0, 20.0, 4.0).Shape());
}

TEST(SkinBuilder, FollowsNarrowFacesByTheirArea) {
    const CadShape shape = nmgs::cad::make_shape(slice());
    const Skin skin = nmgs::cad::make_skin(shape, all_faces(shape));
    for (int n = 1; n <= shape.faces.Extent(); ++n) {
        GProp_GProps properties;
        BRepGProp::SurfaceProperties(shape.face(n), properties);
        Skin own = skin;
        own.triangles.clear();
        for (std::size_t t = 0; t < skin.triangles.size(); ++t) {
            if (skin.faces[t] == n) {
                own.triangles.push_back(skin.triangles[t]);
            }
        }
        EXPECT_NEAR(area(own), properties.Mass(), 0.08 * properties.Mass()) << n;
    }
}

TEST(SkinBuilder, IsFinerWhereItIsToldToBe) {
    const CadShape shape = nmgs::cad::make_shape(BRepPrimAPI_MakeBox(10.0, 6.0, 4.0).Shape());
    nmgs::cad::SkinBuilder builder(shape, all_faces(shape), {});
    const Skin before = builder.skin();
    const std::vector<nmgs::cad::SkinOptions::Limit> limits{{{0, 0, 0}, 1.0, 0.3}};
    builder.refine(limits);
    const Skin after = builder.skin();
    EXPECT_GT(after.triangles.size(), before.triangles.size());
    EXPECT_NEAR(area(after), area(before), 1e-9 * area(before));
    int near = 0;
    for (const auto &t : after.triangles) {
        for (std::size_t i = 0; i < 3; ++i) {
            const Vec3 a = after.points[at(t[i])];
            const Vec3 b = after.points[at(t[(i + 1) % 3])];
            if (norm(a) < 0.5 && norm(b) < 0.5) {
                EXPECT_LT(distance(a, b), 1.5 * 0.3); // an edge is split from 1.4 times its length
                ++near;
            }
        }
    }
    EXPECT_GT(near, 0);
}

TEST(SkinMesh, DropsTrianglesOnALine) {
    const CadShape shape = nmgs::cad::make_shape(BRepPrimAPI_MakeBox(10.0, 6.0, 4.0).Shape());
    const nmgs::cad::SkinOptions options;
    nmgs::cad::SkinMesh mesh(shape, options);
    nmgs::cad::start_skin(shape, all_faces(shape), options, mesh, {});
    mesh.find_sizes({});
    mesh.pass({}, 0, 1);
    const auto height = [&](const nmgs::cad::SkinMesh::Triangle &t) {
        const Vec3 a = mesh.points[at(t.p[0])].p;
        const Vec3 b = mesh.points[at(t.p[1])].p;
        const Vec3 c = mesh.points[at(t.p[2])].p;
        const double most = std::max({distance(a, b), distance(b, c), distance(c, a)});
        return norm(cross(b - a, c - a)) / (most * most);
    };
    // A point of a face goes onto a chord of the CAD's edge.
    bool any = false;
    for (std::size_t t = 0; t < mesh.triangles.size() && !any; ++t) {
        const auto p = mesh.triangles[t].p;
        for (std::size_t i = 0; i < 3 && mesh.triangles[t].face != 0; ++i) {
            auto &apex = mesh.points[at(p[(i + 2) % 3])];
            if (mesh.segment(p[i], p[(i + 1) % 3]) != 0 && apex.on.dimension == 2) {
                apex.p = 0.5 * (mesh.points[at(p[i])].p + mesh.points[at(p[(i + 1) % 3])].p);
                apex.uv = mesh.face(apex.on.index).nearest(apex.p, apex.uv);
                any = true;
                break;
            }
        }
    }
    ASSERT_TRUE(any);
    mesh.drop_flat();
    double sum = 0;
    for (const auto &t : mesh.triangles) {
        if (t.face != 0) {
            EXPECT_GT(height(t), 0.01);
            const Vec3 a = mesh.points[at(t.p[0])].p;
            sum += 0.5 * norm(cross(mesh.points[at(t.p[1])].p - a, mesh.points[at(t.p[2])].p - a));
        }
    }
    EXPECT_NEAR(sum, 2 * (60 + 40 + 24), 1e-9);
}

} // namespace
