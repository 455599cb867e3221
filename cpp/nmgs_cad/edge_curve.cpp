// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs_cad/edge_curve.h"

#include "nmgs_cad/occt_vec.h"

#include <TColStd_Array1OfReal.hxx>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace nmgs::cad {
namespace {

constexpr double end_accuracy = 1e-9; // of the length

} // namespace

EdgeCurve::EdgeCurve(const TopoDS_Edge &edge)
    : curve_(edge),
      uniform_(curve_.GetType() == GeomAbs_Line || curve_.GetType() == GeomAbs_Circle) {
    const int intervals = std::max(1, curve_.NbIntervals(GeomAbs_CN));
    TColStd_Array1OfReal ends(1, intervals + 1);
    curve_.Intervals(ends, GeomAbs_CN);
    const int pieces = std::clamp(64 / intervals, 4, 32);
    parameters_.push_back(ends(1));
    for (int i = 1; i <= intervals; ++i) {
        for (int k = 1; k <= pieces; ++k) {
            parameters_.push_back(ends(i) + (ends(i + 1) - ends(i)) * k / pieces);
        }
    }
    lengths_.push_back(0);
    for (const double t : parameters_) {
        points_.push_back(point(t));
    }
    for (std::size_t i = 1; i < parameters_.size(); ++i) {
        lengths_.push_back(lengths_.back() + length_between(parameters_[i - 1], parameters_[i]));
    }
    length_ = lengths_.back();
    closed_ = distance(points_.front(), points_.back()) <= end_accuracy * length_;
}

Vec3 EdgeCurve::point(double parameter) const {
    return vec(curve_.Value(parameter).XYZ());
}

double EdgeCurve::speed(double parameter) const {
    gp_Pnt p;
    gp_Vec d;
    curve_.D1(parameter, p, d);
    return d.Magnitude();
}

// Gauss-Legendre with five points; the pieces are short.
double EdgeCurve::length_between(double from, double to) const {
    constexpr std::array<double, 5> at{-0.9061798459386640, -0.5384693101056831, 0,
                                       0.5384693101056831, 0.9061798459386640};
    constexpr std::array<double, 5> weight{0.2369268850561891, 0.4786286704993665,
                                           0.5688888888888889, 0.4786286704993665,
                                           0.2369268850561891};
    const double half = 0.5 * (to - from);
    double sum = 0;
    for (std::size_t i = 0; i < at.size(); ++i) {
        sum += weight[i] * speed(from + half * (1 + at[i]));
    }
    return half * sum;
}

double EdgeCurve::parameter(double fraction) const {
    const double first = parameters_.front();
    const double last = parameters_.back();
    if (closed_ && (fraction < 0 || fraction > 1)) {
        fraction -= std::floor(fraction);
    }
    if (fraction <= 0 || length_ <= 0) {
        return first;
    }
    if (fraction >= 1) {
        return last;
    }
    if (uniform_) {
        return first + fraction * (last - first);
    }
    const double wanted = fraction * length_;
    const auto after = std::upper_bound(lengths_.begin() + 1, lengths_.end() - 1, wanted);
    const auto i = static_cast<std::size_t>(after - lengths_.begin());
    double low = parameters_[i - 1];
    double high = parameters_[i];
    const double start = low;
    const double rest = wanted - lengths_[i - 1];
    const double piece = lengths_[i] - lengths_[i - 1];
    double t = piece > 0 ? low + (high - low) * rest / piece : low;
    // Newton's steps, kept between bounds that close in.
    for (int step = 0; step < 50; ++step) {
        const double off = length_between(start, t) - rest;
        if (std::abs(off) <= 1e-13 * length_) {
            break;
        }
        (off > 0 ? high : low) = t;
        const double v = speed(t);
        double next = v > 0 ? t - off / v : low;
        if (!(next > low && next < high)) {
            next = 0.5 * (low + high);
        }
        if (next == t) {
            break;
        }
        t = next;
    }
    return t;
}

Vec3 EdgeCurve::at(double fraction) const {
    return point(parameter(fraction));
}

Vec3 EdgeCurve::tangent(double fraction) const {
    gp_Pnt p;
    gp_Vec d;
    curve_.D1(parameter(fraction), p, d);
    const double size = d.Magnitude();
    return size > 0 ? (1 / size) * vec(d.XYZ()) : Vec3{0, 0, 0};
}

double EdgeCurve::nearest_parameter(Vec3 p) const {
    // From the nearest ends of pieces, the derivative of the squared distance is brought to zero on
    // the pieces beside them.
    const std::size_t n = points_.size();
    double best = parameters_.front();
    double nearest = std::numeric_limits<double>::infinity();
    std::array<std::pair<double, std::size_t>, 3> starts;
    starts.fill({std::numeric_limits<double>::infinity(), 0});
    for (std::size_t i = 0; i < n; ++i) {
        const double d = norm2(points_[i] - p);
        const bool dip = (i == 0 || d <= norm2(points_[i - 1] - p)) &&
                         (i + 1 == n || d <= norm2(points_[i + 1] - p));
        if (dip && d < starts.back().first) {
            starts.back() = {d, i};
            std::sort(starts.begin(), starts.end());
        }
    }
    for (const auto &[d0, i] : starts) {
        if (!std::isfinite(d0)) {
            continue;
        }
        double low = parameters_[i > 0 ? i - 1 : 0];
        double high = parameters_[std::min(i + 1, n - 1)];
        double t = parameters_[i];
        for (int step = 0; step < 60; ++step) {
            gp_Pnt q;
            gp_Vec d1;
            gp_Vec d2;
            curve_.D2(t, q, d1, d2);
            const Vec3 off = vec(q.XYZ()) - p;
            const double slope = dot(off, vec(d1.XYZ()));
            const double bend = norm2(vec(d1.XYZ())) + dot(off, vec(d2.XYZ()));
            (slope > 0 ? high : low) = t;
            double next = bend > 0 ? t - slope / bend : low;
            if (!(next > low && next < high)) {
                next = 0.5 * (low + high);
            }
            if (std::abs(next - t) * std::sqrt(norm2(vec(d1.XYZ()))) <= 1e-12 * length_) {
                t = next;
                break;
            }
            t = next;
        }
        for (const double candidate : {t, parameters_[i]}) {
            const double d = norm2(point(candidate) - p);
            if (d < nearest) {
                nearest = d;
                best = candidate;
            }
        }
    }
    return best;
}

double EdgeCurve::fraction(Vec3 p) const {
    const double near = end_accuracy * length_;
    if (length_ <= 0 || distance(points_.front(), p) <= near) {
        return 0;
    }
    if (distance(points_.back(), p) <= near) {
        return 1;
    }
    const double t = nearest_parameter(p);
    const double first = parameters_.front();
    const double last = parameters_.back();
    if (t <= first || t >= last) {
        return t <= first ? 0 : 1;
    }
    if (uniform_) {
        return (t - first) / (last - first);
    }
    const auto after = std::upper_bound(parameters_.begin() + 1, parameters_.end() - 1, t);
    const auto i = static_cast<std::size_t>(after - parameters_.begin());
    return std::min(1.0, (lengths_[i - 1] + length_between(parameters_[i - 1], t)) / length_);
}

EdgeCurve::Part EdgeCurve::part(Vec3 from, Vec3 middle, Vec3 to) const {
    Part result{fraction(from), fraction(to)};
    if (!closed_ || length_ <= 0) {
        return result;
    }
    const double m = fraction(middle);
    const auto at_vertex = [](double f) { return f < end_accuracy || f > 1 - end_accuracy; };
    const bool low = at_vertex(result.from);
    const bool high = at_vertex(result.to);
    if (low && high) {
        // The whole edge, in the curve's sense: a middle alone cannot tell.
        return {0, 1};
    }
    if (low) {
        result.from = m < result.to ? 0 : 1;
    } else if (high) {
        result.to = m < result.from ? 0 : 1;
    } else if (m < std::min(result.from, result.to)) {
        // The part goes through the vertex: fractions run on past an end.
        (result.from > result.to ? result.from : result.to) -= 1;
    } else if (m > std::max(result.from, result.to)) {
        (result.from < result.to ? result.from : result.to) += 1;
    }
    return result;
}

} // namespace nmgs::cad
