// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs/element/hexa20.h"

namespace nmgs::hexa20 {

std::array<double, 20> shape(double xi, double eta, double zeta) {
    std::array<double, 20> n{};
    for (std::size_t i = 0; i < 20; ++i) {
        const auto [a, b, c] = natural[i];
        const double u = 1 + xi * a;
        const double v = 1 + eta * b;
        const double w = 1 + zeta * c;
        if (i < 8) {
            n[i] = 0.125 * u * v * w * (xi * a + eta * b + zeta * c - 2);
        } else if (a == 0) {
            n[i] = 0.25 * (1 - xi * xi) * v * w;
        } else if (b == 0) {
            n[i] = 0.25 * u * (1 - eta * eta) * w;
        } else {
            n[i] = 0.25 * u * v * (1 - zeta * zeta);
        }
    }
    return n;
}

Derivatives derivatives(double xi, double eta, double zeta) {
    Derivatives d{};
    for (std::size_t i = 0; i < 20; ++i) {
        const auto [a, b, c] = natural[i];
        const double u = 1 + xi * a;
        const double v = 1 + eta * b;
        const double w = 1 + zeta * c;
        if (i < 8) {
            const double s = xi * a + eta * b + zeta * c - 2;
            d.xi[i] = 0.125 * a * v * w * (s + u);
            d.eta[i] = 0.125 * b * u * w * (s + v);
            d.zeta[i] = 0.125 * c * u * v * (s + w);
        } else if (a == 0) {
            d.xi[i] = -0.5 * xi * v * w;
            d.eta[i] = 0.25 * (1 - xi * xi) * b * w;
            d.zeta[i] = 0.25 * (1 - xi * xi) * v * c;
        } else if (b == 0) {
            d.xi[i] = 0.25 * a * (1 - eta * eta) * w;
            d.eta[i] = -0.5 * eta * u * w;
            d.zeta[i] = 0.25 * u * (1 - eta * eta) * c;
        } else {
            d.xi[i] = 0.25 * a * v * (1 - zeta * zeta);
            d.eta[i] = 0.25 * u * b * (1 - zeta * zeta);
            d.zeta[i] = -0.5 * zeta * u * v;
        }
    }
    return d;
}

Vec3 map(std::span<const Vec3, 20> nodes, double xi, double eta, double zeta) {
    const auto n = shape(xi, eta, zeta);
    Vec3 p{0, 0, 0};
    for (std::size_t i = 0; i < 20; ++i) {
        p += n[i] * nodes[i];
    }
    return p;
}

double jacobian(std::span<const Vec3, 20> nodes, double xi, double eta, double zeta) {
    const auto d = derivatives(xi, eta, zeta);
    Vec3 by_xi{0, 0, 0};
    Vec3 by_eta{0, 0, 0};
    Vec3 by_zeta{0, 0, 0};
    for (std::size_t i = 0; i < 20; ++i) {
        by_xi += d.xi[i] * nodes[i];
        by_eta += d.eta[i] * nodes[i];
        by_zeta += d.zeta[i] * nodes[i];
    }
    return determinant(by_xi, by_eta, by_zeta);
}

} // namespace nmgs::hexa20
