// SPDX-License-Identifier: LGPL-2.1-or-later
// Local changes of the connectivity of quads over a face: what clean-up and repair are made of.
// After P. Kinney, CleanUp: improving quadrilateral finite element meshes, 1997.
#pragma once

#include "nmgs_cad/face_mesh.h"

#include <array>
#include <cstdint>
#include <map>
#include <set>
#include <vector>

namespace nmgs::cad {

struct QuadStep {
    enum class Kind { rotate, close, open } kind = Kind::rotate;
    double gain = 0; // in the price of the nodes' numbers of quads; less than 0 is better
    std::array<std::int32_t, 2> quads{-1, -1}; // rotate: both; close: the first
    std::array<std::int32_t, 6> ring{};        // rotate: the hexagon, new edge from 0 to 3
    std::int32_t node = -1;                    // close: keeps; open: divided
    std::int32_t other = -1;                   // close: goes
    std::vector<std::int32_t> fan;             // open: quads that the new node takes
    std::int32_t a = -1, b = -1;               // open: ends of the new quad's other diagonal
};

// The quads of a mesh with what is needed to change them. After apply() of steps that touch
// different nodes, commit() drops the quads that have gone and makes the tables anew.
struct QuadSteps {
    using Quad = std::array<std::int32_t, 4>;
    FaceMesh &mesh;
    const FaceSurface &surface;
    std::vector<std::vector<std::int32_t>> quads_at;
    std::map<std::array<std::int32_t, 2>, std::int32_t> of_edge; // quad on the left of a -> b

    // Edges that stay, ends ascending, and the nodes at them.
    std::set<std::array<std::int32_t, 2>> kept;
    std::set<std::int32_t> kept_nodes;

    QuadSteps(FaceMesh &m, const FaceSurface &s,
              const std::set<std::array<std::int32_t, 2>> &edges_kept);
    void index();
    void commit();

    // Two quads share out their hexagon anew: the edge from a to b, a quad's on the left.
    void rotations(std::int32_t a, std::int32_t b, std::vector<QuadStep> &steps) const;
    // A quad goes, two opposite nodes of it become one.
    void closings(std::int32_t quad, std::vector<QuadStep> &steps) const;
    // A node becomes two with a new quad between them.
    void openings(std::int32_t node, std::vector<QuadStep> &steps) const;
    void apply(const QuadStep &step);
    // The nodes whose quads a step changes.
    [[nodiscard]] std::vector<std::int32_t> touched(const QuadStep &step) const;
    // Quads at the node in their order round it, counter-clockwise; empty when they are no fan.
    [[nodiscard]] std::vector<std::int32_t> fan(std::int32_t n) const;

    [[nodiscard]] const Quad &quad(std::int32_t q) const {
        return mesh.quads[static_cast<std::size_t>(q)];
    }
    [[nodiscard]] int valence(std::int32_t n) const {
        return static_cast<int>(quads_at[static_cast<std::size_t>(n)].size());
    }
    [[nodiscard]] bool joined(std::int32_t a, std::int32_t b) const {
        return of_edge.contains({a, b}) || of_edge.contains({b, a});
    }

private:
    [[nodiscard]] bool is_kept(std::int32_t a, std::int32_t b) const {
        return kept.contains({a < b ? a : b, a < b ? b : a});
    }
    // How far a number of quads is from what is wanted at the node.
    [[nodiscard]] double price(std::int32_t n, int count) const;
    [[nodiscard]] double change(std::int32_t n, int by) const;
    [[nodiscard]] std::vector<std::int32_t> neighbours(std::int32_t n) const;
};

} // namespace nmgs::cad
