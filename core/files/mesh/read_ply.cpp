// Polygon File Format: text, and binary of both byte orders. One pass; the values are read by a cursor that
// knows the encoding. Read are the elements "vertex", "face", "tristrips" and "edge"; others are skipped.
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

#include "core/base/text.h"
#include "core/files/mesh/ply_header.h"
#include "core/files/readers.h"

namespace tactum {
namespace {

/// The values of a binary body.
template <bool kSwap> class BinaryCursor {
public:
    BinaryCursor(const Source& source, std::size_t offset)
        : source_(source), begin_(source.bytes().data()), at_(begin_ + offset),
          end_(begin_ + source.bytes().size()) {}

    double number(PlyType type) {
        if (type == PlyType::Float32) return take<float>();
        if (type == PlyType::Float64) return take<double>();
        return double(integer(type));
    }
    void skip(PlyType type) { number(type); }
    std::int64_t integer(PlyType type) {
        switch (type) {
        case PlyType::Int8:
            return take<std::int8_t>();
        case PlyType::Uint8:
            return take<std::uint8_t>();
        case PlyType::Int16:
            return take<std::int16_t>();
        case PlyType::Uint16:
            return take<std::uint16_t>();
        case PlyType::Int32:
            return take<std::int32_t>();
        case PlyType::Uint32:
            return take<std::uint32_t>();
        default:
            fail("a whole number is needed here, but the header says fraction; re-export the file");
        }
    }
    /// Sees that a list of that many values can be there at all.
    void demand(std::int64_t count, PlyType type) const {
        if (std::uint64_t(count) > std::uint64_t(end_ - at_) / sizeOf(type)) endOfFile();
    }
    std::size_t offset() const { return std::size_t(at_ - begin_); }
    [[noreturn]] void fail(const std::string& text) const { source_.failAtByte(offset(), text); }

private:
    [[noreturn]] void endOfFile() const {
        fail("the file ends inside its data; it was cut short, copy it again");
    }

    template <class T> T take() {
        if (std::size_t(end_ - at_) < sizeof(T)) endOfFile();
        std::array<char, sizeof(T)> bytes;
        std::memcpy(bytes.data(), at_, sizeof(T));
        at_ += sizeof(T);
        if constexpr (kSwap) std::reverse(bytes.begin(), bytes.end());
        return std::bit_cast<T>(bytes);
    }

    const Source& source_;
    const char *begin_, *at_, *end_;
};

/// The values of a text body, wherever its lines end.
class TextCursor {
public:
    TextCursor(const Source& source, std::size_t offset)
        : source_(source), at_(source.bytes().data() + offset),
          end_(source.bytes().data() + source.bytes().size()) {}

    double number(PlyType) { return take<double>(); }
    void skip(PlyType) { word(); }
    std::int64_t integer(PlyType) { return take<std::int64_t>(); }
    void demand(std::int64_t count, PlyType) const {
        if (std::uint64_t(count) > (std::uint64_t(end_ - at_) + 1) / 2)
            fail("a list of " + std::to_string(count) + " values, but the file ends before; copy it again");
    }
    std::size_t offset() const { return std::size_t(at_ - source_.bytes().data()); }
    [[noreturn]] void fail(const std::string& text) const { source_.failAtLine(source_.lineAt(at_), text); }

private:
    std::string_view word() {
        while (at_ != end_ && (isBlank(*at_) || *at_ == '\n'))
            ++at_;
        const char* start = at_;
        while (at_ != end_ && !isBlank(*at_) && *at_ != '\n')
            ++at_;
        if (start == at_) fail("the file ends inside its data; it was cut short, copy it again");
        return {start, std::size_t(at_ - start)};
    }
    template <class T> T take() {
        const std::string_view token = word();
        T value{};
        if (!parseNumber(token, value))
            fail("a number is needed where " + inQuotes(token) + " is; re-export the file");
        return value;
    }

    const Source& source_;
    const char *at_, *end_;
};

template <class Cursor> class PlyReader {
public:
    PlyReader(const Source& source, const PlyHeader& header, const Progress& progress)
        : source_(source), header_(header), body_(partOf(progress, 0, 0.7)), rest_(partOf(progress, 0.7, 1)),
          cursor_(source, header.bodyOffset), meter_(body_, source.bytes().size(), 1 << 20),
          builder_(pools_) {}

    LoadedScene read() {
        for (const PlyElement& element : header_.elements) {
            if (element.name == "vertex")
                readVertices(element);
            else if (element.name == "face")
                readFaces(element);
            else if (element.name == "tristrips")
                readStrips(element);
            else if (element.name == "edge")
                readEdges(element);
            else
                readOther(element);
        }
        LoadedScene loaded;
        std::size_t unknown = 0;
        for (const PlyElement& element : header_.elements)
            unknown +=
                std::size_t(std::ranges::count(element.properties, PlyType::Unknown, &PlyProperty::type));
        CountedFindings(loaded.findings, "")
            .add(Finding::Severity::Note, unknown, "column", "of an unknown type", "left out");
        if (builder_.triangles() == 0 && !pools_.positions.empty()) {
            readCloud();
            loaded.findings.push_back(noteOfCloud(pools_.positions.size()));
        }
        BuildReport report;
        TriangleSoup soup = builder_.finish(std::move(pools_.positions), report);
        addObject(loaded, stemOf(source_), report, std::move(soup), {namedSurface("surface")}, rest_);
        return loaded;
    }

private:
    /// Which property holds each of the values that we keep.
    using Places = std::array<std::optional<std::size_t>, 8>; // x y z nx ny nz u v

    void readVertices(const PlyElement& element);
    void readFaces(const PlyElement& element);
    void readStrips(const PlyElement& element);
    void readEdges(const PlyElement& element);
    void readOther(const PlyElement& element);
    void readCloud();
    void skip(const PlyProperty& property);
    /// Reads one element's properties; calls list(count) at the wanted one, which takes its values.
    template <class F> void eachWithList(const PlyElement& element, std::size_t wanted, F list);
    std::int64_t listLength(const PlyProperty& property);
    PolygonCorner corner(std::int64_t vertex) const;

    const Source& source_;
    const PlyHeader& header_;
    Progress body_, rest_;
    Cursor cursor_;
    ProgressMeter meter_;
    VertexPools pools_;
    SoupBuilder builder_;
    std::vector<PolygonCorner> corners_; ///< scratch
};

template <class Cursor> std::int64_t PlyReader<Cursor>::listLength(const PlyProperty& property) {
    const std::int64_t count = cursor_.integer(*property.countType);
    if (count < 0) cursor_.fail("a list of " + std::to_string(count) + " values; re-export the file");
    cursor_.demand(count, property.type);
    return count;
}

template <class Cursor> void PlyReader<Cursor>::skip(const PlyProperty& property) {
    const std::int64_t count = property.countType ? listLength(property) : 1;
    for (std::int64_t i = 0; i < count; ++i)
        cursor_.skip(property.type);
}

template <class Cursor> void PlyReader<Cursor>::readOther(const PlyElement& element) {
    if (element.properties.empty()) return; // takes no bytes, however often
    for (std::uint64_t i = 0; i < element.count; ++i) {
        demandGoingOn(meter_, cursor_.offset());
        for (const PlyProperty& property : element.properties)
            skip(property);
    }
}

template <class Cursor> void PlyReader<Cursor>::readVertices(const PlyElement& element) {
    const Places places{element.find({"x"}),
                        element.find({"y"}),
                        element.find({"z"}),
                        element.find({"nx"}),
                        element.find({"ny"}),
                        element.find({"nz"}),
                        element.find({"u", "s", "texture_u"}),
                        element.find({"v", "t", "texture_v"})};
    if (!places[0] || !places[1] || !places[2])
        source_.fail("its vertices have no x, y and z; re-export the file");
    const bool hasNormals = places[3] && places[4] && places[5], hasUvs = places[6] && places[7];
    std::vector<std::size_t> targetOf(element.properties.size(), places.size());
    for (std::size_t i = 0; i < places.size(); ++i)
        if (places[i] && !element.properties[*places[i]].countType) targetOf[*places[i]] = i;
    pools_.positions.reserve(pools_.positions.size() + element.count);
    std::array<double, 8> values{};
    for (std::uint64_t i = 0; i < element.count; ++i) {
        demandGoingOn(meter_, cursor_.offset());
        for (std::size_t k = 0; k < element.properties.size(); ++k) {
            const PlyProperty& property = element.properties[k];
            if (property.countType || targetOf[k] == places.size())
                skip(property);
            else
                values[targetOf[k]] = cursor_.number(property.type);
        }
        const Vec3 p(values[0], values[1], values[2]);
        if (const std::string wrong = complaintOfPlace(p); !wrong.empty())
            cursor_.fail("coordinate of vertex " + std::to_string(i) + wrong);
        pools_.positions.push_back(p);
        if (hasNormals) pools_.normals.push_back(Vec3(values[3], values[4], values[5]).cast<float>());
        if (hasUvs) pools_.uvs.push_back(Eigen::Vector2d(values[6], values[7]).cast<float>());
    }
}

template <class Cursor> PolygonCorner PlyReader<Cursor>::corner(std::int64_t vertex) const {
    if (vertex < 0 || vertex >= std::int64_t(pools_.positions.size()))
        cursor_.fail("face refers to vertex " + std::to_string(vertex) + ", but only " +
                     std::to_string(pools_.positions.size()) + " are defined (from 0); re-export the file");
    const Index index = Index(vertex);
    return {index, pools_.normals.empty() ? kNone : index, pools_.uvs.empty() ? kNone : index};
}

template <class Cursor>
template <class F>
void PlyReader<Cursor>::eachWithList(const PlyElement& element, std::size_t wanted, F list) {
    for (std::uint64_t i = 0; i < element.count; ++i) {
        demandGoingOn(meter_, cursor_.offset());
        for (std::size_t k = 0; k < element.properties.size(); ++k) {
            const PlyProperty& property = element.properties[k];
            if (k == wanted)
                list(listLength(property), property.type);
            else
                skip(property);
        }
    }
}

template <class Cursor> void PlyReader<Cursor>::readFaces(const PlyElement& element) {
    const auto wanted = element.find({"vertex_indices", "vertex_index"});
    if (element.count > 0 && (!wanted || !element.properties[*wanted].countType))
        source_.fail("its faces have no list of vertex_indices; re-export the file");
    builder_.reserve(element.count);
    eachWithList(element, wanted.value_or(0), [&](std::int64_t count, PlyType type) {
        corners_.clear();
        for (std::int64_t i = 0; i < count; ++i)
            corners_.push_back(corner(cursor_.integer(type)));
        if (corners_.size() > kMaxCorners) cursor_.fail(complaintOfCorners(corners_.size()));
        builder_.add(corners_, 0);
    });
}

/// Strips of triangles in one list, separated by -1; every other triangle of a strip is wound the other way.
template <class Cursor> void PlyReader<Cursor>::readStrips(const PlyElement& element) {
    const auto wanted = element.find({"vertex_indices", "vertex_index"});
    if (!wanted || !element.properties[*wanted].countType) return readOther(element);
    eachWithList(element, *wanted, [&](std::int64_t count, PlyType type) {
        corners_.clear();
        for (std::int64_t i = 0; i < count; ++i) {
            const std::int64_t vertex = cursor_.integer(type);
            if (vertex == -1) {
                corners_.clear();
                continue;
            }
            corners_.push_back(corner(vertex));
            const std::size_t n = corners_.size();
            if (n < 3) continue;
            const bool odd = n % 2 == 0;
            const std::array t{corners_[n - 3], corners_[n - (odd ? 1 : 2)], corners_[n - (odd ? 2 : 1)]};
            const bool stitch = t[0].position == t[1].position || t[1].position == t[2].position ||
                                t[2].position == t[0].position;
            if (!stitch) builder_.add(t, 0); // stitches only join strips
        }
    });
}

/// A scan: every vertex is a point.
template <class Cursor> void PlyReader<Cursor>::readCloud() {
    demandBounded(source_, 1, pools_.positions.size());
    for (std::size_t i = 0; i < pools_.positions.size(); ++i)
        builder_.addPoint(corner(std::int64_t(i)), 0);
}

template <class Cursor> void PlyReader<Cursor>::readEdges(const PlyElement& element) {
    const auto first = element.find({"vertex1"}), second = element.find({"vertex2"});
    if (!first || !second) return readOther(element);
    for (std::uint64_t i = 0; i < element.count; ++i) {
        demandGoingOn(meter_, cursor_.offset());
        std::array<std::int64_t, 2> ends{};
        for (std::size_t k = 0; k < element.properties.size(); ++k) {
            const PlyProperty& property = element.properties[k];
            if (property.countType || (k != *first && k != *second))
                skip(property);
            else
                ends[k == *second] = cursor_.integer(property.type);
        }
        builder_.addSegment(corner(ends[0]), corner(ends[1]), 0);
    }
}

} // namespace

LoadedScene readPly(const Source& source, const Progress& progress) {
    const PlyHeader header = readPlyHeader(source);
    switch (header.encoding) {
    case PlyHeader::Encoding::Ascii:
        return PlyReader<TextCursor>(source, header, progress).read();
    case PlyHeader::Encoding::LittleEndian:
        return PlyReader<BinaryCursor<false>>(source, header, progress).read();
    default:
        return PlyReader<BinaryCursor<true>>(source, header, progress).read();
    }
}

} // namespace tactum
