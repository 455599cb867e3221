// SPDX-License-Identifier: LGPL-2.1-or-later
// Coarse, well-shaped triangles over CAD faces that meet at their edges.
#pragma once

#include "nmgs/support/progress.h"
#include "nmgs/support/vec3.h"
#include "nmgs_cad/cad_blocks.h"
#include "nmgs_cad/cad_shape.h"
#include "nmgs_cad/face_geometry.h"
#include "nmgs_cad/layout.h"

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace nmgs::cad {

class SkinMesh;

struct Skin {
    std::vector<Vec3> points;
    std::vector<CadEntity> on;                          // vertex, edge or face of each point
    std::vector<std::array<std::int32_t, 3>> triangles; // counter-clockwise about the face's normal
    std::vector<std::int32_t> faces;                    // n of FaceN, one a triangle
    std::vector<std::array<Uv, 3>> uv;                  // of each triangle's corners in its face
    // Of CAD edge n at n, as Layout::edges; empty for edges of other faces and degenerated ones.
    // Edges inside solids have points of their own, which belong to no triangle.
    std::vector<std::vector<std::int32_t>> edges;
    std::vector<std::vector<double>> parameters; // of these points in the edge's curve
    // Point of SkinOptions::fixed that each point is, or -1.
    std::vector<std::int32_t> source;
};

struct SkinOptions {
    double size = 0;       // longest edge; 0: a sixth of the shape's diagonal
    double angle = 0.45;   // turn of the surface along an edge, radians; small features get twice
    double grading = 0.7;  // growth of the wanted length with distance
    double stretch = 2.5;  // how much longer edges may be along than across the curvature
    bool proximity = true; // finer where faces are near each other
    // Edges that are laid out here keep exactly these points.
    const Layout *fixed = nullptr;
    // The length of edges within radius of a place is at most size.
    struct Limit {
        Vec3 place;
        double radius;
        double size;
    };
    std::vector<Limit> limits;
};

// Triangles over the faces (1-based). Every edge of theirs that is not degenerated is a chain of
// triangle edges, with three or more if closed; every point is on its entity; no two points are
// joined by two curves, and no triangle has two edges in one smooth CAD edge. Starts from
// OpenCASCADE's triangulation and splits, collapses, flips and smooths by lengths in the metric of
// the surface's curvature (Botsch and Kobbelt, A remeshing approach to multiresolution modeling,
// SGP 2004); refines where the area of a face is more than 8 % off or the volume of a solid 3.5 %,
// of which points between, on the CAD, leave a quarter, and where triangles of one solid cross.
class SkinBuilder {
public:
    // Raises GeometryError that names faces which OpenCASCADE cannot triangulate, Cancelled. The
    // shape must outlive this.
    SkinBuilder(const CadShape &shape, std::span<const int> faces, SkinOptions options,
                const Progress &progress = {});
    ~SkinBuilder();
    SkinBuilder(const SkinBuilder &) = delete;
    SkinBuilder &operator=(const SkinBuilder &) = delete;

    [[nodiscard]] Skin skin() const;
    // Further limits; the triangles elsewhere stay much as they are. Raises Cancelled.
    void refine(std::span<const SkinOptions::Limit> limits, const Progress &progress = {});

private:
    void passes(int count, const Progress &progress, double from, double to);
    void finish(const Progress &progress);
    bool find_turns();

    const CadShape &shape_;
    std::vector<int> faces_;
    SkinOptions options_;
    std::unique_ptr<SkinMesh> mesh_;
    std::vector<double> bounds_;          // upper ones of the lengths at the mesh's points
    std::vector<double> areas_, volumes_; // of the CAD's faces and solids, 0: not asked for yet
};

// The skin that a SkinBuilder starts with.
Skin make_skin(const CadShape &shape, std::span<const int> faces, const SkinOptions &options = {},
               const Progress &progress = {});

} // namespace nmgs::cad
