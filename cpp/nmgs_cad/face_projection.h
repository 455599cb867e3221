// SPDX-License-Identifier: LGPL-2.1-or-later
// Nearest points of a CAD face's surface. Planes, cylinders, cones, spheres and tori in closed
// form; other surfaces by Newton's method on their parameters.
#pragma once

#include "nmgs/support/vec3.h"

#include <GeomAdaptor_Surface.hxx>
#include <TopoDS_Face.hxx>

#include <array>
#include <vector>

namespace nmgs::cad {

// Remembers the last answers as the guess of the next: ask for points in rows. From a point that
// start() or set_guess() was given the answer moves over the surface without a jump, not over a
// seam's gap in the parameters and not to another sheet that is near in space; otherwise a point
// far from the last is looked for anew. Not for two threads at a time; see CadGeometry for one a
// thread.
class FaceProjection {
public:
    explicit FaceProjection(const TopoDS_Face &face);

    struct Guess {
        int count = 0;
        double u = 0, v = 0;
    };
    [[nodiscard]] Guess guess() const { return {guesses_, last_.u, last_.v}; }
    // Goes on from an earlier answer.
    void set_guess(Guess guess) {
        guesses_ = guess.count > 0 ? 1 : 0;
        keep_ = guesses_ > 0;
        last_ = {guess.u, guess.v};
    }

    // Nearest point of the surface that carries the face; without a guess, of the part of it that
    // the face's parameters cover.
    Vec3 nearest(Vec3 p);
    // The next call starts without a guess.
    void forget() {
        guesses_ = 0;
        keep_ = false;
    }
    // Takes a point of the surface that the next one is near to as the guess.
    void start(Vec3 p);
    // Unit normal at the point of the surface nearest to p, on the side to which the oriented
    // face's normal points. At a pole, that of a place beside it; zero where there is none.
    Vec3 normal(Vec3 p);

private:
    struct Uv {
        double u = 0, v = 0;
    };
    struct Result {
        Uv at;
        Vec3 point{};
        double distance2 = 0;
        bool converged = false;
        bool at_pole = false;
    };
    [[nodiscard]] Vec3 closed_form(Vec3 p) const;
    [[nodiscard]] Vec3 closed_form_normal(Vec3 p) const;
    [[nodiscard]] Uv kept(Uv at) const; // within the bounds, or the period
    [[nodiscard]] Vec3 value(Uv at) const;
    [[nodiscard]] Result newton(Vec3 p, Uv from) const;
    [[nodiscard]] Result locate(Vec3 p);
    Uv find(Vec3 p, Vec3 &point);
    [[nodiscard]] std::vector<double> places(std::size_t along, int knots) const;
    void make_samples();

    Handle(Geom_Surface) geometry_;
    GeomAdaptor_Surface surface_;
    bool elementary_;
    // Of an elementary surface: origin, axis, radii, half-angle's sine and cosine.
    Vec3 origin_{}, axis_{};
    double radius_ = 0, minor_ = 0, sine_ = 0, cosine_ = 1, side_ = 1;
    double outward_ = 1; // sign from the closed form's normal to the face's

    std::array<double, 2> low_{}, high_{};           // where the parameters may go
    std::array<double, 2> period_{};                 // 0: none
    std::array<double, 2> face_low_{}, face_high_{}; // what the face covers
    double scale_ = 0;                               // of the face
    bool reversed_;
    int guesses_ = 0;
    bool keep_ = false; // to the sheet of the guess, which the caller has chosen
    Vec3 asked_{};
    Uv last_, before_;
    std::array<std::vector<double>, 2> places_; // parameters of the samples
    std::vector<Vec3> samples_;
};

} // namespace nmgs::cad
