// SPDX-License-Identifier: LGPL-2.1-or-later
// Polynomials over a reference element in Bernstein form: the coefficients bound the polynomial
// from both sides, and halving the element tightens the bounds (Johnen, Remacle, Geuzaine,
// Geometrical validity of curvilinear finite elements, J. Comput. Phys. 233, 2013).
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace nmgs {

// A basis of polynomials over one kind of reference element. On squares and cubes it is a tensor
// product of `directions` one-dimensional bases of `count` polynomials; on simplices one basis.
class BernsteinBasis {
public:
    // Over [0, 1]^directions, of the degree in each direction.
    static BernsteinBasis box(std::size_t directions, std::size_t degree);
    // Over the triangle (dimension 2) or tetrahedron (3), of the total degree.
    static BernsteinBasis simplex(std::size_t dimension, std::size_t degree);

    [[nodiscard]] std::size_t size() const { return samples_.size(); }
    // Where values are to be given: natural coordinates in [0, 1]; r, s, t of a simplex.
    [[nodiscard]] const std::vector<std::array<double, 3>> &samples() const { return samples_; }
    // Coefficients that are values of the polynomial at the element's corners.
    [[nodiscard]] const std::vector<std::size_t> &corners() const { return corners_; }
    // Number of parts into which halving splits the element: 2 of a box, 4 or 8 of a simplex.
    [[nodiscard]] std::size_t parts() const { return halves_.size(); }

    // Values at the samples -> coefficients, in place.
    void to_coefficients(std::span<double> values) const;
    // Coefficients over a part, from those over the whole. A box is halved in one direction a level
    // of depth, in turn: that takes fewer steps than halving it in all at once.
    void restrict_to(std::size_t part, std::size_t depth, std::span<const double> whole,
                     std::span<double> out) const;

private:
    using Matrix = std::vector<double>; // count x count, row by row

    // The same matrix in both orders: lines of neighbours are multiplied column by column.
    struct Operator {
        Matrix rows, columns;
    };

    [[nodiscard]] Operator operator_of(Matrix rows) const;
    void apply(const Operator &matrix, std::size_t direction, std::span<double> values) const;
    void finish(const Matrix &values_of_basis, const std::vector<Matrix> &values_in_halves);

    std::size_t directions_ = 1;
    std::size_t count_ = 0;
    std::vector<std::array<double, 3>> samples_;
    std::vector<std::size_t> corners_;
    Operator inverse_;
    std::vector<Operator> halves_;
};

} // namespace nmgs
