// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs/formats/result_file.h"

#include "nmgs/convert/hexa_to_tetra.h"
#include "nmgs/convert/quad_to_triangle.h"
#include "nmgs/mesh/related_nodes.h"
#include "nmgs/support/memory.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace nmgs {
namespace {

constexpr const char *file_ids[] = {"NMGS-SSMG Result File", "NMGS-SVMG Result File"};
constexpr std::int32_t largest = std::numeric_limits<std::int32_t>::max();

// The text "x y z" of nodes, kept because a node occurs in many zones that are near each other.
class PlaceText {
public:
    PlaceText(std::span<const Vec3> points, std::span<const Vec3> more)
        : points_(points), more_(more), slots_(1 << 12) {}

    std::string_view operator()(std::int32_t node) {
        Slot &slot = slots_[static_cast<std::size_t>(node) % slots_.size()];
        if (slot.node != node) {
            const auto n = static_cast<std::size_t>(node);
            const Vec3 p = n < points_.size() ? points_[n] : more_[n - points_.size()];
            char *end = print(slot.text.data(), p.x);
            *end++ = ' ';
            end = print(end, p.y);
            *end++ = ' ';
            end = print(end, p.z);
            slot.node = node;
            slot.size = static_cast<std::size_t>(end - slot.text.data());
        }
        return {slot.text.data(), slot.size};
    }

private:
    struct Slot {
        std::int32_t node = -1;
        std::size_t size = 0;
        std::array<char, 3 * max_number_length + 2> text;
    };
    std::span<const Vec3> points_;
    std::span<const Vec3> more_;
    std::vector<Slot> slots_;
};

void add_zone(TextBuffer &out, std::int64_t number, std::span<const std::int32_t> nodes,
              PlaceText &places) {
    out.add(number);
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        out.add(i == 0 ? '\n' : ' ');
        out.add(nodes[i] + 1);
    }
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        out.add(i == 0 ? '\n' : ' ');
        out.add(places(nodes[i]));
    }
    out.add('\n');
}

void write_related_nodes(AtomicFile &file, const RelatedNodes &related, const Progress &progress,
                         double from, double to) {
    const auto count = static_cast<std::int64_t>(related.offsets.size()) - 1;
    write_items(
        file, count, 2048,
        [&](std::int64_t first, std::int64_t last, TextBuffer &out) {
            for (std::int64_t n = first; n < last; ++n) {
                const auto begin = related.offsets[static_cast<std::size_t>(n)];
                const auto end = related.offsets[static_cast<std::size_t>(n) + 1];
                out.add(n + 1);
                out.add(' ');
                out.add(end - begin);
                out.add('\n');
                for (std::int64_t i = begin; i < end; ++i) {
                    out.add(related.neighbours[static_cast<std::size_t>(i)] + 1);
                    out.add('\n');
                }
            }
        },
        progress, from, to);
}

void write_nodes(AtomicFile &file, std::span<const Vec3> points, std::int64_t first_number,
                 const Progress &progress, double from, double to) {
    write_items(
        file, static_cast<std::int64_t>(points.size()), 4096,
        [&](std::int64_t first, std::int64_t last, TextBuffer &out) {
            for (std::int64_t n = first; n < last; ++n) {
                const Vec3 p = points[static_cast<std::size_t>(n)];
                out.add(first_number + n);
                out.add('\n');
                out.add(p.x);
                out.add(' ');
                out.add(p.y);
                out.add(' ');
                out.add(p.z);
                out.add('\n');
            }
        },
        progress, from, to);
}

// The lowest block that uses each node: the node is common in all the others (CN).
std::vector<std::int32_t> first_blocks(const BlockModel &model, std::size_t points,
                                       std::span<const std::int32_t> cells) {
    std::vector<std::int32_t> first(points, -1);
    std::size_t at = 0;
    for (std::size_t b = 0; b < model.size(); ++b) {
        const auto g = model.divisions[b];
        const std::size_t end =
            at + static_cast<std::size_t>(std::int64_t{g[0]} * g[1] *
                                          (model.dimension == 3 ? g[2] * 8 : 4));
        for (; at < end; ++at) {
            auto &block = first[static_cast<std::size_t>(cells[at])];
            block = block < 0 ? static_cast<std::int32_t>(b) : block;
        }
    }
    return first;
}

void write_zones(AtomicFile &file, const BlockModel &model, std::span<const Vec3> points,
                 std::span<const std::int32_t> cells, std::span<const std::uint8_t> parameters,
                 const Progress &progress, double from, double to) {
    const std::size_t k = model.dimension == 3 ? 8 : 4;
    const auto first_block = first_blocks(model, points.size(), cells);
    std::vector<std::int64_t> first_cell{0};
    for (const auto &g : model.divisions) {
        first_cell.push_back(first_cell.back() +
                             std::int64_t{g[0]} * g[1] * (model.dimension == 3 ? g[2] : 1));
    }
    write_items(
        file, first_cell.back(), 1024,
        [&](std::int64_t first, std::int64_t last, TextBuffer &out) {
            PlaceText places(points, {});
            auto block = std::upper_bound(first_cell.begin(), first_cell.end(), first) -
                         first_cell.begin() - 1;
            for (std::int64_t z = first; z < last; ++z) {
                while (first_cell[static_cast<std::size_t>(block) + 1] <= z) {
                    ++block;
                }
                const auto nodes = cells.subspan(static_cast<std::size_t>(z) * k, k);
                add_zone(out, z + 1, nodes, places);
                for (std::size_t i = 0; i < k; ++i) {
                    const bool common = first_block[static_cast<std::size_t>(nodes[i])] < block;
                    out.add(common ? '1' : '0');
                    out.add(i + 1 < k ? ' ' : '\n');
                }
                if (k == 4) {
                    out.add(parameters[static_cast<std::size_t>(z)] != 0 ? '1' : '0');
                    out.add('\n');
                }
            }
        },
        progress, from, to);
}

void write_surface(AtomicFile &file, const BlockModel &model, std::span<const Vec3> points,
                   std::span<const std::int32_t> cells, const Progress &progress) {
    Array<std::uint8_t> parameters(cells.size() / 4);
    triangulation_parameters(points, cells, EqualDiagonals::second_and_fourth,
                             {parameters.data(), parameters.size()});
    write_zones(file, model, points, cells, {parameters.data(), parameters.size()}, progress, 0.0,
                0.6);
    Array<std::int32_t> triangles(cells.size() / 4 * 6);
    split_quads(points, cells, EqualDiagonals::second_and_fourth,
                {triangles.data(), triangles.size()});
    const CellView view{CellType::triangle, {triangles.data(), triangles.size()}};
    write_related_nodes(file, related_nodes(points.size(), {&view, 1}), progress, 0.6, 0.9);
    write_nodes(file, points, 1, progress, 0.9, 1.0);
}

void write_solid(AtomicFile &file, const BlockModel &model, std::span<const Vec3> points,
                 std::span<const std::int32_t> cells, const Progress &progress) {
    const auto hexahedra = static_cast<std::int64_t>(cells.size() / 8);
    const auto first_centroid = static_cast<std::int64_t>(points.size());
    if (first_centroid + hexahedra > largest) {
        throw ArgumentError("mesh: its tetrahedra would have " +
                            std::to_string(first_centroid + hexahedra) +
                            " nodes; node numbers end at 2147483647");
    }
    file.write(std::to_string(hexahedra) + "\n");
    write_zones(file, model, points, cells, {}, progress, 0.0, 0.2);
    {
        const CellView view{CellType::hexahedron, cells};
        write_related_nodes(file, related_nodes(points.size(), {&view, 1}), progress, 0.2, 0.25);
    }
    write_nodes(file, points, 1, progress, 0.25, 0.3);

    require_memory(hexahedra * (12 * 16 + 24), "the tetrahedra");
    Array<std::int32_t> tetrahedra(cells.size() * 6);
    Array<Vec3> centroids(static_cast<std::size_t>(hexahedra));
    split_hexahedra(points, cells, static_cast<std::int32_t>(first_centroid),
                    {tetrahedra.data(), tetrahedra.size()}, {centroids.data(), centroids.size()});
    file.write(std::to_string(first_centroid + hexahedra) + "\n" + std::to_string(12 * hexahedra) +
               "\n");
    write_items(
        file, 12 * hexahedra, 1024 * 12,
        [&](std::int64_t first, std::int64_t last, TextBuffer &out) {
            PlaceText places(points, {centroids.data(), centroids.size()});
            for (std::int64_t z = first; z < last; ++z) {
                add_zone(out, z + 1, {tetrahedra.data() + 4 * z, 4}, places);
            }
        },
        progress, 0.3, 0.85);
    {
        const CellView view{CellType::tetra, {tetrahedra.data(), tetrahedra.size()}};
        const auto related = related_nodes(points.size() + centroids.size(), {&view, 1});
        tetrahedra = {};
        write_related_nodes(file, related, progress, 0.85, 0.95);
    }
    write_nodes(file, points, 1, progress, 0.95, 0.97);
    write_nodes(file, {centroids.data(), centroids.size()}, first_centroid + 1, progress, 0.97,
                1.0);
}

// Reading of one mesh of the file, with what its sections must agree on.
class SectionReader {
public:
    SectionReader(TextReader &reader, double tolerance, const Progress &progress)
        : reader_(reader), tolerance_(tolerance), progress_(progress) {}

    // k nodes a zone; common: CN follows; parameter: TP follows. points are set from the zones.
    void zones(std::int64_t count, std::size_t k, bool common, bool parameter,
               std::span<Vec3> points, std::int32_t *cells) {
        seen_.assign(points.size(), 0);
        std::array<std::int32_t, 8> nodes{};
        for (std::int64_t z = 0; z < count; ++z) {
            poll_every(z);
            number(z + 1, "the zone number");
            for (std::size_t i = 0; i < k; ++i) {
                nodes[i] = static_cast<std::int32_t>(
                    reader_.integer("a node number of the zone", 1,
                                    static_cast<std::int64_t>(points.size())) -
                    1);
            }
            for (std::size_t i = 0; i < k; ++i) {
                place(points, nodes[i], "a coordinate of the zone's node");
            }
            for (std::size_t i = 0; common && i < k; ++i) {
                reader_.integer("the common node parameter", 0, 1);
            }
            if (parameter) {
                reader_.integer("the triangulation parameter", 0, 1);
            }
            if (cells != nullptr) {
                std::copy_n(nodes.begin(), k, cells + static_cast<std::size_t>(z) * k);
            }
        }
    }

    void related(std::int64_t count) {
        for (std::int64_t n = 0; n < count; ++n) {
            poll_every(n);
            number(n + 1, "the node number");
            const auto size = reader_.integer("the number of related nodes", 0, count - 1);
            for (std::int64_t i = 0; i < size; ++i) {
                reader_.integer("a related node's number", 1, count);
            }
        }
    }

    // The places that count: they replace those of the zones.
    void nodes(std::span<Vec3> points) {
        for (std::size_t n = 0; n < points.size(); ++n) {
            poll_every(static_cast<std::int64_t>(n));
            number(static_cast<std::int64_t>(n) + 1, "the node number");
            seen_[n] |= 2;
            place(points, static_cast<std::int32_t>(n), "a coordinate of the node");
        }
    }

private:
    void number(std::int64_t expected, const char *what) {
        const auto word = reader_.word();
        if (reader_.integer(word, what) != expected) {
            reader_.fail(std::string(what) + " " + std::to_string(expected), word);
        }
    }
    void place(std::span<Vec3> points, std::int32_t node, const char *what) {
        Vec3 p{};
        p.x = reader_.real(what);
        p.y = reader_.real(what);
        p.z = reader_.real(what);
        auto &seen = seen_[static_cast<std::size_t>(node)];
        Vec3 &stored = points[static_cast<std::size_t>(node)];
        if ((seen & 1) != 0 && !(norm2(p - stored) <= tolerance_ * tolerance_)) {
            throw FormatError(reader_.path(), reader_.line(),
                              "expected node " + std::to_string(node + 1) +
                                  " where another zone has it, found it elsewhere");
        }
        if ((seen & 1) == 0 || (seen & 2) != 0) {
            stored = p;
        }
        seen |= 1;
    }
    void poll_every(std::int64_t i) {
        if (i % 4096 == 0) {
            poll(progress_, reader_.fraction());
        }
    }

    TextReader &reader_;
    double tolerance_;
    const Progress &progress_;
    std::vector<unsigned char> seen_; // bit 0: placed; bit 1: in the nodes section
};

double model_size(const BlockModel &model) {
    Box box;
    for (const Vec3 &p : model.nodes) {
        box.add(p);
    }
    return box.diagonal();
}

} // namespace

ResultFile read_result_file(const std::string &path, int dimension, Numbering numbering,
                            const Progress &progress) {
    TextReader reader(path, Comments::explanations);
    ResultFile file;
    setup_section::open(reader, dimension, file_ids, numbering, file.model, file.reference);
    const std::int64_t zones = cell_count(file.model);
    const std::int64_t most = std::min<std::int64_t>(lattice_count(file.model), largest);
    const std::int64_t nodes = reader.integer("the number of nodes", 4, most);
    const std::int64_t k = dimension == 3 ? 8 : 4;
    const auto exactly = [&](std::int64_t value, const char *what) {
        const auto word = reader.word();
        if (reader.integer(word, what) != value) {
            reader.fail(std::string(what) + ", which is " + std::to_string(value), word);
        }
    };
    if (dimension == 3) {
        exactly(zones, "the number of hexahedral zones");
    }
    // Division first: 10^12 zones must not overflow.
    if (zones > std::numeric_limits<std::int64_t>::max() / 128) {
        reader.require_numbers(std::numeric_limits<std::int64_t>::max(), "the zones");
    }
    reader.require_numbers(zones * (1 + 5 * k) + nodes * 6, "the zones and nodes");
    require_memory(zones * k * 4 + nodes * 25, "the mesh");

    SectionReader section(reader, 1e-6 * model_size(file.model), progress);
    file.points = Array<Vec3>(static_cast<std::size_t>(nodes));
    file.cells = Array<std::int32_t>(static_cast<std::size_t>(zones * k));
    const std::span<Vec3> points{file.points.data(), file.points.size()};
    section.zones(zones, static_cast<std::size_t>(k), true, dimension == 2, points,
                  file.cells.data());
    section.related(nodes);
    section.nodes(points);
    if (dimension == 3) {
        exactly(nodes + zones, "the number of nodes with the tetrahedra");
        exactly(12 * zones, "the number of tetrahedral zones");
        Array<Vec3> more(static_cast<std::size_t>(nodes + zones));
        const std::span<Vec3> all{more.data(), more.size()};
        section.zones(12 * zones, 4, false, false, all, nullptr);
        section.related(nodes + zones);
        section.nodes(all);
    }
    reader.expect_end();
    setup_section::check_spacing(reader, file.model);
    return file;
}

void write_result_file(const std::string &path, const BlockModel &model,
                       const std::string &reference, std::span<const Vec3> points,
                       std::span<const std::int32_t> cells, const Progress &progress) {
    validate(model);
    const auto k = static_cast<std::int64_t>(model.dimension == 3 ? 8 : 4);
    if (static_cast<std::int64_t>(cells.size()) / k != cell_count(model)) {
        throw ArgumentError("mesh: it has " +
                            std::to_string(static_cast<std::int64_t>(cells.size()) / k) +
                            " structured cells, its model " + std::to_string(cell_count(model)));
    }
    const CellView view{model.dimension == 3 ? CellType::hexahedron : CellType::quad, cells};
    check_nodes({&view, 1}, points.size());
    for (std::size_t n = 0; n < points.size(); ++n) {
        if (!is_finite(points[n])) {
            throw ArgumentError("mesh: node " + std::to_string(n + 1) + " is not finite");
        }
    }
    AtomicFile file(path);
    setup_section::write_head(file, file_ids[model.dimension - 2], reference);
    setup_section::write(file, model);
    file.write(std::to_string(points.size()) + "\n");
    if (model.dimension == 3) {
        write_solid(file, model, points, cells, progress);
    } else {
        write_surface(file, model, points, cells, progress);
    }
    setup_section::write_spacing(file, model);
    file.commit();
}

} // namespace nmgs
