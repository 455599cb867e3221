// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs/blocking/grading.h"

#include "nmgs/support/error.h"
#include "nmgs/support/memory.h"
#include "nmgs/support/numbers.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>

namespace nmgs::grading {
namespace {

std::string text(double value) {
    char buffer[max_number_length];
    return {buffer, print(buffer, value)};
}

void require_count(std::int32_t n) {
    if (n < 1) {
        throw ArgumentError("n: expected 1 or more elements, got " + std::to_string(n));
    }
    require_memory(std::int64_t{32} * n, "n: the positions");
}

void require_positive(const char *name, double value) {
    if (!(value > 0) || !std::isfinite(value)) {
        throw ArgumentError(std::string(name) + ": expected a positive number, got " + text(value));
    }
}

void require_part(const char *name, double value) {
    require_positive(name, value);
    if (value >= 1) {
        throw ArgumentError(std::string(name) + ": expected less than the whole length, got " +
                            text(value) + " of it");
    }
}

// Positions from sizes of any scale; ends exact, ascending.
std::vector<double> from_sizes(const std::vector<double> &sizes) {
    double total = 0;
    for (const double s : sizes) {
        total += s;
    }
    std::vector<double> positions{0};
    double sum = 0;
    for (const double s : sizes) {
        sum += s;
        positions.push_back(sum / total);
    }
    positions.back() = 1;
    return explicit_positions(positions);
}

// Root of a continuous function with f(low) and f(high) of different signs, to the last bit.
double bisect(double low, double high, const std::function<double(double)> &f) {
    const bool rising = f(low) < 0;
    for (int i = 0; i < 200; ++i) {
        const double middle = 0.5 * (low + high);
        if (middle == low || middle == high) {
            break;
        }
        ((f(middle) < 0) == rising ? low : high) = middle;
    }
    return 0.5 * (low + high);
}

// 1 + r + ... + r^(n - 1), without loss near r = 1.
double geometric_sum(std::int32_t n, double r) {
    const double x = r - 1;
    return std::abs(x) < 1e-12 ? n : std::expm1(n * std::log1p(x)) / x;
}

} // namespace

std::vector<double> explicit_positions(std::span<const double> positions) {
    if (positions.size() < 2) {
        throw ArgumentError("positions: expected 2 or more, got " +
                            std::to_string(positions.size()));
    }
    const double low = positions.front();
    const double length = positions.back() - low;
    std::vector<double> result;
    for (std::size_t i = 0; i < positions.size(); ++i) {
        if (!std::isfinite(positions[i]) || (i > 0 && !(positions[i] > positions[i - 1]))) {
            throw ArgumentError("positions: expected finite ascending numbers, but number " +
                                std::to_string(i + 1) + " is " + text(positions[i]) +
                                (i > 0 ? " after " + text(positions[i - 1]) : std::string()));
        }
        result.push_back(low == 0 && length == 1 ? positions[i] : (positions[i] - low) / length);
    }
    result.back() = 1;
    for (std::size_t i = 1; i < result.size(); ++i) {
        if (!(result[i] > result[i - 1])) {
            throw ArgumentError("positions: number " + std::to_string(i + 1) +
                                " is too near the one before it");
        }
    }
    return result;
}

std::vector<double> reversed(std::span<const double> positions) {
    std::vector<double> result;
    for (std::size_t i = positions.size(); i-- > 0;) {
        result.push_back(1 - positions[i]);
    }
    return result;
}

std::vector<double> geometric(std::int32_t n, double ratio) {
    require_count(n);
    require_positive("ratio", ratio);
    std::vector<double> sizes;
    sizes.reserve(static_cast<std::size_t>(n));
    // From the larger end, so that no size overflows.
    for (std::int32_t i = 0; i < n; ++i) {
        sizes.push_back(ratio > 1 ? std::pow(ratio, i - (n - 1)) : std::pow(ratio, i));
    }
    return from_sizes(sizes);
}

std::vector<double> geometric_first(std::int32_t n, double size) {
    require_count(n);
    if (n == 1) {
        if (std::abs(size - 1) > 1e-9) {
            throw ArgumentError("first: one element has the whole length, got " + text(size) +
                                " of it");
        }
        return {0, 1};
    }
    require_part("first", size);
    const auto excess = [&](double log_ratio) {
        return size * geometric_sum(n, std::exp(log_ratio)) - 1;
    };
    // The sum is at least 1 (ratio 0) and at least ratio^(n - 1).
    const double high = (1 - std::log(size)) / (n - 1) + 1;
    const double low = -1 - 1 / (1 - size) - std::log(1 / (1 - size));
    double least = low;
    while (excess(least) > 0 && least > -700) {
        least *= 2;
    }
    return geometric(n, std::exp(bisect(least, high, excess)));
}

std::vector<double> geometric_last(std::int32_t n, double size) {
    try {
        return reversed(geometric_first(n, size));
    } catch (const ArgumentError &e) {
        std::string what = e.what();
        if (what.starts_with("first")) {
            what.replace(0, 5, "last");
        }
        throw ArgumentError(what);
    }
}

std::vector<double> two_sided(std::int32_t n, double ratio) {
    require_count(n);
    require_positive("ratio", ratio);
    std::vector<double> sizes;
    const std::int32_t peak = (n - 1) / 2;
    for (std::int32_t i = 0; i < n; ++i) {
        const std::int32_t from_end = std::min(i, n - 1 - i);
        sizes.push_back(std::pow(ratio, ratio > 1 ? from_end - peak : from_end));
    }
    return from_sizes(sizes);
}

std::vector<double> two_sided(std::int32_t n, double first, double last) {
    require_count(n);
    require_part("first", first);
    require_part("last", last);
    if (n < 3) {
        if (n == 2 && std::abs(first + last - 1) <= 1e-9) {
            return {0, first, 1};
        }
        throw ArgumentError("first, last: " + std::to_string(n) +
                            " elements cannot have these sizes and fill the length: " +
                            text(first) + ", " + text(last));
    }
    if (first + last >= 1) {
        throw ArgumentError("first, last: together they leave no room for the elements between: " +
                            text(first) + ", " + text(last));
    }
    const double steepest = std::abs(std::log(last / first)) / (n - 1);
    const auto sizes = [&](double log_ratio, bool grows) {
        std::vector<double> s;
        for (std::int32_t i = 0; i < n; ++i) {
            const double a = std::log(first) + (grows ? i : -i) * log_ratio;
            const double b = std::log(last) + (grows ? n - 1 - i : i - (n - 1)) * log_ratio;
            s.push_back(std::exp(grows ? std::min(a, b) : std::max(a, b)));
        }
        return s;
    };
    const auto excess = [&](double log_ratio, bool grows) {
        double sum = -1;
        for (const double s : sizes(log_ratio, grows)) {
            sum += s;
        }
        return sum;
    };
    const bool grows = excess(steepest, true) <= 0;
    double high = steepest + 1;
    while ((excess(high, grows) < 0) == grows && high < 700) {
        high *= 2;
    }
    return from_sizes(
        sizes(bisect(steepest, high, [&](double r) { return excess(r, grows); }), grows));
}

namespace {

// sinh(d) / d = b for b > 1, sin(d) / d = b for b < 1 as -d.
double stretching(double b) {
    if (std::abs(b - 1) < 1e-10) {
        return 0;
    }
    if (b > 1) {
        return bisect(0, 2 + 2 * std::log(b) + std::log(2 + std::log(b)),
                      [&](double d) { return (d < 1e-8 ? 1.0 : std::sinh(d) / d) - b; });
    }
    return -bisect(0, std::acos(-1.0),
                   [&](double d) { return (d < 1e-8 ? 1.0 : std::sin(d) / d) - b; });
}

// Vinokur's two-sided function with slopes s0, s1 (element sizes at the ends) at t in [0, 1].
double vinokur(double t, double delta, double a) {
    double u = t;
    if (delta > 0) {
        u = 0.5 * (1 + std::tanh(delta * (t - 0.5)) / std::tanh(0.5 * delta));
    } else if (delta < 0) {
        u = 0.5 * (1 + std::tan(-delta * (t - 0.5)) / std::tan(-0.5 * delta));
    }
    return u / (a + (1 - a) * u);
}

} // namespace

std::vector<double> tanh(std::int32_t n, double first, double last) {
    require_count(n);
    require_part("first", first);
    require_part("last", last);
    if (n < 3) {
        return two_sided(n, first, last);
    }
    if (first + last >= 1) {
        throw ArgumentError("first, last: together they leave no room for the elements between: " +
                            text(first) + ", " + text(last));
    }
    double s0 = first;
    double s1 = last;
    std::vector<double> positions;
    for (int i = 0; i < 200; ++i) {
        const double delta = stretching(1 / (n * std::sqrt(s0 * s1)));
        const double a = std::sqrt(s1 / s0);
        positions.assign(1, 0.0);
        for (std::int32_t k = 1; k < n; ++k) {
            positions.push_back(vinokur(static_cast<double>(k) / n, delta, a));
        }
        positions.push_back(1);
        const double e0 = first / positions[1];
        const double e1 = last / (1 - positions[positions.size() - 2]);
        if (!(std::isfinite(e0) && std::isfinite(e1))) {
            break;
        }
        if (std::abs(e0 - 1) < 1e-13 && std::abs(e1 - 1) < 1e-13) {
            return explicit_positions(positions);
        }
        s0 *= e0;
        s1 *= e1;
    }
    const bool near = std::abs(positions[1] / first - 1) < 1e-6 &&
                      std::abs((1 - positions[positions.size() - 2]) / last - 1) < 1e-6;
    if (!near) {
        throw ArgumentError("first, last: no hyperbolic tangent of " + std::to_string(n) +
                            " elements has these sizes: " + text(first) + ", " + text(last));
    }
    return explicit_positions(positions);
}

std::vector<double> tanh_first(std::int32_t n, double first) {
    require_count(n);
    if (n == 1) {
        return geometric_first(n, first);
    }
    require_part("first", first);
    const auto position = [&](double delta, std::int32_t k) {
        const double t = static_cast<double>(k) / n - 1;
        if (delta > 0) {
            return 1 + std::tanh(0.5 * delta * t) / std::tanh(0.5 * delta);
        }
        return delta < 0 ? 1 + std::tan(-0.5 * delta * t) / std::tan(-0.5 * delta) : 1 + t;
    };
    // Falls as delta grows; delta < 0 is the tangent branch, for sizes above the uniform one.
    const auto excess = [&](double delta) { return position(delta, 1) - first; };
    constexpr double least = -3.14159;
    if (excess(least) < 0 || excess(1400) > 0) {
        throw ArgumentError("first: no hyperbolic tangent of " + std::to_string(n) +
                            " elements begins with " + text(first) + " of the length");
    }
    const double delta = bisect(least, 1400, excess);
    std::vector<double> positions{0};
    for (std::int32_t k = 1; k < n; ++k) {
        positions.push_back(position(delta, k));
    }
    positions.push_back(1);
    return explicit_positions(positions);
}

} // namespace nmgs::grading
