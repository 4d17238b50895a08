// Stereolithography, text and binary. Corners at exactly the same place become one vertex; the facet normals
// are left out, since the corners' order says the same.
#include <bit>
#include <cstring>

#include "core/base/text.h"
#include "core/files/readers.h"
#include "core/geometry/weld.h"

namespace tactum {
namespace {

constexpr std::size_t kHeader = 84, kFacet = 50;

std::uint32_t littleEndian32(const char* at) {
    std::array<unsigned char, 4> b;
    std::memcpy(b.data(), at, 4);
    return b[0] | std::uint32_t(b[1]) << 8 | std::uint32_t(b[2]) << 16 | std::uint32_t(b[3]) << 24;
}

std::uint64_t promisedSize(std::string_view bytes) {
    return kHeader + kFacet * std::uint64_t(littleEndian32(bytes.data() + 80));
}

/// Many programs begin the header of a binary file with "solid"; but text has no zero bytes, and a count of
/// triangles that can be loaded has some.
bool isBinary(std::string_view bytes) {
    return lowerCase(trimmed(bytes.substr(0, 64)).substr(0, 5)) != "solid" ||
           bytes.substr(0, 1024).find('\0') != std::string_view::npos;
}

class StlReader {
public:
    StlReader(const Source& source, const Progress& progress)
        : source_(source), facets_(partOf(progress, 0, 0.7)), rest_(partOf(progress, 0.7, 1)),
          text_(source.bytes()), meter_(facets_, source.bytes().size(), 1 << 20) {}

    LoadedScene read() { return isBinary(source_.bytes()) ? readBinary() : readText(); }

private:
    LoadedScene readBinary();
    LoadedScene readText();
    void readFacet(SoupBuilder& builder);
    void readLoop(SoupBuilder& builder);
    Index vertex();
    std::string_view word();
    void expect(std::string_view wanted);
    LoadedScene finish(TriangleSoup soup, const BuildReport& report, std::vector<Surface> surfaces);
    void startSolid();
    [[noreturn]] void fail(const std::string& text) const {
        source_.failAtLine(source_.lineAt(text_.data()), text);
    }

    const Source& source_;
    Progress facets_, rest_;
    std::string_view text_; ///< what is left of it
    ProgressMeter meter_;
    PlaceTable table_;
    VertexPools pools_; ///< positions follow the table
    std::vector<Surface> surfaces_;
    std::vector<PolygonCorner> corners_; ///< scratch
};

LoadedScene StlReader::readBinary() {
    const std::string_view bytes = source_.bytes();
    if (bytes.size() < kHeader) source_.fail("is too short for an STL file; it was cut short, copy it again");
    if (promisedSize(bytes) != bytes.size())
        source_.fail("promises " + counted(littleEndian32(bytes.data() + 80), "triangle") + ", that is " +
                     std::to_string(promisedSize(bytes)) + " bytes, but has " + std::to_string(bytes.size()) +
                     "; it was cut short or is no STL file");
    const std::size_t count = (bytes.size() - kHeader) / kFacet;
    table_ = PlaceTable(count / 2 + 3);
    TriangleSoup soup;
    soup.triangles.resize(count);
    soup.surfaceOf.assign(count, 0);
    for (std::size_t f = 0; f < count; ++f) {
        const std::size_t offset = kHeader + f * kFacet;
        demandGoingOn(meter_, offset);
        const char* at = bytes.data() + offset + 12;
        for (Index& corner : soup.triangles[f]) {
            Vec3 p;
            for (int i = 0; i < 3; ++i, at += 4)
                p[i] = std::bit_cast<float>(littleEndian32(at));
            if (const std::string wrong = complaintOfPlace(p); !wrong.empty())
                source_.failAtByte(offset, "coordinate of triangle " + std::to_string(f) + wrong);
            corner = table_.numberOf(p);
        }
    }
    soup.positions = table_.takePlaces();
    return finish(std::move(soup), {}, {namedSurface("surface")});
}

std::string_view StlReader::word() {
    std::size_t start = 0;
    while (start < text_.size() && (isBlank(text_[start]) || text_[start] == '\n'))
        ++start;
    std::size_t end = start;
    while (end < text_.size() && !isBlank(text_[end]) && text_[end] != '\n')
        ++end;
    const std::string_view found = text_.substr(start, end - start);
    text_.remove_prefix(end);
    return found;
}

void StlReader::expect(std::string_view wanted) {
    const std::string_view found = word();
    if (lowerCase(found) == wanted) return;
    if (found.empty()) fail("the file ends where \"" + std::string(wanted) + "\" should be; copy it again");
    fail("\"" + std::string(wanted) + "\" is needed where " + inQuotes(found) + " is; re-export the file");
}

Index StlReader::vertex() {
    Vec3 p;
    for (int i = 0; i < 3; ++i) {
        const std::string_view field = word();
        if (!parseNumber(field, p[i]))
            fail("vertex needs a number where " + inQuotes(field) + " is; re-export the file");
    }
    if (const std::string wrong = complaintOfPlace(p); !wrong.empty()) fail("coordinate of a vertex" + wrong);
    const Index index = table_.numberOf(p);
    if (index == pools_.positions.size()) pools_.positions.push_back(p);
    return index;
}

/// The rest of the line is the name. Beyond kMaxSolids the last surface goes on.
void StlReader::startSolid() {
    const std::size_t end = std::min(text_.find('\n'), text_.size());
    const std::string_view name = trimmed(text_.substr(0, end));
    text_.remove_prefix(end);
    constexpr std::size_t kMaxSolids = 1024;
    if (surfaces_.size() < kMaxSolids)
        surfaces_.push_back(namedSurface(name.empty() ? "surface" : std::string(name)));
}

LoadedScene StlReader::readText() {
    SoupBuilder builder(pools_);
    for (std::string found = lowerCase(word()); !found.empty(); found = lowerCase(word())) {
        demandGoingOn(meter_, source_.bytes().size() - text_.size());
        if (found == "solid")
            startSolid();
        else if (found == "facet" && !surfaces_.empty())
            readFacet(builder);
        else if (found == "endsolid")
            text_.remove_prefix(std::min(text_.find('\n'), text_.size()));
        else
            fail("\"facet\" or \"endsolid\" is needed where " + inQuotes(found) + " is; re-export the file");
    }
    BuildReport report;
    TriangleSoup soup = builder.finish(std::move(pools_.positions), report);
    return finish(std::move(soup), report, std::move(surfaces_));
}

void StlReader::readFacet(SoupBuilder& builder) {
    expect("normal");
    for (int i = 0; i < 3; ++i)
        word();
    expect("outer");
    expect("loop");
    readLoop(builder);
    expect("endfacet");
}

void StlReader::readLoop(SoupBuilder& builder) {
    corners_.clear();
    for (std::string found = lowerCase(word()); found != "endloop"; found = lowerCase(word())) {
        if (found != "vertex")
            fail("\"vertex\" is needed where " + inQuotes(found) + " is; re-export the file");
        corners_.push_back({vertex(), kNone, kNone});
    }
    builder.add(corners_, Index(surfaces_.size() - 1));
}

LoadedScene StlReader::finish(TriangleSoup soup, const BuildReport& report, std::vector<Surface> surfaces) {
    LoadedScene loaded;
    addObject(loaded, stemOf(source_), report, std::move(soup), std::move(surfaces), rest_);
    return loaded;
}

} // namespace

LoadedScene readStl(const Source& source, const Progress& progress) {
    return StlReader(source, progress).read();
}

} // namespace tactum
