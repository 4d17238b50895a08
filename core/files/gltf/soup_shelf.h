// Equal soups as one: instances share their memory, their file space and their hierarchy.
#pragma once

#include <map>
#include <memory>

#include "core/geometry/triangle_soup.h"

namespace tactum {

/// Thread: any but real time.
class SoupShelf {
public:
    /// The first soup given that is equal to this one.
    std::shared_ptr<const TriangleSoup> shared(const std::shared_ptr<const TriangleSoup>& soup) {
        const auto [first, end] = soups_.equal_range({soup->triangles.size(), soup->positions.size()});
        int looks = 0;
        for (auto other = first; other != end && looks < kMaxLooks; ++other, ++looks)
            if (other->second == soup || *other->second == *soup) return other->second;
        soups_.emplace(std::pair{soup->triangles.size(), soup->positions.size()}, soup);
        return soup;
    }

private:
    static constexpr int kMaxLooks = 64; ///< of equal size: a thousand different cubes stay cheap
    std::multimap<std::pair<std::size_t, std::size_t>, std::shared_ptr<const TriangleSoup>> soups_;
};

} // namespace tactum
