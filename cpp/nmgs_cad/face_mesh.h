// SPDX-License-Identifier: LGPL-2.1-or-later
// Quads over one face before they are put into a layout: what the strategies for faces make.
#pragma once

#include "nmgs_cad/face_boundary.h"

#include <array>
#include <cstdint>
#include <map>
#include <vector>

namespace nmgs::cad {

// A face that is cut open along its seams; its nodes on the boundary come first and are fixed.
struct FaceMesh {
    std::vector<Vec3> points;
    std::vector<Uv> uv;
    std::vector<Vec3> normals;                      // of the oriented face at the points
    std::vector<std::int32_t> layout_point;         // of nodes on the boundary; -1 inside
    std::vector<std::array<std::int32_t, 4>> quads; // counter-clockwise about the normal
    // Of node n on the boundary: its angle and its neighbours along the boundary with the
    // directions of the boundary to them; -1 inside and where there is none.
    struct Rim {
        double angle = 0;
        std::int32_t before = -1, after = -1;
        Vec3 to_before{}, to_after{};
        Vec3 middle_after{}; // of the CAD's curve to the node after
        Uv bend_after{};     // its parameters against the mean of those of both nodes
    };
    std::vector<Rim> rim;
    // Middles of sides inside that follow the boundary's bend, ends ascending.
    std::map<std::array<std::int32_t, 2>, Vec3> middles;

    [[nodiscard]] bool fixed(std::int32_t n) const {
        return layout_point[static_cast<std::size_t>(n)] >= 0;
    }
    std::int32_t add(const FaceSurface &surface, Uv p);
    // How the boundary bends between two neighbours on it, in the parameters.
    [[nodiscard]] Uv bend(std::int32_t a, std::int32_t b) const;
    void set_middle(const FaceSurface &surface, std::int32_t a, std::int32_t b, Uv bend);
    void move(const FaceSurface &surface, std::int32_t n, Uv p);
};

// The nodes of the boundary, loop after loop, each place once: poles and places at which the loops
// touch are one node. numbers[loop][i]: the node of the boundary's node.
FaceMesh face_mesh_of(const FaceSurface &surface, const std::vector<BoundaryLoop> &boundary,
                      std::vector<std::vector<std::int32_t>> &numbers);

// The angle at corner c of a quad in the tangent plane, in (-pi, pi], negative when turned over:
// what it tends to when the quad is divided. Along the boundary its tangents count.
double corner_angle(const FaceMesh &mesh, const std::array<std::int32_t, 4> &quad, std::size_t c);
// Its sine: what the scaled Jacobian tends to; -1 where the angle is not defined.
double corner_quality(const FaceMesh &mesh, const std::array<std::int32_t, 4> &quad, std::size_t c);
// The least over the corners.
double quad_quality(const FaceMesh &mesh, const std::array<std::int32_t, 4> &quad);
double worst_quality(const FaceMesh &mesh);
// Corner c is one of the face's own that is sharper than about 20 degrees, and the quad has it to
// itself: no layout can do anything about it.
bool unavoidable(const FaceMesh &mesh, const std::array<std::int32_t, 4> &quad, std::size_t c);
// Least sine of the angle between the coordinate lines of the quads as 8-node patches with their
// middles on the CAD, at the corners and on lines between them.
double curved_quality(const FaceMesh &mesh, const FaceSurface &surface);
// The same without the corners that are unavoidable.
double worst_avoidable(const FaceMesh &mesh, const FaceSurface &surface);

// Puts the nodes inside and the quads into the layout.
void put(const FaceMesh &mesh, int face, Layout &layout);

} // namespace nmgs::cad
