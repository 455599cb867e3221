// SPDX-License-Identifier: LGPL-2.1-or-later
// The mesh that improve_tets() works on, and the steps that it takes; for its own files only.
#pragma once

#include "nmgs/quality/tet_improvement.h"
#include "nmgs/support/at.h"

#include <algorithm>
#include <unordered_map>
#include <utility>

namespace nmgs {

class TetImprover {
public:
    using Corners = std::array<std::int32_t, 4>;
    using Face = std::array<std::int32_t, 3>;

    TetImprover(TetMesh &mesh, const TetImprovementOptions &options);
    double run(const Progress &progress);

private:
    // Of the four hexahedra; stops measuring at what is no better than `floor`.
    double quality(const Corners &p, double floor = -2);
    // The same with one point, or a new one for the corner -1, elsewhere.
    double quality_at(const Corners &p, std::int32_t moved, Vec3 place, double floor);
    [[nodiscard]] bool alive(std::int32_t t) const { return mesh_.tets[at(t)].part >= 0; }
    [[nodiscard]] bool kept(std::int32_t a, std::int32_t b) const;
    [[nodiscard]] bool kept(const Face &f) const;
    // The tetrahedron on the other side of a face, or -1 where the face stays.
    [[nodiscard]] std::int32_t beyond(std::int32_t tet, const Face &f) const;
    [[nodiscard]] bool around(std::int32_t a, std::int32_t b,
                              std::vector<std::int32_t> &tets) const;
    void replace(const std::vector<std::int32_t> &old, const std::vector<Corners> &fresh);
    // Each takes a step where that makes the worst of what it changes better, and says whether.
    bool smooth(std::int32_t point, int steps);
    bool remove_edge(std::int32_t tet, std::size_t edge);
    bool flip_face(std::int32_t tet, std::size_t opposite);
    bool fill_cavity(std::vector<std::int32_t> cavity);
    Vec3 best_place(const std::vector<Face> &faces, Vec3 start, double &worth);
    void mend(std::int32_t tet, double good);

    static Face sorted(Face f) {
        std::sort(f.begin(), f.end());
        return f;
    }
    static std::uint64_t key_of(std::int32_t a, std::int32_t b) {
        return static_cast<std::uint64_t>(std::min(a, b)) << 32U |
               static_cast<std::uint64_t>(std::max(a, b));
    }

    TetMesh &mesh_;
    TetImprovementOptions options_;
    std::vector<std::vector<std::int32_t>> of_; // tetrahedra of each point
    std::vector<double> quality_;
    std::vector<char> on_face_; // points of faces that stay
    std::unordered_map<std::uint64_t, Vec3> middles_;
    std::vector<std::vector<std::pair<Face, Vec3>>> centres_; // by least corner
    long work_ = 0;
};

} // namespace nmgs
