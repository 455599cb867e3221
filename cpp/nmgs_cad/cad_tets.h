// SPDX-License-Identifier: LGPL-2.1-or-later
// Tetrahedra in CAD solids together with the triangles that cover their faces.
#pragma once

#include "nmgs_cad/tets_to_hexas.h"

#include <BRepAdaptor_Curve.hxx>

#include <map>
#include <memory>
#include <optional>
#include <vector>

namespace nmgs::cad {

// Vertices (1-based) inside a solid, on none of its faces, ascending.
std::vector<int> inner_vertices(const CadShape &shape, int solid);
// Their places, in the same order.
std::vector<Vec3> inner_vertex_places(const CadShape &shape, int solid);

// One mesh of all solids; the skin's points come first. Splitting an edge changes all tetrahedra,
// triangles and segments at it.
class CadTets {
public:
    struct Tet {
        std::array<std::int32_t, 4> p;
        std::int32_t solid; // 0: gone
    };
    struct Triangle {
        std::array<std::int32_t, 3> p;
        std::array<Uv, 3> uv;
        std::int32_t face; // 0: gone
    };
    struct Chain {
        std::vector<std::int32_t> points;
        std::vector<double> parameters;
    };

    CadTets(const CadShape &shape, const Skin &skin, std::span<const SolidTets> solids);

    std::vector<Vec3> points;
    std::vector<CadEntity> on;
    std::vector<Tet> tets;
    std::vector<Triangle> triangles;
    std::vector<Chain> chains; // by CAD edge

    // Better tetrahedra between the same skin: see nmgs/quality/tet_improvement.h. The least scaled
    // Jacobian of their hexahedra then.
    double improve(const Progress &progress);

    [[nodiscard]] std::int32_t segment(std::int32_t a, std::int32_t b) const;
    // The skin's triangle of three points, or -1.
    [[nodiscard]] std::int32_t triangle(std::int32_t a, std::int32_t b, std::int32_t c) const;
    // Where the middle of an edge is, and on what.
    struct Middle {
        Vec3 p;
        CadEntity on;
        double t = 0;
        Uv uv;
    };
    Middle middle(std::int32_t a, std::int32_t b);
    // Middle of a face of a tetrahedron, given the middles of its edges.
    Middle centre(const std::array<std::int32_t, 3> &corners, const std::array<Vec3, 3> &middles,
                  int solid);
    const FaceGeometry &face(int n);

private:
    const BRepAdaptor_Curve &curve(int n);
    void link();
    Middle find_middle(std::int32_t a, std::int32_t b);
    Middle find_centre(const Triangle &triangle, Vec3 near, double size);

    const CadShape &shape_;
    std::vector<std::vector<std::int32_t>> tets_of_, triangles_of_;
    std::map<std::array<std::int32_t, 2>, std::int32_t> segments_;
    // What was asked for on the skin, by the points.
    std::map<std::array<std::int32_t, 2>, Middle> middles_;
    std::map<std::array<std::int32_t, 3>, Middle> centres_;
    std::vector<std::unique_ptr<FaceGeometry>> faces_;
    std::vector<std::unique_ptr<BRepAdaptor_Curve>> curves_;
};

} // namespace nmgs::cad
