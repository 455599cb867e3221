// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs/convert/flip_diagonals.h"

#include "nmgs/convert/inner_point.h"

#include <algorithm>
#include <bit>
#include <map>
#include <optional>
#include <set>

namespace nmgs {
namespace {

using Tetrahedra = std::array<std::int32_t, 48>;

// The four corners of face f of a split hexahedron, from its two tetrahedra.
FlippedFace key_of(const std::int32_t *tetrahedra, std::size_t f) {
    const std::int32_t *t = tetrahedra + 8 * f;
    FlippedFace key{t[0], t[1], t[4], t[5]};
    std::sort(key.begin(), key.end());
    return key;
}

void flip(std::int32_t *tetrahedra, std::size_t f) {
    std::int32_t *t = tetrahedra + 8 * f;
    const bool joined = t[2] == t[5]; // a b d, c d b; else a b c, c d a
    t[2] = joined ? t[4] : t[5];
    t[6] = joined ? t[0] : t[1];
}

struct Mender {
    std::span<const Vec3> points;
    std::span<std::int32_t> tetrahedra;
    std::span<Vec3> centroids;
    std::set<std::int64_t> bad;
    std::map<FlippedFace, std::vector<std::int64_t>> owners; // of the faces of bad hexahedra

    [[nodiscard]] Tetrahedra of(std::int64_t h) const {
        Tetrahedra t{};
        std::copy_n(tetrahedra.begin() + 48 * h, 48, t.begin());
        return t;
    }
    // Where the inner node can stand: where it stands, if that will do.
    [[nodiscard]] std::optional<Vec3> place(std::int64_t h, const Tetrahedra &t) const {
        std::array<std::array<Vec3, 3>, 12> triangles{};
        const Vec3 now = centroids[static_cast<std::size_t>(h)];
        bool good = true;
        for (std::size_t i = 0; i < 12; ++i) {
            for (std::size_t n = 0; n < 3; ++n) {
                triangles[i][n] = points[static_cast<std::size_t>(t[4 * i + n])];
            }
            const auto &[a, b, c] = triangles[i];
            good = good && determinant(b - a, c - a, now - a) > 0;
        }
        return good ? now : inner_point(triangles);
    }
    void write(std::int64_t h, const Tetrahedra &t, Vec3 centroid) {
        std::copy(t.begin(), t.end(), tetrahedra.begin() + 48 * h);
        centroids[static_cast<std::size_t>(h)] = centroid;
    }

    // Tries to flip the faces of the mask's bits; returns the faces, none when it does not help.
    std::vector<FlippedFace> try_flips(std::int64_t h, unsigned mask) {
        struct Change {
            std::int64_t hexahedron;
            Tetrahedra tetrahedra;
            Vec3 centroid;
        };
        std::vector<FlippedFace> faces;
        std::vector<Change> changes;
        Tetrahedra mine = of(h);
        for (std::size_t f = 0; f < 6; ++f) {
            if ((mask >> f & 1U) != 0) {
                flip(mine.data(), f);
            }
        }
        const auto centroid = place(h, mine);
        if (!centroid) {
            return {};
        }
        changes.push_back({h, mine, *centroid});
        for (std::size_t f = 0; f < 6; ++f) {
            if ((mask >> f & 1U) == 0) {
                continue;
            }
            faces.push_back(key_of(mine.data(), f));
            for (const std::int64_t other : owners[faces.back()]) {
                if (other == h) {
                    continue;
                }
                // Two faces with the same neighbour: go on from the change that is there.
                auto change = std::find_if(changes.begin(), changes.end(),
                                           [&](const Change &c) { return c.hexahedron == other; });
                if (change == changes.end()) {
                    changes.push_back(
                        {other, of(other), centroids[static_cast<std::size_t>(other)]});
                    change = changes.end() - 1;
                }
                for (std::size_t g = 0; g < 6; ++g) {
                    if (key_of(change->tetrahedra.data(), g) == faces.back()) {
                        flip(change->tetrahedra.data(), g);
                    }
                }
                const auto there = place(other, change->tetrahedra);
                if (!there && !bad.contains(other)) {
                    return {};
                }
                change->centroid = there.value_or(change->centroid);
            }
        }
        for (const Change &change : changes) {
            write(change.hexahedron, change.tetrahedra, change.centroid);
        }
        return faces;
    }
};

// Faces with all corners at bad hexahedra, and the hexahedra that have them.
std::map<FlippedFace, std::vector<std::int64_t>>
find_owners(std::size_t points, std::span<const std::int32_t> hexahedra,
            std::span<const std::int64_t> bad, std::span<const std::int32_t> tetrahedra) {
    std::vector<char> near(points, 0);
    for (const std::int64_t h : bad) {
        for (const std::int32_t node : hexahedra.subspan(static_cast<std::size_t>(8 * h), 8)) {
            near[static_cast<std::size_t>(node)] = 1;
        }
    }
    std::map<FlippedFace, std::vector<std::int64_t>> owners;
    for (std::size_t h = 0; h < hexahedra.size() / 8; ++h) {
        int corners = 0;
        for (const std::int32_t node : hexahedra.subspan(8 * h, 8)) {
            corners += near[static_cast<std::size_t>(node)];
        }
        for (std::size_t f = 0; corners >= 4 && f < 6; ++f) {
            const auto key = key_of(tetrahedra.data() + 48 * h, f);
            if (std::all_of(key.begin(), key.end(), [&](std::int32_t n) {
                    return near[static_cast<std::size_t>(n)] != 0;
                })) {
                owners[key].push_back(static_cast<std::int64_t>(h));
            }
        }
    }
    return owners;
}

} // namespace

std::vector<FlippedFace> flip_diagonals(std::span<const Vec3> points,
                                        std::span<const std::int32_t> hexahedra,
                                        std::span<const std::int64_t> bad,
                                        std::span<std::int32_t> tetrahedra,
                                        std::span<Vec3> centroids) {
    Mender mender{points,
                  tetrahedra,
                  centroids,
                  {bad.begin(), bad.end()},
                  find_owners(points.size(), hexahedra, bad, tetrahedra)};
    std::vector<unsigned> masks;
    for (unsigned mask = 0; mask < 64; ++mask) {
        masks.push_back(mask);
    }
    std::stable_sort(masks.begin(), masks.end(),
                     [](unsigned a, unsigned b) { return std::popcount(a) < std::popcount(b); });
    std::map<FlippedFace, bool> flipped;
    for (const std::int64_t h : bad) {
        // A neighbour's flip may have mended it already.
        if (const auto place = mender.place(h, mender.of(h))) {
            mender.write(h, mender.of(h), *place);
            mender.bad.erase(h);
            continue;
        }
        for (const unsigned mask : masks) {
            const auto faces = mask == 0 ? std::vector<FlippedFace>() : mender.try_flips(h, mask);
            if (!faces.empty()) {
                mender.bad.erase(h);
                for (const FlippedFace &face : faces) {
                    flipped[face] = !flipped[face];
                }
                break;
            }
        }
    }
    std::vector<FlippedFace> result;
    for (const auto &[face, is] : flipped) {
        if (is) {
            result.push_back(face);
        }
    }
    return result;
}

} // namespace nmgs
