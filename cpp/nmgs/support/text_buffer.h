// SPDX-License-Identifier: LGPL-2.1-or-later
// Text that grows by words and numbers; the fast half of writing a text file.
#pragma once

#include "nmgs/support/numbers.h"

#include <cstdint>
#include <cstring>
#include <string_view>
#include <vector>

namespace nmgs {

class TextBuffer {
public:
    void clear() { size_ = 0; }
    [[nodiscard]] std::string_view text() const { return {data_.data(), size_}; }
    [[nodiscard]] std::size_t size() const { return size_; }

    void add(char c) { *room(1) = c, ++size_; }
    void add(std::string_view text) {
        std::memcpy(room(text.size()), text.data(), text.size());
        size_ += text.size();
    }
    void add(double value) { number(value); }
    void add(std::int64_t value) { number(value); }
    void add(std::int32_t value) { number(std::int64_t{value}); }

private:
    template <class T>
    void number(T value) {
        char *out = room(max_number_length);
        size_ += static_cast<std::size_t>(print(out, value) - out);
    }
    char *room(std::size_t more) {
        if (size_ + more > data_.size()) {
            data_.resize(2 * (size_ + more) + 256);
        }
        return data_.data() + size_;
    }

    std::vector<char> data_;
    std::size_t size_ = 0;
};

} // namespace nmgs
