// Object File Format (Geomview): OFF with the prefixes ST, C and N; text only.
#include "core/base/text.h"
#include "core/files/readers.h"

namespace tactum {
namespace {

class OffReader {
public:
    OffReader(const Source& source, const Progress& progress)
        : source_(source), progress_(progress), lines_(source.bytes()),
          meter_(progress, source.bytes().size(), 1 << 20) {}

    LoadedScene read() {
        readHeader();
        for (std::size_t i = 0; i < vertices_; ++i)
            readVertex();
        SoupBuilder builder(pools_);
        builder.reserve(faces_);
        for (std::size_t i = 0; i < faces_; ++i)
            readFace(builder);
        return finish(builder);
    }

private:
    void readHeader();
    void readCounts(std::string_view line);
    void readVertex();
    void readFace(SoupBuilder& builder);
    LoadedScene finish(SoupBuilder& builder);
    /// The next line with something on it; what is missing when the file ends instead.
    Fields nextLine(const std::string& missing);
    double number(Fields& fields) const;
    std::size_t count(Fields& fields, const char* of) const;
    [[noreturn]] void fail(const std::string& text) const { source_.failAtLine(lines_.number(), text); }

    const Source& source_;
    const Progress& progress_;
    Lines lines_;
    ProgressMeter meter_;
    VertexPools pools_;
    bool hasNormals_ = false;
    std::size_t vertices_ = 0, faces_ = 0;
    std::vector<PolygonCorner> corners_; ///< scratch
};

Fields OffReader::nextLine(const std::string& missing) {
    for (std::string_view line; lines_.next(line);) {
        demandGoingOn(meter_, lines_.offset());
        line = trimmed(line.substr(0, line.find('#')));
        if (!line.empty()) return Fields(line);
    }
    fail("the file ends before " + missing + "; it was cut short, copy it again");
}

void OffReader::readHeader() {
    Fields fields = nextLine("its header");
    std::string_view line = fields.rest();
    const std::size_t off = line.find("OFF");
    const std::string_view prefix = line.substr(0, std::min<std::size_t>(off, 8));
    if (off == std::string_view::npos ||
        (prefix != "" && prefix != "C" && prefix != "N" && prefix != "CN" && prefix != "ST" &&
         prefix != "STC" && prefix != "STN" && prefix != "STCN"))
        fail("does not start with OFF, COFF or NOFF but with " + inQuotes(line.substr(0, 20)) +
             "; re-export it");
    hasNormals_ = prefix.ends_with('N');
    line = trimmed(line.substr(off + 3));
    if (line == "BINARY") fail("is a binary OFF file, which is not read; export it as text");
    readCounts(line.empty() ? nextLine("its counts").rest() : line);
}

void OffReader::readCounts(std::string_view line) {
    Fields fields(line);
    vertices_ = count(fields, "vertices");
    faces_ = count(fields, "faces");
    const std::size_t left = source_.bytes().size() - lines_.offset();
    if (vertices_ > left / 6 + 1 || faces_ > left / 2 + 1) // "0 0 0\n" and "0\n" at least
        fail("promises " + counted(vertices_, "vertex") + " and " + counted(faces_, "face") + ", but only " +
             std::to_string(left) + " bytes follow; it was cut short, copy it again");
    pools_.positions.reserve(vertices_);
}

std::size_t OffReader::count(Fields& fields, const char* of) const {
    std::int64_t value = 0;
    const std::string_view field = fields.next();
    if (!parseNumber(field, value) || value < 0)
        fail("needs the number of " + std::string(of) + " where " + inQuotes(field) + " is; re-export it");
    return std::size_t(value);
}

double OffReader::number(Fields& fields) const {
    const std::string_view field = fields.next();
    double value = 0;
    if (!parseNumber(field, value))
        fail("vertex needs a number where " + inQuotes(field) + " is; re-export the file");
    return value;
}

void OffReader::readVertex() {
    Fields fields = nextLine("vertex " + std::to_string(pools_.positions.size()));
    Vec3 p;
    for (int i = 0; i < 3; ++i)
        p[i] = number(fields);
    if (const std::string wrong = complaintOfPlace(p); !wrong.empty()) fail("coordinate of a vertex" + wrong);
    pools_.positions.push_back(p);
    if (!hasNormals_) return;
    Vec3 n;
    for (int i = 0; i < 3; ++i)
        n[i] = number(fields);
    pools_.normals.push_back(n.cast<float>());
}

void OffReader::readFace(SoupBuilder& builder) {
    Fields fields = nextLine("its last face");
    const std::size_t size = count(fields, "corners of a face");
    if (size > kMaxCorners) fail(complaintOfCorners(size));
    corners_.clear();
    for (std::size_t i = 0; i < size; ++i) {
        std::int64_t vertex = 0;
        const std::string_view field = fields.next();
        if (!parseNumber(field, vertex))
            fail("face needs a vertex where " + inQuotes(field) + " is; re-export the file");
        if (vertex < 0 || vertex >= std::int64_t(vertices_))
            fail("face refers to vertex " + std::to_string(vertex) + ", but only " +
                 std::to_string(vertices_) + " are defined (from 0); re-export the file");
        corners_.push_back({Index(vertex), hasNormals_ ? Index(vertex) : kNone, kNone});
    }
    builder.add(corners_, 0);
}

LoadedScene OffReader::finish(SoupBuilder& builder) {
    LoadedScene loaded;
    BuildReport report;
    TriangleSoup soup = builder.finish(std::move(pools_.positions), report);
    addObject(loaded, stemOf(source_), report, std::move(soup), {namedSurface("surface")},
              Progress{{}, progress_.cancelled});
    return loaded;
}

} // namespace

LoadedScene readOff(const Source& source, const Progress& progress) {
    return OffReader(source, progress).read();
}

} // namespace tactum
