// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs/element/quad8.h"

namespace nmgs::quad8 {

std::array<double, 8> shape(double xi, double eta) {
    std::array<double, 8> n{};
    for (std::size_t i = 0; i < 8; ++i) {
        const double a = natural[i][0];
        const double b = natural[i][1];
        if (i < 4) {
            n[i] = 0.25 * (1 + xi * a) * (1 + eta * b) * (xi * a + eta * b - 1);
        } else if (b == 0) {
            n[i] = 0.5 * (1 + xi * a) * (1 - eta * eta);
        } else {
            n[i] = 0.5 * (1 + eta * b) * (1 - xi * xi);
        }
    }
    return n;
}

Derivatives derivatives(double xi, double eta) {
    Derivatives d{};
    for (std::size_t i = 0; i < 8; ++i) {
        const double a = natural[i][0];
        const double b = natural[i][1];
        if (i < 4) {
            d.xi[i] = 0.25 * a * (1 + eta * b) * (2 * xi * a + eta * b);
            d.eta[i] = 0.25 * b * (1 + xi * a) * (xi * a + 2 * eta * b);
        } else if (b == 0) {
            d.xi[i] = 0.5 * a * (1 - eta * eta);
            d.eta[i] = -eta * (1 + xi * a);
        } else {
            d.xi[i] = -xi * (1 + eta * b);
            d.eta[i] = 0.5 * b * (1 - xi * xi);
        }
    }
    return d;
}

Vec3 map(std::span<const Vec3, 8> nodes, double xi, double eta) {
    const auto n = shape(xi, eta);
    Vec3 p{0, 0, 0};
    for (std::size_t i = 0; i < 8; ++i) {
        p += n[i] * nodes[i];
    }
    return p;
}

Tangents tangents(std::span<const Vec3, 8> nodes, double xi, double eta) {
    const auto d = derivatives(xi, eta);
    Tangents t{{0, 0, 0}, {0, 0, 0}};
    for (std::size_t i = 0; i < 8; ++i) {
        t.xi += d.xi[i] * nodes[i];
        t.eta += d.eta[i] * nodes[i];
    }
    return t;
}

} // namespace nmgs::quad8
