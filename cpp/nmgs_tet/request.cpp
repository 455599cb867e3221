// SPDX-License-Identifier: AGPL-3.0-or-later
#include "nmgs_tet/request.h"

#include "nmgs_tet/limits.h"

#include <array>

namespace nmgs::tet {

std::size_t Request::rows(In id) const {
    const auto found = arrays.find(id);
    return found == arrays.end() ? 0 : found->second.rows;
}

std::size_t Request::columns(In id) const {
    const auto found = arrays.find(id);
    return found == arrays.end() ? 0 : found->second.columns;
}

void *Request::data(In id, Scalar scalar) const {
    const auto found = arrays.find(id);
    if (found == arrays.end() || found->second.rows * found->second.columns == 0) {
        return nullptr;
    }
    if (found->second.scalar != scalar) {
        throw ProtocolError("array " + std::to_string(static_cast<std::uint32_t>(id)) +
                            ": wrong scalar");
    }
    return found->second.data.get();
}

double *Request::doubles(In id) const {
    return static_cast<double *>(data(id, Scalar::float64));
}
std::int32_t *Request::ints(In id) const {
    return static_cast<std::int32_t *>(data(id, Scalar::int32));
}
std::int64_t *Request::longs(In id) const {
    return static_cast<std::int64_t *>(data(id, Scalar::int64));
}
std::string Request::text(In id) const {
    const auto *bytes = static_cast<const char *>(data(id, Scalar::bytes));
    return bytes == nullptr ? std::string() : std::string(bytes, rows(id) * columns(id));
}

Request read_request(int descriptor) {
    const FrameHeader hello = read_header(descriptor);
    std::array<std::int64_t, 2> terms{};
    if (hello.kind != static_cast<std::uint32_t>(Kind::hello) ||
        hello.scalar != static_cast<std::uint32_t>(Scalar::int64) ||
        hello.rows * hello.columns != terms.size()) {
        throw ProtocolError("the request does not begin with 'hello'");
    }
    read_exactly(descriptor, terms.data(), sizeof terms);
    if (terms[0] != protocol_version) {
        throw ProtocolError("the request speaks version " + std::to_string(terms[0]) +
                            " of the protocol, this worker version " +
                            std::to_string(protocol_version));
    }
    Request request;
    request.memory_limit = terms[1];
    limit_memory(request.memory_limit);
    for (;;) {
        const FrameHeader header = read_header(descriptor);
        if (header.kind == static_cast<std::uint32_t>(Kind::go)) {
            return request;
        }
        InArray array{static_cast<Scalar>(header.scalar), header.rows, header.columns, nullptr};
        const std::size_t size = array.rows * array.columns * scalar_size(array.scalar);
        if (size > 0) {
            array.data = std::make_unique_for_overwrite<std::byte[]>(size);
            read_exactly(descriptor, array.data.get(), size);
        }
        request.arrays.insert_or_assign(static_cast<In>(header.kind), std::move(array));
    }
}

} // namespace nmgs::tet
