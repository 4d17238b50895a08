// What several values share, and the layers of a surface, as bytes: the same lines write and read.
#pragma once

#include <memory>
#include <string>
#include <unordered_map>
#include <vector>

#include "core/base/byte_stream.h"
#include "core/surface/texture_layer.h"

namespace tactum {

/// Things that several values may share, each once.
template <class T> struct SharedTable {
    std::vector<std::shared_ptr<const T>> items;
    std::unordered_map<const T*, std::uint32_t> numbers; ///< from 1, only while writing
};

/// A reference into a table: 0 for none. Writing fills the table.
template <class Io, class T> void link(Io& io, std::shared_ptr<const T>& to, SharedTable<T>& table) {
    std::uint32_t number = 0;
    if constexpr (!Io::kReads)
        if (to) {
            const auto [place, isNew] =
                table.numbers.try_emplace(to.get(), std::uint32_t(table.items.size()) + 1);
            if (isNew) table.items.push_back(to);
            number = place->second;
        }
    io(number);
    io.demand(number <= table.items.size(), "it names what it does not have");
    if constexpr (Io::kReads) to = number == 0 ? nullptr : table.items[number - 1];
}

/// Values of a parameter table by their keys: a recording outlives a change of the table.
template <class Io, class Table, class Values> void numbersByKey(Io& io, const Table& table, Values& values) {
    std::uint32_t count = std::uint32_t(table.size());
    io(count);
    for (std::uint32_t i = 0; i < count; ++i) {
        std::string key;
        double value = 0;
        if constexpr (!Io::kReads) {
            key = std::string(table[i].parameter->key);
            value = values.*table[i].value;
        }
        io(key), io(value);
        if constexpr (Io::kReads)
            for (const auto& field : table)
                if (field.parameter->key == key) values.*field.value = value;
    }
}

/// What layers share.
struct LayerTables {
    SharedTable<TextureImage> images;
    SharedTable<PaintedValues> paints;
};

template <class Io> void patternBytes(Io& io, TexturePattern& p, LayerTables& tables) {
    // All members: another one does not compile. Those without a use here are in kPatternFields.
    auto& [source, image, painted, mapping, size, offsetU, offsetV, rotation, frame, radius, fill, softness,
           octaves, seed] = p;
    choose(io, source, kTextureSources.size());
    choose(io, mapping, kTextureMappings.size());
    link(io, image, tables.images);
    link(io, painted.values, tables.paints);
    io(frame);
    numbersByKey(io, kPatternFields, p);
}

template <class Io> void layerBytes(Io& io, TextureLayer& l, LayerTables& tables) {
    auto& [name, enabled, pattern, target, strength, blend, opacity, mask, ownPlane] = l;
    io(name), io(enabled), io(strength), io(opacity), io(ownPlane);
    choose(io, target, kTextureTargets.size());
    choose(io, blend, kTextureBlends.size());
    patternBytes(io, pattern, tables);
    bool masked = mask.has_value();
    io(masked);
    if (!masked) return;
    if (!mask) mask.emplace();
    patternBytes(io, *mask, tables);
}

} // namespace tactum
