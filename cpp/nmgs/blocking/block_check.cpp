// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs/blocking/block_check.h"

#include "nmgs/blocking/block_contact.h"
#include "nmgs/element/hexa20.h"
#include "nmgs/element/inverse_map.h"
#include "nmgs/element/quad8.h"
#include "nmgs/element/validity.h"
#include "nmgs/mesh/point_hash.h"
#include "nmgs/support/near_boxes.h"
#include "nmgs/support/numbers.h"
#include "nmgs/support/parallel.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <set>
#include <tuple>

namespace nmgs {
namespace {

std::string block_name(std::size_t b) {
    return "Block" + std::to_string(b + 1);
}

std::string place_text(Vec3 p) {
    const auto text = [](double value) {
        // Six digits are enough to find a place.
        std::array<char, 40> buffer{};
        const int size = std::snprintf(buffer.data(), buffer.size(), "%.6g", value);
        return std::string(buffer.data(), static_cast<std::size_t>(size));
    };
    return " near (" + text(p.x) + ", " + text(p.y) + ", " + text(p.z) + ")";
}

class Checker {
public:
    Checker(const BlockModel &model, const Topology &topology)
        : model_(model), topology_(topology), mirrored_(model.size(), 0) {
        for (std::size_t b = 0; b < model.size(); ++b) {
            Box box;
            for (const Vec3 &p : model.element(b)) {
                box.add(p);
            }
            boxes_.push_back(box);
        }
    }

    std::vector<BlockProblem> run(const Progress &progress) {
        check_validity_of_blocks(progress);
        check_conflicts();
        check_orientation();
        check_near_nodes();
        check_overlaps(progress);
        check_contacts();
        std::stable_sort(problems_.begin(), problems_.end(), [](const auto &a, const auto &b) {
            return std::tie(a.kind, a.block_a, a.block_b) < std::tie(b.kind, b.block_a, b.block_b);
        });
        return std::move(problems_);
    }

private:
    void add(ProblemKind kind, std::size_t a, std::int32_t b, Vec3 place, const std::string &text) {
        problems_.push_back(
            {kind, static_cast<std::int32_t>(a), b, place, text + place_text(place)});
    }
    [[nodiscard]] Vec3 at(std::size_t b, std::array<double, 3> natural) const {
        const auto nodes = model_.element(b);
        return model_.dimension == 2
                   ? quad8::map(nodes.first<8>(), natural[0], natural[1])
                   : hexa20::map(nodes.first<20>(), natural[0], natural[1], natural[2]);
    }
    [[nodiscard]] Vec3 middle_of(std::size_t b, int code) const {
        const auto d = part::digits(code);
        return at(b, {d[0] - 1.0, d[1] - 1.0, model_.dimension == 3 ? d[2] - 1.0 : 0.0});
    }
    [[nodiscard]] std::string part_name(std::size_t b, int code) const {
        return block_name(b) + " " + part::name(code, model_.dimension);
    }

    void check_validity_of_blocks(const Progress &progress) {
        std::vector<ValidityResult> results(model_.size());
        parallel_for(
            model_.size(), 4,
            [&](std::size_t first, std::size_t last) {
                for (std::size_t b = first; b < last; ++b) {
                    const auto nodes = model_.element(b);
                    results[b] = model_.dimension == 2 ? check_validity(nodes.first<8>())
                                                       : check_validity(nodes.first<20>());
                }
            },
            progress, 0.0, 0.0);
        for (std::size_t b = 0; b < model_.size(); ++b) {
            const Vec3 place = at(b, results[b].natural);
            switch (results[b].validity) {
            case Validity::valid:
                break;
            case Validity::mirrored:
                mirrored_[b] = 1;
                add(ProblemKind::mirrored, b, -1, place,
                    block_name(b) + " is mirrored: its numbering is left-handed,");
                break;
            case Validity::collapsed:
                add(ProblemKind::collapsed, b, -1, place,
                    block_name(b) + " is collapsed: its Jacobian is zero");
                break;
            case Validity::folded:
                add(ProblemKind::folded, b, -1, place,
                    block_name(b) + " is folded over itself: its Jacobian is not positive");
                break;
            }
        }
    }

    void check_conflicts() {
        for (const Conflict &c : topology_.conflicts) {
            const auto pair = std::minmax(c.block_a, c.block_b);
            sharing_.emplace(static_cast<std::size_t>(pair.first),
                             static_cast<std::size_t>(pair.second));
            const bool spacing = c.reason.starts_with("spaced");
            add(spacing ? ProblemKind::spacing : ProblemKind::divisions,
                static_cast<std::size_t>(c.block_a), c.block_b, c.place,
                part_name(static_cast<std::size_t>(c.block_a), c.part_a) + " is " + c.reason +
                    " (" + part_name(static_cast<std::size_t>(c.block_b), c.part_b) + "),");
        }
    }

    // +1 where the part's running directions, with the way out of the block, are right-handed.
    [[nodiscard]] int sense(std::size_t b, int code) const {
        const auto d = part::digits(code);
        int result = 1;
        if (model_.dimension == 3) {
            const int normal = d[0] != 1 ? 0 : d[1] != 1 ? 1 : 2;
            result = (normal == 1 ? -1 : 1) * (d[static_cast<std::size_t>(normal)] == 2 ? 1 : -1);
        } else {
            // Counter-clockwise round the patch: eta low, xi high forward.
            result = (d[0] == 1) == (d[d[0] == 1 ? 1 : 0] == 0) ? 1 : -1;
        }
        return mirrored_[b] != 0 ? -result : result;
    }

    void check_orientation() {
        const int shared_dimension = model_.dimension - 1;
        for (std::size_t b = 0; b < model_.size(); ++b) {
            for (int code = 0; code < (model_.dimension == 2 ? 9 : part::count); ++code) {
                const Owner &owner = topology_.of(b, code);
                if (part::dimension(code) != shared_dimension || topology_.owns(b, code)) {
                    continue;
                }
                const auto ob = static_cast<std::size_t>(owner.block);
                const auto uses =
                    topology_.uses[ob * part::count + static_cast<std::size_t>(owner.part)];
                sharing_.emplace(std::min(b, ob), std::max(b, ob));
                const Vec3 place = middle_of(b, code);
                const std::string both =
                    part_name(b, code) + " and " + part_name(ob, owner.part) + " are one";
                if (model_.dimension == 3 && uses > 2) {
                    add(ProblemKind::overlap, b, owner.block, place,
                        both + " that " + std::to_string(uses) + " blocks share,");
                    continue;
                }
                const int bits = (owner.flip & 1) + (owner.flip >> 1 & 1) + (owner.flip >> 2 & 1);
                const int turned = bits % 2 == 0 ? 1 : -1;
                if (uses > 2 || sense(b, code) * turned * sense(ob, owner.part) == -1) {
                    continue;
                }
                if (model_.dimension == 3) {
                    add(ProblemKind::overlap, b, owner.block, place,
                        both + ", and the blocks lie on the same side of it,");
                } else {
                    add(ProblemKind::mirrored, b, owner.block, place,
                        both + ", but one patch is turned over against the other");
                }
            }
        }
    }

    // Corners and mid-sides of different blocks that nearly meet.
    void check_near_nodes() {
        const double gap = gap_limit();
        if (!(gap > topology_.tolerance)) {
            return;
        }
        struct Place {
            std::size_t block;
            int code;
        };
        std::vector<Place> places;
        PointHash hash(gap);
        const int codes = model_.dimension == 2 ? 9 : part::count;
        for (std::size_t b = 0; b < model_.size(); ++b) {
            const std::size_t own = places.size();
            for (int code = 0; code < codes; ++code) {
                if (part::dimension(code) > 1 || !topology_.owns(b, code)) {
                    continue;
                }
                const Vec3 p = middle_of(b, code);
                const std::int64_t found = hash.find(p);
                if (found >= 0) {
                    const Place &other = places[static_cast<std::size_t>(found)];
                    const double d = distance(p, middle_of(other.block, other.code));
                    if (d > topology_.tolerance) {
                        gaps_.emplace(other.block, b);
                        add(ProblemKind::gap, b, static_cast<std::int32_t>(other.block), p,
                            part_name(b, code) + " and " + part_name(other.block, other.code) +
                                " are " + number(d) + " apart");
                    }
                }
                places.push_back({b, code});
            }
            for (std::size_t i = own; i < places.size(); ++i) {
                hash.insert(middle_of(b, places[i].code), static_cast<std::int64_t>(i));
            }
        }
    }

    [[nodiscard]] double gap_limit() const { return 0.2 * smallest_element_edge(model_); }

    static std::string number(double value) {
        std::array<char, 40> buffer{};
        const int size = std::snprintf(buffer.data(), buffer.size(), "%.3g", value);
        return {buffer.data(), static_cast<std::size_t>(size)};
    }

    // Blocks that share no face: places inside one that are inside the other too.
    void check_overlaps(const Progress &progress) {
        std::vector<std::pair<std::size_t, std::size_t>> pairs;
        // Boxes of the nodes will do: what a curved face has outside of them is thin.
        const double gap = model_.dimension == 3 ? -topology_.tolerance : topology_.tolerance;
        for (const auto &pair : near_boxes(boxes_, gap, most_near_boxes(model_.size()))) {
            if (!sharing_.contains(pair)) {
                pairs.push_back(pair);
            }
        }
        std::vector<char> overlaps(pairs.size(), 0);
        std::vector<Vec3> places(pairs.size());
        // In batches: a model with a thousand overlaps is told so, not searched to its end.
        constexpr std::size_t batch = 1 << 14;
        constexpr std::ptrdiff_t enough = 1000;
        std::size_t done = 0;
        while (done < pairs.size() &&
               std::count(overlaps.begin(), overlaps.end(), char{1}) < enough) {
            const std::size_t start = done;
            done = std::min(pairs.size(), start + batch);
            parallel_for(
                done - start, 16,
                [&](std::size_t first, std::size_t last) {
                    for (std::size_t i = start + first; i < start + last; ++i) {
                        overlaps[i] = overlap(pairs[i].first, pairs[i].second, places[i]) ||
                                              overlap(pairs[i].second, pairs[i].first, places[i])
                                          ? 1
                                          : 0;
                    }
                },
                progress, 0.0, 0.0);
        }
        for (std::size_t i = 0; i < pairs.size(); ++i) {
            if (overlaps[i] != 0) {
                sharing_.insert(pairs[i]);
                add(ProblemKind::overlap, pairs[i].second,
                    static_cast<std::int32_t>(pairs[i].first), places[i],
                    block_name(pairs[i].second) + " and " + block_name(pairs[i].first) +
                        " overlap");
            }
        }
    }

    // Whether an edge of block a runs through block b, as far as nine places on it tell: of two
    // blocks that overlap, one has such an edge, or is inside the other.
    [[nodiscard]] bool pierces(std::size_t a, std::size_t b, Vec3 &place) const {
        const auto nodes = model_.element(b);
        for (int code = 0; code < part::count; ++code) {
            if (part::dimension(code) != 1) {
                continue;
            }
            const auto digits = part::digits(code);
            const auto axis = static_cast<std::size_t>(part::axes(code).axis[0]);
            std::array<double, 3> natural{digits[0] - 1.0, digits[1] - 1.0, digits[2] - 1.0};
            for (int i = -4; i <= 4; ++i) {
                natural[axis] = 0.22 * i;
                place = at(a, natural);
                if (!boxes_[b].near(place, topology_.tolerance)) {
                    continue;
                }
                const auto found = find_natural(nodes.first<20>(), place);
                if (found && std::all_of(found->begin(), found->end(),
                                         [](double t) { return std::abs(t) < 0.999; })) {
                    return true;
                }
            }
        }
        return false;
    }

    // Whether a sample inside block a lies inside block b.
    [[nodiscard]] bool overlap(std::size_t a, std::size_t b, Vec3 &place) const {
        constexpr std::array<double, 3> samples{0, -0.8, 0.8};
        const auto nodes = model_.element(b);
        for (const double xi : samples) {
            for (const double eta : samples) {
                for (const double zeta : samples) {
                    // The middle, and places towards the corners.
                    const int middles = (xi == 0 ? 1 : 0) + (eta == 0 ? 1 : 0);
                    if (model_.dimension == 2 ? zeta != 0 || middles == 1
                                              : middles + (zeta == 0 ? 1 : 0) != 0 &&
                                                    middles + (zeta == 0 ? 1 : 0) != 3) {
                        continue;
                    }
                    place = at(a, {xi, eta, zeta});
                    if (!boxes_[b].near(place, topology_.tolerance)) {
                        continue;
                    }
                    if (model_.dimension == 3) {
                        const auto natural = find_natural(nodes.first<20>(), place);
                        if (natural && std::all_of(natural->begin(), natural->end(),
                                                   [](double t) { return std::abs(t) < 0.999; })) {
                            return true;
                        }
                    } else {
                        const Foot foot = find_foot(nodes.first<8>(), place);
                        if (foot.inside && std::abs(foot.xi) < 0.999 &&
                            std::abs(foot.eta) < 0.999 && foot.distance <= topology_.tolerance) {
                            return true;
                        }
                    }
                }
            }
        }
        return model_.dimension == 3 && pierces(a, b, place);
    }

    // Faces (of patches: edges) that touch without being one.
    void check_contacts() {
        for (const Contact &c : find_bad_contacts(model_, topology_, gap_limit())) {
            const auto pair = std::minmax(c.block_a, c.block_b);
            if (sharing_.contains({pair.first, pair.second}) ||
                gaps_.contains({pair.first, pair.second})) {
                continue;
            }
            if (model_.dimension == 2 && part::dimension(c.part_b) == 2) {
                add(c.overlap ? ProblemKind::overlap : ProblemKind::divisions, c.block_a,
                    static_cast<std::int32_t>(c.block_b), c.place,
                    part_name(c.block_a, c.part_a) + " lies inside " + block_name(c.block_b) +
                        (c.overlap ? ": they overlap" : ", where nothing joins their nodes,"));
                continue;
            }
            const std::string both =
                part_name(c.block_a, c.part_a) + " and " + part_name(c.block_b, c.part_b);
            if (c.distance > topology_.tolerance) {
                add(ProblemKind::gap, c.block_a, static_cast<std::int32_t>(c.block_b), c.place,
                    both + " are " + number(c.distance) + " apart");
            } else {
                add(ProblemKind::divisions, c.block_a, static_cast<std::int32_t>(c.block_b),
                    c.place, both + " touch, but their divisions do not match");
            }
        }
    }

    const BlockModel &model_;
    const Topology &topology_;
    std::vector<char> mirrored_;
    std::vector<Box> boxes_;
    std::set<std::pair<std::size_t, std::size_t>> sharing_; // a face, or space
    std::set<std::pair<std::size_t, std::size_t>> gaps_;
    std::vector<BlockProblem> problems_;
};

} // namespace

const char *name(ProblemKind kind) {
    constexpr const char *names[] = {"folded",  "collapsed", "mirrored", "divisions",
                                     "spacing", "gap",       "overlap"};
    return names[static_cast<std::size_t>(kind)];
}

std::vector<BlockProblem> check_blocks(const BlockModel &model, const Topology &topology,
                                       const Progress &progress) {
    return Checker(model, topology).run(progress);
}

BlockingError as_error(const std::vector<BlockProblem> &problems) {
    std::vector<std::string> entities;
    std::vector<std::string> reasons;
    for (const BlockProblem &p : problems) {
        entities.push_back(block_name(static_cast<std::size_t>(p.block_a)));
        reasons.push_back(p.text);
        if (p.block_b >= 0) {
            entities.push_back(block_name(static_cast<std::size_t>(p.block_b)));
            reasons.push_back(p.text);
        }
    }
    std::string text = "the blocks cannot be meshed: " + problems.front().text;
    if (problems.size() > 1) {
        text += ", and " + std::to_string(problems.size() - 1) + " more";
    }
    return {text, std::move(entities), std::move(reasons)};
}

} // namespace nmgs
