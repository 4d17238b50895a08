// What the examinations of a mesh share: things filed under vertices, and what hangs together.
#pragma once

#include <algorithm>
#include <array>
#include <numeric>
#include <vector>

#include "core/geometry/triangle_soup.h"

namespace tactum {

using Corners = std::array<Index, 3>;

/// Which vertices hang together.
class UnionFind {
public:
    explicit UnionFind(std::size_t size) : parent_(size) {
        std::iota(parent_.begin(), parent_.end(), Index{0});
    }
    Index rootOf(Index i) {
        while (parent_[i] != i)
            i = parent_[i] = parent_[parent_[i]];
        return i;
    }
    /// True when they did not hang together before.
    bool join(Index a, Index b) {
        a = rootOf(a);
        b = rootOf(b);
        if (a == b) return false;
        parent_[std::max(a, b)] = std::min(a, b);
        return true;
    }

private:
    std::vector<Index> parent_;
};

/// Things filed under a vertex, in one array: filled in two passes, first counted, then placed.
template <class T> class FiledByVertex {
public:
    explicit FiledByVertex(std::size_t vertices) : end_(vertices + 1, 0) {}
    void count(Index vertex) { ++end_[vertex + 1]; }
    void allocate() {
        std::partial_sum(end_.begin(), end_.end(), end_.begin());
        items_.resize(end_.back());
    }
    /// After allocate() end_[v] is where the things of v begin; placing moves it to where they end.
    void place(Index vertex, T item) { items_[end_[vertex]++] = item; }
    std::size_t vertices() const { return end_.size() - 1; }
    T* begin(Index vertex) { return items_.data() + (vertex ? end_[vertex - 1] : 0); }
    T* end(Index vertex) { return items_.data() + end_[vertex]; }

private:
    std::vector<std::size_t> end_;
    std::vector<T> items_;
};

enum class Kind { Triangle, Segment, Point };

inline Kind kindOf(const Corners& t) {
    if (t[0] == t[1] && t[1] == t[2]) return Kind::Point;
    return t[0] == t[1] || t[1] == t[2] || t[2] == t[0] ? Kind::Segment : Kind::Triangle;
}

} // namespace tactum
