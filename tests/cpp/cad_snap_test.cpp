// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs_cad/snap.h"

#include "nmgs_cad/generate_on_cad.h"
#include "nmgs_cad/layout.h"

#include <BRepAdaptor_Surface.hxx>
#include <BRepBuilderAPI_NurbsConvert.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <BRep_Tool.hxx>
#include <TopExp.hxx>

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

namespace {

using namespace nmgs;
using cad::CadShape;
using cad::Layout;
using std::numbers::pi;

const std::vector<double> thirds{1.0 / 3, 2.0 / 3};

CadShape as_nurbs(const TopoDS_Shape &shape) {
    return cad::make_shape(BRepBuilderAPI_NurbsConvert(shape).Shape());
}

// The only face that is not plane.
int curved_face(const CadShape &shape) {
    for (int n = 1; n <= shape.faces.Extent(); ++n) {
        const BRepAdaptor_Surface surface(shape.face(n));
        if (surface.GetType() != GeomAbs_Plane &&
            std::abs(surface
                         .Value(0.3 * surface.FirstUParameter() + 0.7 * surface.LastUParameter(),
                                0.5 * (surface.FirstVParameter() + surface.LastVParameter()))
                         .Z()) < 0.9) {
            return n;
        }
    }
    return shape.faces.Extent();
}

std::int32_t point_at(const Layout &layout, Vec3 p) {
    for (std::size_t n = 0; n < layout.points.size(); ++n) {
        if (distance(layout.points[n], p) < 1e-6) {
            return static_cast<std::int32_t>(n);
        }
    }
    return -1;
}
std::int32_t point_at(Layout &layout, Vec3 p, int face) {
    const std::int32_t known = point_at(layout, p);
    return known >= 0 ? known : layout.add_point(p, {2, face});
}

Mesh mesh_of(const CadShape &shape, const Layout &layout, std::int32_t n) {
    auto blocks = cad::blocks_of(shape, layout, 2);
    for (auto &g : blocks.model.divisions) {
        g = {n, n, 0};
    }
    return cad::generate_on_cad(shape, blocks, 1);
}

// Sum of the quads' areas; every quad must look to where `outward` points.
double area_of(const Mesh &mesh, const std::function<Vec3(Vec3)> &outward) {
    double area = 0;
    const auto &cells = mesh.cells.front().nodes;
    for (std::size_t c = 0; c < cells.size(); c += 4) {
        std::array<Vec3, 4> p{};
        for (std::size_t i = 0; i < 4; ++i) {
            p[i] = mesh.points[static_cast<std::size_t>(cells[c + i])];
        }
        const Vec3 twice = cross(p[2] - p[0], p[3] - p[1]);
        const Vec3 centre = 0.25 * (p[0] + p[1] + p[2] + p[3]);
        EXPECT_GT(dot(twice, outward(centre)), 0) << "quad " << c / 4;
        area += 0.5 * norm(twice);
    }
    return area;
}

// Three quads round a cylinder's wall, whose two circles begin and end on the seam.
void check_wall(const CadShape &shape) {
    const int wall = curved_face(shape);
    Layout layout(shape);
    for (int n = 1; n <= shape.edges.Extent(); ++n) {
        layout.divide_edge(shape, n,
                           BRep_Tool::IsClosed(shape.edge(n)) ? thirds : std::vector<double>{});
    }
    const auto at = [&](int k, double z) {
        return point_at(layout, {std::cos(2 * pi * k / 3), std::sin(2 * pi * k / 3), z});
    };
    for (int k = 0; k < 3; ++k) {
        layout.quads.push_back({{at(k, -0.5), at(k + 1, -0.5), at(k + 1, 0.5), at(k, 0.5)}, wall});
        for (const auto p : layout.quads.back().points) {
            ASSERT_GE(p, 0);
        }
    }
    const std::int32_t n = 8;
    const Mesh mesh = mesh_of(shape, layout, n);
    EXPECT_EQ(mesh.points.size(), 3U * n * (n + 1));
    for (const Vec3 p : mesh.points) {
        EXPECT_NEAR(std::hypot(p.x, p.y), 1, 1e-9);
        // Evenly spread: at multiples of 15 degrees.
        const double step = std::atan2(p.y, p.x) / (2 * pi / (3 * n));
        EXPECT_NEAR(step, std::round(step), 1e-5);
    }
    const double area = area_of(mesh, [](Vec3 p) { return Vec3{p.x, p.y, 0}; });
    EXPECT_NEAR(area, 3 * n * 2 * std::sin(pi / (3 * n)), 1e-6);
}

TopoDS_Shape cylinder() {
    return BRepPrimAPI_MakeCylinder(gp_Ax2({0, 0, -0.5}, {0, 0, 1}, {1, 0, 0}), 1.0, 1.0).Shape();
}

TEST(Snap, PartsOfAClosedEdgeGoTheWayOfTheirMiddle) {
    check_wall(cad::make_shape(cylinder()));
}
TEST(Snap, PartsOfAClosedSplineGoTheWayOfTheirMiddle) {
    check_wall(as_nurbs(cylinder()));
}

// Three by three quads over a torus, which is closed in both directions.
void check_torus(const CadShape &shape) {
    constexpr double ring = 3;
    constexpr double tube = 1;
    Layout layout(shape);
    layout.divide_edge(shape, 1, thirds);
    layout.divide_edge(shape, 2, thirds);
    const auto at = [&](int i, int j) {
        const double u = 2 * pi * i / 3;
        const double v = 2 * pi * j / 3;
        const double r = ring + tube * std::cos(v);
        return point_at(layout, {r * std::cos(u), r * std::sin(u), tube * std::sin(v)}, 1);
    };
    for (int j = 0; j < 3; ++j) {
        for (int i = 0; i < 3; ++i) {
            layout.quads.push_back({{at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)}, 1});
        }
    }
    ASSERT_EQ(layout.points.size(), 9U);
    const auto outward = [&](Vec3 p) {
        const double r = std::hypot(p.x, p.y);
        return p - (ring / r) * Vec3{p.x, p.y, 0};
    };
    double before = 1e9;
    for (const std::int32_t n : {4, 8, 16}) {
        const Mesh mesh = mesh_of(shape, layout, n);
        EXPECT_EQ(mesh.points.size(), static_cast<std::size_t>(9 * n * n));
        for (const Vec3 p : mesh.points) {
            EXPECT_NEAR(norm(outward(p)), tube, 1e-8);
        }
        const double error = 4 * pi * pi * ring * tube - area_of(mesh, outward);
        EXPECT_GT(error, 0);
        EXPECT_LT(error, 0.35 * before); // second order: a quarter
        before = error;
    }
}

TEST(Snap, ATorusIsClosedInBothDirections) {
    check_torus(cad::make_shape(BRepPrimAPI_MakeTorus(3.0, 1.0).Shape()));
}
TEST(Snap, ASplineTorusIsClosedInBothDirections) {
    check_torus(as_nurbs(BRepPrimAPI_MakeTorus(3.0, 1.0).Shape()));
}

// Four quads round each pole of a sphere and eight between them; its seam is on their edges.
void check_sphere(const CadShape &shape) {
    Layout layout(shape);
    int seam = 0;
    for (int n = 1; n <= shape.edges.Extent(); ++n) {
        seam = BRep_Tool::Degenerated(shape.edge(n)) ? seam : n;
    }
    layout.divide_edge(shape, seam, thirds);
    const auto on_sphere = [&](int k, double latitude) {
        const double u = pi * k / 4;
        return point_at(layout,
                        {std::cos(latitude) * std::cos(u), std::cos(latitude) * std::sin(u),
                         std::sin(latitude)},
                        1);
    };
    const auto upper = [&](int k) { return on_sphere(k % 8, k % 2 == 0 ? pi / 6 : pi / 9); };
    const auto lower = [&](int k) { return on_sphere(k % 8, k % 2 == 0 ? -pi / 6 : -pi / 9); };
    const std::int32_t north = point_at(layout, {0, 0, 1}, 1);
    const std::int32_t south = point_at(layout, {0, 0, -1}, 1);
    for (int k = 0; k < 8; ++k) {
        layout.quads.push_back({{lower(k), lower(k + 1), upper(k + 1), upper(k)}, 1});
        if (k % 2 == 0) {
            layout.quads.push_back({{north, upper(k), upper(k + 1), upper(k + 2)}, 1});
            layout.quads.push_back({{south, lower(k + 2), lower(k + 1), lower(k)}, 1});
        }
    }
    ASSERT_EQ(layout.points.size(), 18U);
    double before = 1e9;
    for (const std::int32_t n : {2, 4, 8, 16}) {
        const Mesh mesh = mesh_of(shape, layout, n);
        for (const Vec3 p : mesh.points) {
            EXPECT_NEAR(norm(p), 1, 1e-9);
        }
        const double error = 4 * pi - area_of(mesh, [](Vec3 p) { return p; });
        EXPECT_GT(error, 0);
        EXPECT_LT(error, 0.35 * before);
        before = error;
    }
}

TEST(Snap, ASpheresPolesAreCorners) {
    check_sphere(cad::make_shape(BRepPrimAPI_MakeSphere(1.0).Shape()));
}
TEST(Snap, ASplineSpheresPolesAreCorners) {
    check_sphere(as_nurbs(BRepPrimAPI_MakeSphere(1.0).Shape()));
}

// A box's edges in five pieces of any length: the nodes of the pieces stay in order.
TEST(Snap, PiecesOfAnEdgeKeepTheirPlaces) {
    const CadShape shape = cad::make_shape(BRepPrimAPI_MakeBox(1.0, 1.0, 1.0).Shape());
    Layout layout(shape);
    const std::vector<double> cuts{0.1, 0.2, 0.6, 0.95};
    const int face = 1;
    TopTools_IndexedMapOfShape edges;
    TopExp::MapShapes(shape.face(face), TopAbs_EDGE, edges);
    ASSERT_EQ(edges.Extent(), 4);
    for (int n = 1; n <= 4; ++n) {
        layout.divide_edge(shape, shape.edges.FindIndex(edges(n)), cuts);
    }
    // The face x = 0, a lattice of 5 by 5 quads; its normal is -x.
    const std::array<double, 6> t{0, 0.1, 0.2, 0.6, 0.95, 1};
    for (std::size_t j = 0; j < 5; ++j) {
        for (std::size_t i = 0; i < 5; ++i) {
            const auto at = [&](std::size_t a, std::size_t b) {
                return point_at(layout, {0, t[a], t[b]}, face);
            };
            layout.quads.push_back(
                {{at(i, j), at(i, j + 1), at(i + 1, j + 1), at(i + 1, j)}, face});
        }
    }
    ASSERT_EQ(layout.points.size(), 36U);
    const Mesh mesh = mesh_of(shape, layout, 2);
    EXPECT_NEAR(area_of(mesh, [](Vec3) { return Vec3{-1, 0, 0}; }), 1, 1e-12);
}

} // namespace
