// SPDX-License-Identifier: AGPL-3.0-or-later
// A request as TetGen's own input.
#pragma once

#include "nmgs_tet/request.h"

#include <tetgen.h>

namespace nmgs::tet {

// The request contradicts itself: an index beyond its points, a list of another length, ...
struct InputError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

// TetGen's input structs. They view the request's memory, which must outlive them.
class Input {
public:
    // Raises InputError that names the array, the row and the value.
    explicit Input(const Request &request);
    ~Input();
    Input(const Input &) = delete;
    Input &operator=(const Input &) = delete;

    tetgenio main;
    tetgenio added;      // -i
    tetgenio background; // -m

private:
    void add_points(const Request &request);
    void add_facets(const Request &request);
    void add_tetra(const Request &request);
    void add_others(const Request &request);

    std::vector<tetgenio::polygon> polygons_;
    std::vector<tetgenio::facet> facets_;
};

} // namespace nmgs::tet
