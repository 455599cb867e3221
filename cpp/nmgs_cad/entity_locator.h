// SPDX-License-Identifier: LGPL-2.1-or-later
// Which vertex, edge or face of a solid a point lies on.
#pragma once

#include "nmgs/support/vec3.h"
#include "nmgs_cad/cad_blocks.h"
#include "nmgs_cad/cad_shape.h"

#include <memory>
#include <vector>

namespace nmgs::cad {

// Diagonal of a box round the shape; not the least one.
double extent_of(const TopoDS_Shape &shape);

class EntityLocator {
public:
    // tolerance: how far from an entity a point may be, beside the entity's own tolerance.
    EntityLocator(const CadShape &shape, int solid, double tolerance);
    ~EntityLocator();
    EntityLocator(const EntityLocator &) = delete;
    EntityLocator &operator=(const EntityLocator &) = delete;

    // The entity of least dimension, of those with at least the given one, that p lies on, and
    // among equals the nearest; the solid where there is none.
    [[nodiscard]] CadEntity at(Vec3 p, int least_dimension = 0) const;
    // Whether p lies on CAD edge or face n of the solid.
    [[nodiscard]] bool on_edge(Vec3 p, int n) const;
    [[nodiscard]] bool on_face(Vec3 p, int n) const;

    // Numbers of the solid's entities, ascending; edges without the degenerated ones.
    [[nodiscard]] const std::vector<int> &vertices() const { return vertices_; }
    [[nodiscard]] const std::vector<int> &edges() const { return edges_; }
    [[nodiscard]] const std::vector<int> &faces() const { return faces_; }

private:
    struct Curves;
    struct Surfaces;
    double distance_to_edge(std::size_t at, Vec3 p) const;
    double distance_to_face(std::size_t at, Vec3 p) const;

    int solid_;
    std::vector<int> vertices_, edges_, faces_;
    std::vector<Vec3> places_;
    std::vector<double> vertex_tolerance_;
    std::unique_ptr<Curves> curves_;
    std::unique_ptr<Surfaces> surfaces_;
};

} // namespace nmgs::cad
