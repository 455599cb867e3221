// SPDX-License-Identifier: LGPL-2.1-or-later
// Moves the nodes of quads or hexahedra until none is inside out and the worst is as good as it
// gets. Regularised shape energy (Escobar, Rodriguez, Montenegro, Montero, Gonzalez-Yuste,
// Simultaneous untangling and smoothing of tetrahedral meshes, Comput. Methods Appl. Mech. Eng.
// 192, 2003), node by node with Newton's method; then the least scaled Jacobian round a node is
// raised directly (Freitag and Ollivier-Gooch, Tetrahedral mesh improvement using swapping and
// smoothing, 1997).
#pragma once

#include "nmgs/support/progress.h"
#include "nmgs/support/vec3.h"

#include <array>
#include <cstdint>
#include <span>

namespace nmgs {

// Where nodes may go.
class NodeSlides {
public:
    NodeSlides() = default;
    NodeSlides(const NodeSlides &) = delete;
    NodeSlides &operator=(const NodeSlides &) = delete;
    virtual ~NodeSlides() = default;
    // 0 fixed, 1 along a curve, 2 over a surface, 3 anywhere.
    [[nodiscard]] virtual int freedom(std::int32_t node) const = 0;
    // Unit tangent (freedom 1), or two orthonormal ones (freedom 2), at the node's place p.
    virtual std::array<Vec3, 2> tangents(std::int32_t node, Vec3 p) = 0;
    // The allowed place nearest to `wanted`, found from the allowed place `from`.
    virtual Vec3 slide(std::int32_t node, Vec3 from, Vec3 wanted) = 0;
    // Unit normal at p of the surface on which quad q lies; towards it the quad's nodes are
    // counter-clockwise.
    virtual Vec3 normal(std::int32_t quad, Vec3 p) = 0;
};

struct UntangleOptions {
    double good = 2;     // stops once the worst scaled Jacobian is this
    int sweeps = 60;     // over the nodes, at most, of each of the two parts
    int raises = 30'000; // nodes that the second part may visit in all
    double gain = 1e-3;  // the least rise of the worst in a few sweeps that calls for more
    // Not the worst only: each node round which there is less than `good` moves, and only to where
    // its own worst is better. For meshes where some corner cannot be raised.
    bool each = false;
};
struct UntangleResult {
    double before = 1, after = 1; // worst scaled Jacobian, over the corners
};

// Changes points in place; they are never left with a lower worst scaled Jacobian. Nodes of
// hexahedra as in hexa20.h, or of quads. Results depend on the input alone.
UntangleResult untangle(std::span<Vec3> points,
                        std::span<const std::array<std::int32_t, 8>> hexahedra,
                        std::span<const std::array<std::int32_t, 4>> quads, NodeSlides &slides,
                        const UntangleOptions &options = {}, const Progress &progress = {});

} // namespace nmgs
