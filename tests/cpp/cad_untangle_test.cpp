// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs_cad/untangle.h"

#include "nmgs/quality/quality.h"
#include "nmgs_cad/cad_geometry.h"
#include "nmgs_cad/generate_on_cad.h"

#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <TopExp.hxx>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace {

using namespace nmgs;
using cad::CadEntity;
using cad::CadShape;
using cad::Layout;
using std::numbers::pi;

// n x n x n blocks in a cube of side n.
Layout lattice(const CadShape &shape, int n) {
    Layout layout(shape);
    std::vector<double> fractions;
    for (int i = 1; i < n; ++i) {
        fractions.push_back(static_cast<double>(i) / n);
    }
    for (int e = 1; e <= 12; ++e) {
        layout.divide_edge(shape, e, fractions);
    }
    const auto at = [&](int i, int j, int k) {
        const Vec3 p{static_cast<double>(i), static_cast<double>(j), static_cast<double>(k)};
        for (std::size_t m = 0; m < layout.points.size(); ++m) {
            if (distance(layout.points[m], p) < 1e-9) {
                return static_cast<std::int32_t>(m);
            }
        }
        for (int f = 1; f <= 6; ++f) {
            cad::FaceProjection face(shape.face(f));
            if (distance(face.nearest(p), p) < 1e-9) {
                return layout.add_point(p, {2, f});
            }
        }
        return layout.add_point(p, {3, 1});
    };
    for (int k = 0; k < n; ++k) {
        for (int j = 0; j < n; ++j) {
            for (int i = 0; i < n; ++i) {
                layout.hexas.push_back({{at(i, j, k), at(i + 1, j, k), at(i + 1, j + 1, k),
                                         at(i, j + 1, k), at(i, j, k + 1), at(i + 1, j, k + 1),
                                         at(i + 1, j + 1, k + 1), at(i, j + 1, k + 1)},
                                        1});
            }
        }
    }
    // The blocks' faces on the CAD.
    for (const auto &hexa : layout.hexas) {
        constexpr std::array<std::array<std::size_t, 4>, 6> sides{
            {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}}};
        for (const auto &side : sides) {
            for (int f = 1; f <= 6; ++f) {
                cad::FaceProjection face(shape.face(f));
                bool on = true;
                Layout::Quad quad{{}, f};
                for (std::size_t c = 0; c < 4; ++c) {
                    quad.points[c] = hexa.points[side[c]];
                    const Vec3 p = layout.points[static_cast<std::size_t>(quad.points[c])];
                    on = on && distance(face.nearest(p), p) < 1e-9;
                }
                if (on) {
                    layout.quads.push_back(quad);
                }
            }
        }
    }
    return layout;
}

CadShape cube(int n) {
    return cad::make_shape(BRepPrimAPI_MakeBox(1.0 * n, 1.0 * n, 1.0 * n).Shape());
}

TEST(CadUntangle, PointsComeBackAlongWhatTheyLieOn) {
    const CadShape shape = cube(3);
    Layout layout = lattice(shape, 3);
    EXPECT_NEAR(cad::worst_scaled_jacobian(shape, layout), 1, 1e-12);
    for (std::size_t n = 0; n < layout.points.size(); ++n) {
        Vec3 &p = layout.points[n];
        const int dimension = layout.on[n].dimension;
        if (dimension == 1) {
            cad::EdgeCurve curve(shape.edge(layout.on[n].index));
            const double f = curve.fraction(p);
            p = curve.at(f < 0.5 ? 0.6 : 0.9); // both to one end
        } else if (dimension == 2) {
            p = cad::FaceProjection(shape.face(layout.on[n].index))
                    .nearest(p + Vec3{0.9, -0.7, 0.8});
        } else if (dimension == 3) {
            p += Vec3{1.2, 0.4, -0.6};
        }
    }
    const double before = cad::worst_scaled_jacobian(shape, layout);
    ASSERT_LT(before, 0);
    const double after = cad::improve(shape, layout);
    EXPECT_GT(after, 0.8);
    EXPECT_NEAR(after, cad::worst_scaled_jacobian(shape, layout), 1e-12);
    for (std::size_t n = 0; n < layout.points.size(); ++n) {
        const Vec3 p = layout.points[n];
        if (layout.on[n].dimension == 1) {
            const cad::EdgeCurve curve(shape.edge(layout.on[n].index));
            EXPECT_LT(distance(curve.at(curve.fraction(p)), p), 1e-9);
        } else if (layout.on[n].dimension == 2) {
            EXPECT_LT(distance(cad::FaceProjection(shape.face(layout.on[n].index)).nearest(p), p),
                      1e-9);
        }
    }
}

TEST(CadUntangle, QuadsOverATorusComeBack) {
    const CadShape shape = cad::make_shape(BRepPrimAPI_MakeTorus(3.0, 1.0).Shape());
    Layout layout(shape);
    const std::vector<double> fifths{0.2, 0.4, 0.6, 0.8};
    layout.divide_edge(shape, 1, fifths);
    layout.divide_edge(shape, 2, fifths);
    const auto place = [](double i, double j) {
        const double u = 2 * pi * i / 5;
        const double v = 2 * pi * j / 5;
        const double r = 3 + std::cos(v);
        return Vec3{r * std::cos(u), r * std::sin(u), std::sin(v)};
    };
    std::array<std::array<std::int32_t, 5>, 5> number{};
    for (std::size_t j = 0; j < 5; ++j) {
        for (std::size_t i = 0; i < 5; ++i) {
            const Vec3 p = place(static_cast<double>(i), static_cast<double>(j));
            std::int32_t found = -1;
            for (std::size_t n = 0; n < layout.points.size(); ++n) {
                found = distance(layout.points[n], p) < 1e-6 ? static_cast<std::int32_t>(n) : found;
            }
            number[i][j] = found >= 0 ? found : layout.add_point(p, {2, 1});
        }
    }
    ASSERT_EQ(layout.points.size(), 25U);
    for (std::size_t j = 0; j < 5; ++j) {
        for (std::size_t i = 0; i < 5; ++i) {
            layout.quads.push_back({{number[i][j], number[(i + 1) % 5][j],
                                     number[(i + 1) % 5][(j + 1) % 5], number[i][(j + 1) % 5]},
                                    1});
        }
    }
    const double regular = cad::worst_scaled_jacobian(shape, layout);
    EXPECT_GT(regular, 0.3);
    layout.points[static_cast<std::size_t>(number[2][2])] = place(3.4, 2.9);
    layout.points[static_cast<std::size_t>(number[1][3])] = place(1.7, 1.8);
    ASSERT_LT(cad::worst_scaled_jacobian(shape, layout), 0);
    EXPECT_GT(cad::improve(shape, layout), 0.8 * regular);
    for (const Vec3 p : layout.points) {
        EXPECT_NEAR(std::hypot(std::hypot(p.x, p.y) - 3, p.z), 1, 1e-9);
    }
}

// The middle of eight blocks is out of place: the mesh made from them is mended.
void check_mesh(int order) {
    const CadShape shape = cube(2);
    Layout layout = lattice(shape, 2);
    for (std::size_t n = 0; n < layout.points.size(); ++n) {
        if (layout.on[n].dimension == 3) {
            layout.points[n] = {1.9, 1.9, 2.2};
        }
    }
    auto blocks = cad::blocks_of(shape, layout, 3);
    for (auto &g : blocks.model.divisions) {
        g = {3, 3, 3};
    }
    const Mesh mesh = cad::generate_on_cad(shape, blocks, order);
    const std::span<const Vec3> points(mesh.points.data(), mesh.points.size());
    const auto &cells = mesh.cells.front();
    const CellView view{cells.type, {cells.nodes.data(), cells.nodes.size()}};
    const auto worst = quality(points, view, Metric::scaled_jacobian);
    EXPECT_GT(*std::min_element(worst.begin(), worst.end()), order == 1 ? 0.2 : 0);
    double volume = 0;
    for (const double v : quality(points, view, Metric::volume)) {
        volume += v;
    }
    EXPECT_NEAR(volume, 8, 1e-9);
    for (const auto &[name, group] : mesh.groups) {
        if (name.starts_with("Edge")) {
            const cad::EdgeCurve curve(shape.edge(std::stoi(name.substr(4))));
            for (const auto n : group.indices) {
                const Vec3 p = points[static_cast<std::size_t>(n)];
                EXPECT_LT(distance(curve.at(curve.fraction(p)), p), 1e-9);
            }
        }
    }
}

TEST(CadUntangle, AMeshIsMended) {
    check_mesh(1);
}
TEST(CadUntangle, AQuadraticMeshIsMended) {
    check_mesh(2);
}

} // namespace
