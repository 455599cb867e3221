// SPDX-License-Identifier: LGPL-2.1-or-later
// Array: contiguous memory that is not written before its user writes it, unlike std::vector.
// A mesh of 100 million cells is filled once, by many threads, and handed to NumPy without a copy.
#pragma once

#include "nmgs/support/memory.h"

#include <cstddef>
#include <memory>
#include <span>
#include <type_traits>

namespace nmgs {

template <class T>
class Array {
    static_assert(std::is_trivially_copyable_v<T>);

public:
    Array() = default;
    explicit Array(std::size_t size)
        : data_(size == 0 ? nullptr : static_cast<T *>(allocate(size, sizeof(T)))), size_(size) {}

    [[nodiscard]] std::size_t size() const { return size_; }
    // Forgets the elements from size on; their memory stays with the array.
    void shrink(std::size_t size) { size_ = size < size_ ? size : size_; }
    [[nodiscard]] bool empty() const { return size_ == 0; }
    T *data() { return data_.get(); }
    const T *data() const { return data_.get(); }
    T &operator[](std::size_t i) { return data_[i]; }
    const T &operator[](std::size_t i) const { return data_[i]; }
    T *begin() { return data(); }
    T *end() { return data() + size_; }
    const T *begin() const { return data(); }
    const T *end() const { return data() + size_; }

private:
    struct Release {
        void operator()(T *memory) const { release(memory); }
    };
    std::unique_ptr<T[], Release> data_;
    std::size_t size_ = 0;
};

} // namespace nmgs
