// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs/quality/hexas_of_tet.h"
#include "nmgs/quality/tet_improvement.h"

#include "nmgs/support/ascending.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace {

using nmgs::TetMesh;
using nmgs::Vec3;

constexpr std::array<std::array<std::size_t, 3>, 4> sides{
    {{1, 2, 3}, {2, 0, 3}, {0, 1, 3}, {0, 2, 1}}};

std::size_t at(std::int32_t n) {
    return static_cast<std::size_t>(n);
}

double volume(const TetMesh &mesh, const TetMesh::Tet &t) {
    const Vec3 o = mesh.points[at(t.p[0])];
    return determinant(mesh.points[at(t.p[1])] - o, mesh.points[at(t.p[2])] - o,
                       mesh.points[at(t.p[3])] - o) /
           6;
}

double worst(const TetMesh &mesh) {
    double least = 1;
    for (const auto &t : mesh.tets) {
        std::array<Vec3, 4> p{};
        for (std::size_t i = 0; i < 4; ++i) {
            p[i] = mesh.points[at(t.p[i])];
        }
        const auto half = [&](std::size_t a, std::size_t b) { return 0.5 * (p[a] + p[b]); };
        const auto third = [&](std::size_t a, std::size_t b, std::size_t c) {
            return (1.0 / 3) * (p[a] + p[b] + p[c]);
        };
        least = std::min(
            least, nmgs::hexas_quality(
                       p, {half(0, 1), half(0, 2), half(0, 3), half(1, 2), half(1, 3), half(2, 3)},
                       {third(1, 2, 3), third(0, 2, 3), third(0, 1, 3), third(0, 1, 2)}));
    }
    return least;
}

// Faces of one tetrahedron only, and those between parts, stay.
void keep_faces(TetMesh &mesh) {
    std::map<std::array<std::int32_t, 3>, std::vector<std::int32_t>> parts;
    for (const auto &t : mesh.tets) {
        for (const auto &s : sides) {
            std::array<std::int32_t, 3> f{t.p[s[0]], t.p[s[1]], t.p[s[2]]};
            std::sort(f.begin(), f.end());
            parts[f].push_back(t.part);
        }
    }
    for (const auto &[f, list] : parts) {
        if (list.size() > 1 && list[0] == list[1]) {
            continue;
        }
        mesh.centres[f] =
            (1.0 / 3) * (mesh.points[at(f[0])] + mesh.points[at(f[1])] + mesh.points[at(f[2])]);
        for (std::size_t i = 0; i < 3; ++i) {
            const std::int32_t a = f[i];
            const std::int32_t b = f[(i + 1) % 3];
            mesh.middles[nmgs::ascending(a, b)] = 0.5 * (mesh.points[at(a)] + mesh.points[at(b)]);
        }
    }
}

// A box's surface, each side in n x n squares of two triangles, joined to a point inside.
TetMesh star_in_box(int n, Vec3 centre) {
    TetMesh mesh;
    std::map<std::array<int, 3>, std::int32_t> number;
    const auto point = [&](std::array<int, 3> at) {
        const auto [known, fresh] =
            number.try_emplace(at, static_cast<std::int32_t>(mesh.points.size()));
        if (fresh) {
            mesh.points.push_back({1.0 * at[0] / n, 1.0 * at[1] / n, 1.0 * at[2] / n});
            mesh.fixed.push_back(1);
        }
        return known->second;
    };
    std::vector<std::array<std::int32_t, 3>> triangles;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        for (const int end : {0, n}) {
            for (int i = 0; i < n; ++i) {
                for (int j = 0; j < n; ++j) {
                    const auto corner = [&](int u, int v) {
                        std::array<int, 3> p{};
                        p[axis] = end;
                        p[(axis + 1) % 3] = u;
                        p[(axis + 2) % 3] = v;
                        return point(p);
                    };
                    triangles.push_back({corner(i, j), corner(i + 1, j), corner(i + 1, j + 1)});
                    triangles.push_back({corner(i, j), corner(i + 1, j + 1), corner(i, j + 1)});
                }
            }
        }
    }
    const auto inside = static_cast<std::int32_t>(mesh.points.size());
    mesh.points.push_back(centre);
    mesh.fixed.push_back(0);
    for (const auto &t : triangles) {
        mesh.tets.push_back({{inside, t[0], t[1], t[2]}, 1});
        if (volume(mesh, mesh.tets.back()) < 0) {
            std::swap(mesh.tets.back().p[2], mesh.tets.back().p[3]);
        }
    }
    keep_faces(mesh);
    return mesh;
}

void expect_sound(const TetMesh &mesh, double whole) {
    double sum = 0;
    std::map<std::array<std::int32_t, 3>, int> uses;
    for (const auto &t : mesh.tets) {
        EXPECT_GT(volume(mesh, t), 0);
        sum += volume(mesh, t);
        for (const auto &s : sides) {
            std::array<std::int32_t, 3> f{t.p[s[0]], t.p[s[1]], t.p[s[2]]};
            std::sort(f.begin(), f.end());
            ++uses[f];
        }
    }
    EXPECT_NEAR(sum, whole, 1e-9 * whole);
    for (const auto &[f, n] : uses) {
        EXPECT_LE(n, 2);
        EXPECT_TRUE(n == 2 || mesh.centres.contains(f));
    }
    for (const auto &[f, centre] : mesh.centres) {
        EXPECT_TRUE(uses.contains(f));
    }
}

TEST(TetImprovement, MeasuresTheRegularTetrahedron) {
    TetMesh mesh;
    mesh.points = {{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}};
    mesh.tets = {{{0, 1, 2, 3}, 1}};
    if (volume(mesh, mesh.tets[0]) < 0) {
        std::swap(mesh.tets[0].p[2], mesh.tets[0].p[3]);
    }
    // Three unit vectors at 60 degrees span the square root of a half; that is the worst corner.
    EXPECT_NEAR(worst(mesh), std::sqrt(0.5), 1e-12);
    std::swap(mesh.tets[0].p[2], mesh.tets[0].p[3]);
    EXPECT_LT(worst(mesh), 0);
}

TEST(TetImprovement, MendsAStarFromNearACorner) {
    TetMesh mesh = star_in_box(4, {0.1, 0.15, 0.12});
    const double before = worst(mesh);
    const double after = improve_tets(mesh);
    EXPECT_LT(before, 0.1);
    EXPECT_GT(after, 0.2);
    EXPECT_NEAR(after, worst(mesh), 1e-12);
    expect_sound(mesh, 1);
}

TEST(TetImprovement, LeavesGoodOnesAlone) {
    TetMesh mesh = star_in_box(1, {0.5, 0.5, 0.5});
    const auto count = mesh.tets.size();
    const double before = worst(mesh);
    nmgs::TetImprovementOptions options;
    options.good = 0.5 * before;
    EXPECT_EQ(improve_tets(mesh, options), before);
    EXPECT_EQ(mesh.tets.size(), count);
}

TEST(TetImprovement, KeepsWhatPartsShare) {
    // Half of the star is another part; the faces between them stay.
    TetMesh mesh = star_in_box(3, {0.4, 0.55, 0.5});
    for (std::size_t t = 0; t < mesh.tets.size() / 2; ++t) {
        mesh.tets[t].part = 2;
    }
    mesh.fixed.back() = 1;
    keep_faces(mesh);
    double second = 0;
    for (const auto &t : mesh.tets) {
        second += t.part == 2 ? volume(mesh, t) : 0;
    }
    const double before = worst(mesh);
    EXPECT_GE(improve_tets(mesh), before);
    expect_sound(mesh, 1);
    double now = 0;
    for (const auto &t : mesh.tets) {
        now += t.part == 2 ? volume(mesh, t) : 0;
    }
    EXPECT_NEAR(now, second, 1e-9);
}

TEST(TetImprovement, KeepsAnEdgeInside) {
    TetMesh mesh = star_in_box(3, {0.3, 0.5, 0.5});
    const auto inside = static_cast<std::int32_t>(mesh.points.size()) - 1;
    mesh.fixed.back() = 1;
    mesh.middles[{0, inside}] = 0.5 * (mesh.points[0] + mesh.points.back());
    improve_tets(mesh);
    expect_sound(mesh, 1);
    EXPECT_TRUE(std::any_of(mesh.tets.begin(), mesh.tets.end(), [&](const TetMesh::Tet &t) {
        const auto has = [&](std::int32_t n) {
            return std::find(t.p.begin(), t.p.end(), n) != t.p.end();
        };
        return has(0) && has(inside);
    }));
}

TEST(TetImprovement, CanBeCancelled) {
    TetMesh mesh = star_in_box(4, {0.1, 0.15, 0.12});
    EXPECT_ANY_THROW(improve_tets(mesh, {}, [](double) { return false; }));
}

} // namespace
