// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs_cad/face_projection.h"

#include "nmgs/support/vec3.h"
#include "nmgs_cad/occt_vec.h"

#include <BRepTools.hxx>
#include <BRep_Tool.hxx>
#include <Geom_Surface.hxx>
#include <Precision.hxx>
#include <ShapeAnalysis_Surface.hxx>
#include <gp_Cone.hxx>
#include <gp_Cylinder.hxx>
#include <gp_Pln.hxx>
#include <gp_Sphere.hxx>
#include <gp_Torus.hxx>

#include <algorithm>
#include <cmath>
#include <limits>

namespace nmgs::cad {
namespace {

// Its two ends meet but for a gap that is small against the surface, which OpenCASCADE does not
// take for closed: a seam joins them all the same.
bool nearly_closed(const GeomAdaptor_Surface &surface, std::size_t along,
                   const std::array<double, 2> &low, const std::array<double, 2> &high) {
    for (const double x : {low[0], low[1], high[0], high[1]}) {
        if (Precision::IsInfinite(x)) {
            return false;
        }
    }
    constexpr double part = 1e-3;
    constexpr int samples = 8;
    Box box;
    double gap = 0;
    for (int j = 0; j <= samples; ++j) {
        std::array<Vec3, 2> ends{};
        for (int i = 0; i <= samples; ++i) {
            std::array<double, 2> x{};
            x[along] = low[along] + (high[along] - low[along]) * i / samples;
            x[1 - along] = low[1 - along] + (high[1 - along] - low[1 - along]) * j / samples;
            const Vec3 p = vec(surface.Value(x[0], x[1]).XYZ());
            box.add(p);
            if (i == 0 || i == samples) {
                ends[i == 0 ? 0 : 1] = p;
            }
        }
        gap = std::max(gap, distance(ends[0], ends[1]));
    }
    return gap < part * box.diagonal();
}

} // namespace

FaceProjection::FaceProjection(const TopoDS_Face &face)
    : geometry_(BRep_Tool::Surface(face)), surface_(geometry_),
      reversed_(face.Orientation() == TopAbs_REVERSED) {
    std::array<double, 2> low{surface_.FirstUParameter(), surface_.FirstVParameter()};
    std::array<double, 2> high{surface_.LastUParameter(), surface_.LastVParameter()};
    BRepTools::UVBounds(face, face_low_[0], face_high_[0], face_low_[1], face_high_[1]);
    const std::array<bool, 2> closed{
        surface_.IsUPeriodic() || surface_.IsUClosed() || nearly_closed(surface_, 0, low, high),
        surface_.IsVPeriodic() || surface_.IsVClosed() || nearly_closed(surface_, 1, low, high)};
    for (std::size_t d = 0; d < 2; ++d) {
        if (!(face_low_[d] < face_high_[d])) {
            face_low_[d] = std::max(low[d], -1e6);
            face_high_[d] = std::min(high[d], 1e6);
        }
        const bool periodic = d == 0 ? surface_.IsUPeriodic() : surface_.IsVPeriodic();
        if (periodic) {
            period_[d] = d == 0 ? surface_.UPeriod() : surface_.VPeriod();
        } else if (closed[d] && !Precision::IsInfinite(low[d]) && !Precision::IsInfinite(high[d])) {
            period_[d] = high[d] - low[d];
        }
        const double extra = 0.05 * (face_high_[d] - face_low_[d]);
        // A face that is well short of going round does not go on at the other side of the seam: of
        // a blade it is one side.
        constexpr double part = 0.85;
        if (face_high_[d] - face_low_[d] < part * period_[d]) {
            if (periodic) {
                low[d] = face_low_[d] - extra;
                high[d] = face_high_[d] + extra;
            }
            period_[d] = 0;
        }
        low_[d] = period_[d] > 0 ? low[d] : std::max(low[d], face_low_[d] - extra);
        high_[d] = period_[d] > 0 ? high[d] : std::min(high[d], face_high_[d] + extra);
    }
    Box box;
    for (int j = 0; j <= 4; ++j) {
        for (int i = 0; i <= 4; ++i) {
            box.add(value({face_low_[0] + (face_high_[0] - face_low_[0]) * i / 4,
                           face_low_[1] + (face_high_[1] - face_low_[1]) * j / 4}));
        }
    }
    scale_ = box.diagonal();

    elementary_ = true;
    switch (surface_.GetType()) {
    case GeomAbs_Plane:
        origin_ = vec(surface_.Plane().Location().XYZ());
        axis_ = vec(surface_.Plane().Axis().Direction().XYZ());
        break;
    case GeomAbs_Cylinder:
        origin_ = vec(surface_.Cylinder().Location().XYZ());
        axis_ = vec(surface_.Cylinder().Axis().Direction().XYZ());
        radius_ = surface_.Cylinder().Radius();
        break;
    case GeomAbs_Cone:
        origin_ = vec(surface_.Cone().Location().XYZ());
        axis_ = vec(surface_.Cone().Axis().Direction().XYZ());
        radius_ = surface_.Cone().RefRadius();
        sine_ = std::sin(surface_.Cone().SemiAngle());
        cosine_ = std::cos(surface_.Cone().SemiAngle());
        side_ = radius_ + 0.5 * (face_low_[1] + face_high_[1]) * sine_ >= 0 ? 1 : -1;
        break;
    case GeomAbs_Sphere:
        origin_ = vec(surface_.Sphere().Location().XYZ());
        axis_ = vec(surface_.Sphere().Position().Axis().Direction().XYZ());
        radius_ = surface_.Sphere().Radius();
        break;
    case GeomAbs_Torus:
        origin_ = vec(surface_.Torus().Location().XYZ());
        axis_ = vec(surface_.Torus().Axis().Direction().XYZ());
        radius_ = surface_.Torus().MajorRadius();
        minor_ = surface_.Torus().MinorRadius();
        // Where the tube reaches the axis the surface crosses itself.
        elementary_ = minor_ < radius_;
        break;
    default:
        elementary_ = false;
    }
    if (elementary_) {
        gp_Pnt p;
        gp_Vec u;
        gp_Vec v;
        surface_.D1(face_low_[0] + 0.47 * (face_high_[0] - face_low_[0]),
                    face_low_[1] + 0.47 * (face_high_[1] - face_low_[1]), p, u, v);
        outward_ = dot(closed_form_normal(vec(p.XYZ())), vec(u.Crossed(v).XYZ())) < 0 ? -1 : 1;
        if (reversed_) {
            outward_ = -outward_;
        }
    }
}

Vec3 FaceProjection::closed_form(Vec3 p) const {
    const Vec3 from = p - origin_;
    const double h = dot(from, axis_);
    const Vec3 across = from - h * axis_;
    const double rho = norm(across);
    switch (surface_.GetType()) {
    case GeomAbs_Plane:
        return p - h * axis_;
    case GeomAbs_Cylinder:
        return origin_ + h * axis_ + (radius_ / rho) * across;
    case GeomAbs_Cone: {
        // Along the line through (radius, 0) in the half-plane of the point.
        const double r = side_ * rho;
        double t = (r - radius_) * sine_ + h * cosine_;
        if (side_ * (radius_ + t * sine_) < 0) {
            t = -radius_ / sine_; // the apex is nearest
        }
        return origin_ + (t * cosine_) * axis_ + ((radius_ + t * sine_) * side_ / rho) * across;
    }
    case GeomAbs_Sphere:
        return origin_ + radius_ * unit(from);
    default: {
        const Vec3 centre = origin_ + (radius_ / rho) * across;
        return centre + minor_ * unit(p - centre);
    }
    }
}

Vec3 FaceProjection::closed_form_normal(Vec3 p) const {
    const Vec3 from = p - origin_;
    const Vec3 across = from - dot(from, axis_) * axis_;
    switch (surface_.GetType()) {
    case GeomAbs_Plane:
        return axis_;
    case GeomAbs_Cylinder:
        return unit(across);
    case GeomAbs_Cone:
        return cosine_ * unit(across) - (side_ * sine_) * axis_;
    case GeomAbs_Sphere:
        return unit(from);
    default:
        return unit(p - (origin_ + radius_ * unit(across)));
    }
}

FaceProjection::Uv FaceProjection::kept(Uv at) const {
    std::array<double, 2> x{at.u, at.v};
    for (std::size_t d = 0; d < 2; ++d) {
        if (period_[d] > 0) {
            x[d] -= period_[d] * std::floor((x[d] - low_[d]) / period_[d]);
        } else {
            x[d] = std::clamp(x[d], low_[d], high_[d]);
        }
    }
    return {x[0], x[1]};
}

Vec3 FaceProjection::value(Uv at) const {
    const Uv inside = kept(at);
    return vec(surface_.Value(inside.u, inside.v).XYZ());
}

// Newton's method on the gradient of the squared distance; where its matrix is not positive
// definite, that of Gauss and Newton. A step that leads farther away is halved. Parameters with a
// period run on past its end.
FaceProjection::Result FaceProjection::newton(Vec3 p, Uv from) const {
    constexpr int most_steps = 30;
    Result result;
    std::array<double, 2> x{from.u, from.v};
    for (std::size_t d = 0; d < 2; ++d) {
        if (!(period_[d] > 0)) {
            x[d] = std::clamp(x[d], low_[d], high_[d]);
        }
    }
    gp_Pnt s;
    gp_Vec su;
    gp_Vec sv;
    gp_Vec suu;
    gp_Vec svv;
    gp_Vec suv;
    const auto evaluate = [&] {
        const Uv at = kept({x[0], x[1]});
        surface_.D2(at.u, at.v, s, su, sv, suu, svv, suv);
    };
    evaluate();
    Vec3 off = vec(s.XYZ()) - p;
    for (int step = 0; step < most_steps; ++step) {
        const Vec3 du = vec(su.XYZ());
        const Vec3 dv = vec(sv.XYZ());
        std::array<double, 2> g{dot(off, du), dot(off, dv)};
        const double guu = norm2(du);
        const double gvv = norm2(dv);
        const double guv = dot(du, dv);
        std::array<bool, 2> fixed{};
        result.at_pole = false;
        for (std::size_t d = 0; d < 2; ++d) {
            // At a bound that holds it, or at a pole, a parameter stays.
            const bool stuck = !(period_[d] > 0) &&
                               ((x[d] <= low_[d] && g[d] > 0) || (x[d] >= high_[d] && g[d] < 0));
            const double length2 =
                (d == 0 ? guu : gvv) * (high_[d] - low_[d]) * (high_[d] - low_[d]);
            const bool pole = length2 < 1e-16 * scale_ * scale_;
            result.at_pole = result.at_pole || pole;
            fixed[d] = stuck || pole;
        }
        double huu = guu + dot(off, vec(suu.XYZ()));
        double hvv = gvv + dot(off, vec(svv.XYZ()));
        double huv = guv + dot(off, vec(suv.XYZ()));
        const bool convex = huu > 1e-3 * guu && hvv > 1e-3 * gvv &&
                            huu * hvv - huv * huv > 1e-3 * (guu * gvv - guv * guv);
        if (!convex) {
            huu = guu * (1 + 1e-9);
            hvv = gvv * (1 + 1e-9);
            huv = guv;
        }
        std::array<double, 2> move{0, 0};
        if (!fixed[0] && !fixed[1]) {
            const double det = huu * hvv - huv * huv;
            if (det > 1e-14 * huu * hvv) {
                move = {(-g[0] * hvv + g[1] * huv) / det, (-g[1] * huu + g[0] * huv) / det};
            } else {
                move = {-g[0] / huu / 2, -g[1] / hvv / 2};
            }
        } else if (!fixed[0]) {
            move[0] = -g[0] / huu;
        } else if (!fixed[1]) {
            move[1] = -g[1] / hvv;
        }
        const double reach2 = norm2(move[0] * du + move[1] * dv);
        const std::array<double, 2> start = x;
        const double before = norm2(off);
        double factor = 1;
        for (int halving = 0; halving < 12; ++halving, factor *= 0.5) {
            for (std::size_t d = 0; d < 2; ++d) {
                x[d] = start[d] + factor * move[d];
                if (!(period_[d] > 0)) {
                    x[d] = std::clamp(x[d], low_[d], high_[d]);
                }
            }
            // A short step needs no test, and the last none of the derivatives.
            if (reach2 <= 1e-12 * scale_ * scale_) {
                const Uv at = kept({x[0], x[1]});
                surface_.D0(at.u, at.v, s);
                off = vec(s.XYZ()) - p;
                break;
            }
            evaluate();
            off = vec(s.XYZ()) - p;
            if (norm2(off) <= before * (1 + 1e-12) + 1e-24 * scale_ * scale_) {
                break;
            }
        }
        if (reach2 <= 1e-12 * scale_ * scale_) {
            // At a pole the other parameter may be wrong: all its values are one point.
            result.converged = !result.at_pole || norm2(off) <= 1e-18 * scale_ * scale_;
            break;
        }
    }
    result.at = {x[0], x[1]};
    result.point = vec(s.XYZ());
    result.distance2 = norm2(off);
    return result;
}

// Parameters of samples along one parameter, both ends included: as three lines of the face ask
// for, nearer to each other where one of them turns.
std::vector<double> FaceProjection::places(std::size_t along, int knots) const {
    constexpr int steps = 256;
    constexpr double turn = 0.15; // in radians, from one sample to the next
    constexpr int most = 512;
    std::vector<double> turned(steps, 0);
    std::vector<double> length(steps, 0);
    const auto parameter = [&](double i) {
        return face_low_[along] + (face_high_[along] - face_low_[along]) * i / steps;
    };
    for (const double across : {0.1, 0.5, 0.9}) {
        std::array<double, 2> x{};
        x[1 - along] =
            face_low_[1 - along] + across * (face_high_[1 - along] - face_low_[1 - along]);
        Vec3 last{};
        Vec3 chord{};
        for (int i = 0; i <= steps; ++i) {
            x[along] = parameter(i);
            const Vec3 p = value({x[0], x[1]});
            const Vec3 next = p - last;
            if (i > 0) {
                const auto k = static_cast<std::size_t>(i) - 1;
                length[k] = std::max(length[k], norm(next));
                if (i > 1 && norm2(next) > 0 && norm2(chord) > 0) {
                    turned[k] = std::max(turned[k], angle_between(chord, next));
                    turned[k - 1] = std::max(turned[k - 1], turned[k]);
                }
            }
            chord = next;
            last = p;
        }
    }
    double way = 0;
    double turns = 0;
    for (std::size_t k = 0; k < steps; ++k) {
        way += length[k];
        turns += turned[k] / turn;
    }
    const int even = std::clamp(knots, 12, 48);
    const int count =
        std::min(static_cast<int>(std::max<double>(even, std::min<double>(turns, most))), most);
    // Half of the samples by length, half by turn, if there is any.
    std::vector<double> weight(steps, 0);
    double all = 0;
    for (std::size_t k = 0; k < steps; ++k) {
        weight[k] = (way > 0 ? length[k] / way : 1.0 / steps) +
                    (turns > 1 ? turned[k] / turn / turns : 0.0);
        all += weight[k];
    }
    std::vector<double> result{parameter(0)};
    double sum = 0;
    for (std::size_t k = 0; k < steps; ++k) {
        while (result.size() < static_cast<std::size_t>(count) &&
               sum + weight[k] >= all * static_cast<double>(result.size()) / count) {
            const double goal = all * static_cast<double>(result.size()) / count;
            result.push_back(parameter(static_cast<double>(k) + (goal - sum) / weight[k]));
        }
        sum += weight[k];
    }
    result.push_back(face_high_[along]); // a pole's own parameter, not one beside it
    return result;
}

void FaceProjection::make_samples() {
    places_ = {places(0, 3 * surface_.NbUIntervals(GeomAbs_C2)),
               places(1, 3 * surface_.NbVIntervals(GeomAbs_C2))};
    constexpr std::size_t most = 4000;
    while (places_[0].size() * places_[1].size() > most) {
        // Every other one, the last kept.
        auto &larger = places_[0].size() > places_[1].size() ? places_[0] : places_[1];
        std::vector<double> fewer;
        for (std::size_t i = 0; i + 1 < larger.size(); i += 2) {
            fewer.push_back(larger[i]);
        }
        fewer.push_back(larger.back());
        larger = std::move(fewer);
    }
    for (const double v : places_[1]) {
        for (const double u : places_[0]) {
            samples_.push_back(value({u, v}));
        }
    }
}

// Without a guess: from the nearest of samples spread over the face's parameters.
FaceProjection::Result FaceProjection::locate(Vec3 p) {
    if (samples_.empty()) {
        make_samples();
    }
    const int columns = static_cast<int>(places_[0].size());
    const int rows = static_cast<int>(places_[1].size());
    std::vector<double> d2(samples_.size());
    for (std::size_t i = 0; i < samples_.size(); ++i) {
        d2[i] = norm2(samples_[i] - p);
    }
    struct Start {
        double d2;
        int at;
    };
    std::vector<Start> starts;
    for (int j = 0; j < rows; ++j) {
        for (int i = 0; i < columns; ++i) {
            const int at = j * columns + i;
            const double mine = d2[static_cast<std::size_t>(at)];
            bool least = true;
            for (int n = 0; n < 9 && least; ++n) {
                const int x = i + n % 3 - 1;
                const int y = j + n / 3 - 1;
                const int beside = y * columns + x;
                least = x < 0 || y < 0 || x >= columns || y >= rows ||
                        mine <= d2[static_cast<std::size_t>(beside)];
            }
            if (least) {
                starts.push_back({mine, at});
            }
        }
    }
    constexpr std::size_t most_starts = 4;
    std::sort(starts.begin(), starts.end(), [](const Start &a, const Start &b) {
        return a.d2 != b.d2 ? a.d2 < b.d2 : a.at < b.at;
    });
    starts.resize(std::min(starts.size(), most_starts));
    Result best;
    best.distance2 = std::numeric_limits<double>::infinity();
    for (const Start &start : starts) {
        const auto i = static_cast<std::size_t>(start.at % columns);
        const auto j = static_cast<std::size_t>(start.at / columns);
        const Result found = newton(p, {places_[0][i], places_[1][j]});
        // A point that is found once more, from the other side of a seam, changes nothing.
        if (found.distance2 < best.distance2 - 1e-20 * scale_ * scale_) {
            best = found;
        }
        if (best.converged && best.distance2 < 1e-18 * scale_ * scale_) {
            break; // on the surface
        }
    }
    if (!best.converged) {
        ShapeAnalysis_Surface analysis(geometry_);
        const gp_Pnt2d uv = analysis.ValueOfUV({p.x, p.y, p.z}, Precision::Confusion());
        const Uv at{uv.X(), uv.Y()};
        const Vec3 q = value(at);
        if (norm2(q - p) < best.distance2) {
            best = {at, q, norm2(q - p), true, false};
        }
    }
    return best;
}

FaceProjection::Uv FaceProjection::find(Vec3 p, Vec3 &point) {
    constexpr double far = 0.1; // of the face's size
    Result result;
    if (!keep_ && guesses_ > 0 && distance(p, asked_) > far * scale_) {
        guesses_ = 0;
    }
    asked_ = p;
    if (guesses_ > 0) {
        Uv guess = last_;
        if (guesses_ > 1) {
            // The row goes on as it came.
            guess = {2 * last_.u - before_.u, 2 * last_.v - before_.v};
            const Vec3 there = value(guess);
            if (norm2(there - p) > norm2(value(last_) - p)) {
                guess = last_;
            }
        }
        result = newton(p, guess);
        const double limit = far * far * far * scale_;
        if (!keep_ && result.distance2 > limit * limit) {
            result.converged = false; // maybe the wrong sheet
        }
    }
    if (!result.converged) {
        result = locate(p);
        guesses_ = 0;
    }
    before_ = last_;
    last_ = result.at;
    guesses_ = result.at_pole ? 0 : std::min(guesses_ + 1, 2);
    point = result.point;
    return result.at;
}

void FaceProjection::start(Vec3 p) {
    forget();
    if (!elementary_) {
        Vec3 q;
        find(p, q);
        keep_ = guesses_ > 0;
    }
}

Vec3 FaceProjection::nearest(Vec3 p) {
    if (elementary_) {
        const Vec3 q = closed_form(p);
        if (is_finite(q)) {
            return q;
        }
    }
    // Also from a point on an axis, which is equally far from many.
    Vec3 q;
    find(p, q);
    return q;
}

Vec3 FaceProjection::normal(Vec3 p) {
    if (elementary_) {
        const Vec3 n = closed_form_normal(p);
        if (norm2(n) > 0.5) {
            return outward_ * n;
        }
    }
    Vec3 q;
    Uv at = find(p, q);
    const Uv middle{0.5 * (face_low_[0] + face_high_[0]), 0.5 * (face_low_[1] + face_high_[1])};
    for (const double towards : {0.0, 1e-4, 1e-2}) {
        const Uv beside =
            kept({at.u + towards * (middle.u - at.u), at.v + towards * (middle.v - at.v)});
        gp_Pnt s;
        gp_Vec u;
        gp_Vec v;
        surface_.D1(beside.u, beside.v, s, u, v);
        const Vec3 n = cross(vec(u.XYZ()), vec(v.XYZ()));
        const double size = norm(n);
        const double least = 1e-9 * scale_;
        const bool pole = u.Magnitude() * (face_high_[0] - face_low_[0]) < least ||
                          v.Magnitude() * (face_high_[1] - face_low_[1]) < least;
        if (!pole && size > 1e-9 * u.Magnitude() * v.Magnitude() && size > 0) {
            return ((reversed_ ? -1 : 1) / size) * n;
        }
    }
    return {0, 0, 0};
}

} // namespace nmgs::cad
