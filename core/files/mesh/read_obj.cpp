// Wavefront OBJ, in two passes: first everything that can be referred to, then everything that refers.
//
// `o` starts an object. Within one, every pair of group (`g`) and material (`usemtl`) that has faces is a
// surface, named by its group, or by its material where there is no group; with both words where a group has
// several materials. Where that makes more than kMaxSurfaces, surfaces are told apart by material alone.
#include <algorithm>
#include <charconv>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <unordered_map>

#include "core/base/text.h"
#include "core/files/bump_layers.h"
#include "core/files/mesh/read_mtl.h"
#include "core/files/readers.h"

namespace tactum {
namespace {

constexpr std::size_t kMaxSurfaces = 1024;
constexpr std::size_t kMaxObjects = 100'000;
constexpr double kUnusable = std::numeric_limits<double>::quiet_NaN();

/// Words numbered in the order in which they first come; number 0 is "no word".
class Names {
public:
    Index numberOf(std::string_view word) {
        const auto [it, isNew] = numbers_.try_emplace(std::string(word), Index(words_.size()));
        if (isNew) words_.emplace_back(word);
        return it->second;
    }
    const std::string& operator[](Index number) const { return words_[number]; }

private:
    std::unordered_map<std::string, Index> numbers_{{"", 0}};
    std::vector<std::string> words_{""};
};

/// A group and a material, by number.
using Pair = std::pair<Index, Index>;

/// An object in the making.
struct Draft {
    Draft(std::string objectName, const VertexPools& pools) : name(std::move(objectName)), builder(pools) {}

    std::string name;
    SoupBuilder builder;
    std::map<Pair, Index> numberOf;
    std::vector<Pair> pairs;
};

class ObjReader {
public:
    ObjReader(const Source& source, const Progress& progress)
        : source_(source), whole_(progress), firstPass_(partOf(progress, 0.0, 0.3)),
          secondPass_(partOf(progress, 0.3, 0.7)), bumps_(source.path().parent_path()) {}

    LoadedScene read() {
        readPools();
        readElements();
        const std::size_t alone = drafts_.empty() ? pools_.positions.size() : 0;
        if (alone > 0) readCloud();
        LoadedScene loaded = finish();
        if (alone > 0) loaded.findings.push_back(noteOfCloud(alone));
        return loaded;
    }

private:
    enum class Pool { Positions, Uvs, Normals };

    /// The first word of each line, and the fields behind it.
    void eachLine(const Progress& progress, const auto& does);
    // First pass.
    void readPools();
    void readPosition(Fields fields);
    void readNormal(Fields fields);
    void readUv(Fields fields);
    double number(Fields& fields) const;
    static double numberOr(Fields& fields, double otherwise);
    // Second pass.
    void readElements();
    void readElement(std::string_view word, Fields fields);
    void readFace(Fields fields);
    void readLine(Fields fields);
    void readPoints(Fields fields);
    void readCloud();
    bool nextCorner(Fields& fields, PolygonCorner& corner);
    struct Reference {
        std::int64_t number; ///< as the file has it
        Index place;         ///< kNone: there is no such thing
    };
    static std::optional<Reference> reference(const char*& at, const char* end, std::size_t seen,
                                              std::size_t total);
    Index positionAt(const char*& at, const char* end) const;
    Index optionalAt(const char*& at, const char* end, std::size_t seen, std::size_t total);
    Draft& draft();
    Index surface();
    void startObject(std::string_view name);
    // The end.
    LoadedScene finish();
    void finishObject(LoadedScene& loaded, Draft& draft, bool alone);
    std::vector<Surface> surfacesOf(Draft& draft, LoadedScene& loaded);
    Surface surfaceOf(const Draft& draft, Pair pair, bool byMaterialOnly) const;
    void readLibraries(LoadedScene& loaded);
    void paint(Surface& surface, Index material, std::vector<Finding>& findings);

    [[noreturn]] void fail(const std::string& text) const { source_.failAtLine(line_, text); }

    const Source& source_;
    const Progress& whole_;
    Progress firstPass_, secondPass_;
    VertexPools pools_;
    std::size_t line_ = 0;
    std::size_t seenPositions_ = 0, seenUvs_ = 0, seenNormals_ = 0; ///< so far in the second pass
    std::size_t freeForms_ = 0, missing_ = 0; ///< missing: coordinates and normals of corners
    std::vector<std::string> libraries_;      ///< of materials
    MtlMaterials library_;
    BumpLayers bumps_;
    Names groups_, materials_;
    Index group_ = 0, material_ = 0;
    std::vector<std::unique_ptr<Draft>> drafts_;
    std::unordered_map<std::string, Draft*> draftOf_;
    std::string objectName_;
    Draft* draft_ = nullptr;             ///< nothing until the object has its first face
    Index surface_ = kNone;              ///< of draft_; kNone after a change of group or material
    const char* element_ = "face";       ///< what this line makes, in words
    std::vector<PolygonCorner> corners_; ///< scratch
};

void ObjReader::eachLine(const Progress& progress, const auto& does) {
    const std::string_view bytes = source_.bytes();
    ProgressMeter meter(progress, bytes.size(), 1 << 20);
    Lines lines(bytes, true);
    for (std::string_view line; lines.next(line);) {
        demandGoingOn(meter, lines.offset());
        line_ = lines.number();
        Fields fields(line);
        const std::string_view word = fields.next();
        does(word, fields);
    }
}

void ObjReader::readPools() {
    eachLine(firstPass_, [this](std::string_view word, const Fields& fields) {
        if (word == "v")
            readPosition(fields);
        else if (word == "vn")
            readNormal(fields);
        else if (word == "vt")
            readUv(fields);
    });
}

double ObjReader::number(Fields& fields) const {
    const std::string_view field = fields.next();
    double value = 0;
    if (field.empty() || !parseNumber(field, value))
        fail("vertex needs a number where " + (field.empty() ? "the line ends" : inQuotes(field) + " is") +
             "; re-export the file");
    return value;
}

/// Of what a corner can be without: what is no number makes it unusable, which whoever builds the faces
/// counts.
double ObjReader::numberOr(Fields& fields, double otherwise) {
    const std::string_view field = fields.next();
    double value = 0;
    if (field.empty() || field[0] == '#') return otherwise;
    return parseNumber(field, value) ? value : kUnusable;
}

void ObjReader::readPosition(Fields fields) {
    Vec3 p;
    for (int i = 0; i < 3; ++i)
        p[i] = number(fields);
    if (const std::string wrong = complaintOfPlace(p); !wrong.empty()) fail("coordinate of a vertex" + wrong);
    pools_.positions.push_back(p);
}

void ObjReader::readNormal(Fields fields) {
    Vec3 n;
    for (int i = 0; i < 3; ++i)
        n[i] = numberOr(fields, kUnusable);
    pools_.normals.push_back(n.cast<float>());
}

void ObjReader::readUv(Fields fields) {
    const double u = numberOr(fields, kUnusable);
    pools_.uvs.push_back(Eigen::Vector2d(u, numberOr(fields, 0)).cast<float>());
}

void ObjReader::readElements() {
    objectName_ = stemOf(source_);
    eachLine(secondPass_, [this](std::string_view word, const Fields& fields) {
        if (word == "v")
            ++seenPositions_;
        else if (word == "vt")
            ++seenUvs_;
        else if (word == "vn")
            ++seenNormals_;
        else
            readElement(word, fields);
    });
}

void ObjReader::readElement(std::string_view word, Fields fields) {
    if (word == "f" || word == "fo") return element_ = "face", readFace(fields);
    if (word == "l") return element_ = "polyline", readLine(fields);
    if (word == "p") return element_ = "point", readPoints(fields);
    if (word == "o") return startObject(fields.rest());
    if (word == "g" || word == "usemtl") {
        const std::string_view name = fields.rest() == "default" ? "" : fields.rest();
        (word == "g" ? group_ = groups_.numberOf(name) : material_ = materials_.numberOf(name));
        surface_ = kNone;
    }
    if (word == "mtllib" && libraries_.size() < 64) libraries_.emplace_back(fields.rest());
    freeForms_ += word == "curv" || word == "curv2" || word == "surf";
}

void ObjReader::readFace(Fields fields) {
    corners_.clear();
    for (PolygonCorner corner; nextCorner(fields, corner);)
        if (corners_.push_back(corner); corners_.size() > kMaxCorners)
            fail(complaintOfCorners(corners_.size()));
    draft().builder.add(corners_, surface());
}

void ObjReader::readLine(Fields fields) {
    PolygonCorner last;
    if (!nextCorner(fields, last)) return;
    for (PolygonCorner corner; nextCorner(fields, corner); last = corner)
        draft().builder.addSegment(last, corner, surface());
}

void ObjReader::readPoints(Fields fields) {
    for (PolygonCorner corner; nextCorner(fields, corner);)
        draft().builder.addPoint(corner, surface());
}

/// Reads "position", "position/uv", "position//normal" or "position/uv/normal". False at the end of the line.
bool ObjReader::nextCorner(Fields& fields, PolygonCorner& corner) {
    const std::string_view field = fields.next();
    if (field.empty() || field[0] == '#') return false;
    const char *at = field.data(), *end = at + field.size();
    corner = {};
    corner.position = positionAt(at, end);
    const auto slash = [&] { return at != end && *at == '/' && ++at; };
    if (slash() && at != end) {
        if (*at != '/') corner.uv = optionalAt(at, end, seenUvs_, pools_.uvs.size());
        if (slash() && at != end) corner.normal = optionalAt(at, end, seenNormals_, pools_.normals.size());
    }
    if (at != end) fail(element_ + (" has the corner " + inQuotes(field)) + "; re-export the file");
    return true;
}

/// The place in a pool that a number from 1, or one from -1 back from here, means. Nothing for what is no
/// number.
std::optional<ObjReader::Reference> ObjReader::reference(const char*& at, const char* end, std::size_t seen,
                                                         std::size_t total) {
    std::int64_t number = 0;
    const auto [last, fault] = std::from_chars(at, end, number);
    if (fault != std::errc()) return std::nullopt;
    at = last;
    const std::int64_t place = number > 0 ? number - 1 : std::int64_t(seen) + number;
    const bool exists = number != 0 && place >= 0 && place < std::int64_t(total);
    return Reference{number, exists ? Index(place) : kNone};
}

Index ObjReader::positionAt(const char*& at, const char* end) const {
    const std::size_t total = pools_.positions.size();
    const auto found = reference(at, end, seenPositions_, total);
    if (!found)
        fail(element_ + (" has the corner " + inQuotes({at, std::size_t(end - at)})) +
             "; re-export the file");
    if (found->place != kNone) return found->place;
    const bool back = found->number < 0; // counted from this line
    const std::size_t defined = back ? seenPositions_ : total;
    fail(element_ + (" refers to vertex " + std::to_string(found->number)) + ", but only " +
         std::to_string(defined) + (defined == 1 ? " is" : " are") + " defined" + (back ? " before it" : "") +
         "; re-export the file");
}

/// Of what a corner can be without.
Index ObjReader::optionalAt(const char*& at, const char* end, std::size_t seen, std::size_t total) {
    const auto found = reference(at, end, seen, total);
    if (!found) return kNone; // whoever reads the corner sees that it goes on
    missing_ += found->place == kNone;
    return found->place;
}

/// A scan of points alone.
void ObjReader::readCloud() {
    demandBounded(source_, 1, pools_.positions.size());
    for (Index i = 0; i < pools_.positions.size(); ++i)
        draft().builder.addPoint({i, kNone, kNone}, surface());
}

void ObjReader::startObject(std::string_view name) {
    objectName_ = name.empty() ? stemOf(source_) : std::string(name);
    draft_ = nullptr;
    surface_ = kNone;
}

/// The object that the next face belongs to; a name that comes again goes on with the first of that name.
Draft& ObjReader::draft() {
    if (draft_) return *draft_;
    draft_ = draftOf_[objectName_];
    if (draft_) return *draft_;
    if (drafts_.size() == kMaxObjects) fail("has more than 100000 objects; join some of them");
    drafts_.push_back(std::make_unique<Draft>(objectName_, pools_));
    return *(draft_ = draftOf_[objectName_] = drafts_.back().get());
}

Index ObjReader::surface() {
    if (surface_ != kNone) return surface_;
    Draft& current = draft();
    const Pair pair{group_, material_};
    const auto [it, isNew] = current.numberOf.try_emplace(pair, Index(current.pairs.size()));
    if (isNew) current.pairs.push_back(pair);
    return surface_ = it->second;
}

LoadedScene ObjReader::finish() {
    LoadedScene loaded;
    if (freeForms_ > 0)
        loaded.findings.push_back({Finding::Severity::Warning, "",
                                   counted(freeForms_, "free-form curve or surface") + " cannot be read",
                                   "convert them to polygons in the modelling program"});
    CountedFindings(loaded.findings, "")
        .add(Finding::Severity::Warning, missing_, "corner",
             "without the texture coordinate or normal that the file names",
             "(0, 0) and the face's own stand for it");
    readLibraries(loaded);
    for (auto& draft : drafts_)
        finishObject(loaded, *draft, drafts_.size() == 1);
    return loaded;
}

void ObjReader::readLibraries(LoadedScene& loaded) {
    for (const std::string& library : libraries_) {
        const auto file = insideFolder(source_.path().parent_path(), library);
        try {
            if (file.empty()) source_.fail("not in the folder of the model");
            readMaterials(file, library_, loaded.findings);
        } catch (const ReadFault&) {
            loaded.findings.push_back(
                {Finding::Severity::Note, "",
                 "material library " + inQuotes(library) + " is not beside the model or unreadable",
                 "surfaces get the colour grey; copy it into the model's folder"});
        }
    }
}

void ObjReader::finishObject(LoadedScene& loaded, Draft& draft, bool alone) {
    std::vector<Surface> surfaces = surfacesOf(draft, loaded);
    BuildReport report;
    TriangleSoup soup = alone ? draft.builder.finish(std::move(pools_.positions), report)
                              : draft.builder.finishCompact(report);
    const Progress rest = alone ? partOf(whole_, 0.7, 1.0) : Progress{{}, whole_.cancelled};
    addObject(loaded, draft.name, report, std::move(soup), std::move(surfaces), rest);
}

std::vector<Surface> ObjReader::surfacesOf(Draft& draft, LoadedScene& loaded) {
    const bool byMaterialOnly = draft.pairs.size() > kMaxSurfaces;
    std::map<Pair, Index> numberOf;
    std::vector<Index> newNumber;
    std::vector<Surface> surfaces;
    for (Pair pair : draft.pairs) {
        if (byMaterialOnly) pair.first = 0;
        if (byMaterialOnly && numberOf.size() >= kMaxSurfaces) pair.second = draft.pairs[0].second;
        const auto [it, isNew] = numberOf.try_emplace(pair, Index(surfaces.size()));
        if (isNew) {
            surfaces.push_back(surfaceOf(draft, pair, byMaterialOnly));
            paint(surfaces.back(), pair.second, loaded.findings);
        }
        newNumber.push_back(it->second);
    }
    for (Index& surface : draft.builder.surfaceOf())
        surface = newNumber[surface];
    if (byMaterialOnly)
        loaded.findings.push_back({Finding::Severity::Warning, printable(draft.name),
                                   counted(draft.pairs.size(), "group") + " are too many to be surfaces",
                                   "surfaces follow the materials instead"});
    return surfaces;
}

Surface ObjReader::surfaceOf(const Draft& draft, Pair pair, bool byMaterialOnly) const {
    const auto [group, material] = pair;
    const auto next = draft.numberOf.upper_bound({group, material});
    const auto here = draft.numberOf.find(pair);
    const bool alone =
        byMaterialOnly || ((next == draft.numberOf.end() || next->first.first != group) &&
                           (here == draft.numberOf.begin() || std::prev(here)->first.first != group));
    Surface surface;
    surface.name = group == 0 ? materials_[material] : groups_[group];
    if (group != 0 && !alone && material != 0) surface.name += " " + materials_[material];
    if (surface.name.empty()) surface.name = "surface";
    return surface;
}

/// What the material library says of it.
void ObjReader::paint(Surface& surface, Index material, std::vector<Finding>& findings) {
    const auto found = library_.find(materials_[material]);
    if (found == library_.end()) return;
    const MtlMaterial& says = found->second;
    if (says.colour) surface.colour = *says.colour;
    if (!says.bump) return;
    if (auto layer = bumps_.layerOf(*says.bump, findings)) surface.layers.push_back(std::move(*layer));
}

} // namespace

LoadedScene readObj(const Source& source, const Progress& progress) {
    return ObjReader(source, progress).read();
}

} // namespace tactum
