// 3MF by its core specification 1.3: the items of the build, each an object or what it is put together from,
// down to meshes, which are the objects here. Base materials become surfaces. Of the production extension the
// parts that lie in files of their own are read. z is up, from the bed of the printer.
#include <algorithm>
#include <charconv>
#include <map>
#include <memory>
#include <numbers>
#include <optional>

#include "core/archive/zip_archive.h"
#include "core/base/text.h"
#include "core/files/mesh/threemf_part.h"
#include "core/files/world_mesh.h"

namespace tactum {
namespace {

using Affine = Eigen::Affine3d;
using Severity = Finding::Severity;

/// The colour of a base material, "#RRGGBB" or with its opacity behind.
std::optional<Eigen::Vector3f> colourOf(std::string_view text) {
    Eigen::Vector3f colour;
    if ((text.size() != 7 && text.size() != 9) || text[0] != '#') return std::nullopt;
    for (int i = 0; i < 3; ++i) {
        const char* digits = text.data() + 1 + 2 * i;
        unsigned value = 0;
        if (std::from_chars(digits, digits + 2, value, 16).ptr != digits + 2) return std::nullopt;
        colour[i] = float(value) / 255;
    }
    return colour;
}

class ThreeMfReader {
public:
    ThreeMfReader(const Source& source, const Progress& progress) : source_(source), progress_(progress) {}

    LoadedScene read() {
        ThreeMfPart& root = part(modelName());
        const Affine upright(Eigen::AngleAxisd(-std::numbers::pi / 2, Vec3::UnitX()));
        const Affine toWorld = upright * Eigen::Scaling(unitOf(root.model()));
        for (const XmlNode item : childOf(root.model(), "build").children())
            if (localName(item.name()) == "item") visit(root, item, toWorld);
        ProgressMeter meter(progress_, shown_.size(), 1);
        for (std::size_t i = 0; i < shown_.size(); ++i) {
            demandGoingOn(meter, i);
            add(shown_[i]);
        }
        sayWhatIsLeftOut();
        return std::move(loaded_);
    }

private:
    struct Mesh {
        std::string name;
        std::vector<Vec3> positions;
        std::vector<std::array<Index, 3>> triangles;
        std::vector<Index> surfaceOf; ///< of each triangle
        std::vector<Surface> surfaces;
    };
    struct Shown {
        const Mesh* mesh;
        Affine toWorld;
    };

    /// XML is packed to a tenth at most: what grows a hundredfold is there to fill the memory, and as a tree
    /// of nodes it would be twenty times as large.
    std::string bytesOf(const std::string& name) const {
        constexpr std::size_t kCalm = std::size_t(8) << 20;
        const std::size_t most = std::clamp(kZipRatio * source_.bytes().size(), kCalm, kZipEntryBytes);
        auto bytes = fileInZip(source_.bytes(), name, most);
        if (!bytes) source_.fail(bytes.error().text);
        return std::move(*bytes);
    }

    std::string nameInFile(const std::string& part) const { return source_.name() + ": " + part; }

    /// The part that the package begins with.
    std::string modelName() const {
        constexpr const char* kRelations = "_rels/.rels";
        const Source source = Source::ofBytes(nameInFile(kRelations), bytesOf(kRelations));
        const XmlDocument relations(source);
        for (const XmlNode each : relations.root().children())
            if (std::string_view(each.attribute("Type").value()).ends_with("/3dmodel"))
                return each.attribute("Target").value();
        source.fail("names no 3-D model; export it as 3MF again");
    }

    /// Read once; `path` as the package names it, from its root.
    ThreeMfPart& part(std::string path) {
        constexpr std::size_t kMostParts = 4096;
        path.erase(0, path.find_first_not_of('/'));
        std::unique_ptr<ThreeMfPart>& found = parts_[path];
        if (parts_.size() > kMostParts) source_.fail("has more than 4096 model files; join them");
        if (!found) found = std::make_unique<ThreeMfPart>(nameInFile(path), bytesOf(path));
        return *found;
    }

    /// In metres.
    double unitOf(XmlNode model) {
        constexpr std::pair<std::string_view, double> kUnits[] = {{"millimeter", 1e-3}, {"micron", 1e-6},
                                                                  {"centimeter", 1e-2}, {"inch", 0.0254},
                                                                  {"foot", 0.3048},     {"meter", 1.0}};
        const auto unit = model.attribute("unit");
        for (const auto& [name, metres] : kUnits)
            if (!unit || unit.value() == name) return metres;
        loaded_.findings.push_back({Severity::Warning, "",
                                    "has the unit " + inQuotes(unit.value()) + ", which 3MF does not know",
                                    "taken as millimetres; scale it if that is not its size"});
        return 1e-3;
    }

    /// What an item or a component refers to.
    void visit(ThreeMfPart& from, XmlNode reference, const Affine& above) {
        constexpr std::size_t kMostVisits = 1'000'000;
        const std::string_view path = attributeOf(reference, "path");
        ThreeMfPart& of = path.empty() ? from : part(std::string(path));
        const std::string_view id = reference.attribute("objectid").value();
        const XmlNode object = of.resource(id, "object");
        if (!object)
            from.fail(reference,
                      "refers to the object " + inQuotes(id) + ", which is not there; export it again");
        if (++visits_ > kMostVisits)
            from.fail(reference, "is one part too many; export it with fewer copies");
        const Affine toWorld = above * from.transform(reference);
        if (const XmlNode mesh = childOf(object, "mesh")) return show(meshOf(of, object, mesh), toWorld);
        const XmlNode components = childOf(object, "components");
        empty_ += !components;
        demandNoCircle(from, reference, object);
        inside_.push_back(object);
        for (const XmlNode component : components.children())
            if (localName(component.name()) == "component") visit(of, component, toWorld);
        inside_.pop_back();
    }

    void demandNoCircle(const ThreeMfPart& from, XmlNode reference, XmlNode object) const {
        constexpr std::size_t kDeepest = 128;
        if (std::find(inside_.begin(), inside_.end(), object) != inside_.end())
            from.fail(reference, "puts the object " + inQuotes(object.attribute("id").value()) +
                                     " inside itself; take it out");
        if (inside_.size() == kDeepest) from.fail(reference, "lies deeper than 128 levels; flatten it");
    }

    void show(const Mesh& mesh, const Affine& toWorld) {
        shown_.push_back({&mesh, toWorld});
        triangles_ += mesh.triangles.size();
        demandBounded(source_, shown_.size(), triangles_);
    }

    const Mesh& meshOf(const ThreeMfPart& part, XmlNode object, XmlNode node) {
        const auto [found, isNew] = meshes_.try_emplace(object.internal_object());
        Mesh& mesh = found->second;
        if (!isNew) return mesh;
        mesh.name = object.attribute("name").value();
        lattices_ += bool(childOf(node, "beamlattice"));
        for (const XmlNode vertex : childOf(node, "vertices").children())
            if (localName(vertex.name()) == "vertex")
                mesh.positions.emplace_back(part.number(vertex, "x"), part.number(vertex, "y"),
                                            part.number(vertex, "z"));
        std::map<XmlNode, Index> surfaces;
        for (const XmlNode triangle : childOf(node, "triangles").children()) {
            if (localName(triangle.name()) != "triangle") continue;
            auto& corners = mesh.triangles.emplace_back();
            for (std::size_t i = 0; i < 3; ++i)
                corners[i] = Index(part.index(triangle, kCorners[i], mesh.positions.size()));
            const XmlNode material = materialOf(part, object, triangle);
            const auto [surface, isFirst] = surfaces.try_emplace(material, Index(surfaces.size()));
            if (isFirst) mesh.surfaces.push_back(surfaceOf(material));
            mesh.surfaceOf.push_back(surface->second);
        }
        return mesh;
    }

    /// The base material of a triangle, or that of its object; empty for none. What else may be there,
    /// colours and pictures, is for the eye.
    XmlNode materialOf(const ThreeMfPart& part, XmlNode object, XmlNode triangle) {
        const auto either = [&](const char* own, const char* ofObject) {
            const auto found = triangle.attribute(own);
            return found ? found : object.attribute(ofObject);
        };
        const XmlNode group = part.resource(either("pid", "pid").value(), "basematerials");
        if (!group) return {};
        const auto known = bases_.try_emplace(group.internal_object());
        std::vector<XmlNode>& bases = known.first->second;
        if (known.second) bases.assign(group.children().begin(), group.children().end());
        std::int64_t place = -1;
        const bool isThere = parseNumber(either("p1", "pindex").value(), place) && place >= 0 &&
                             std::size_t(place) < bases.size();
        strange_ += !isThere;
        return isThere ? bases[std::size_t(place)] : XmlNode();
    }

    static Surface surfaceOf(XmlNode material) {
        const auto name = material.attribute("name");
        Surface surface = namedSurface(name ? name.value() : "surface");
        if (const auto colour = colourOf(material.attribute("displaycolor").value()))
            surface.colour = *colour;
        return surface;
    }

    void add(const Shown& shown) {
        const Mesh& mesh = *shown.mesh;
        WorldMesh world(source_, shown.toWorld);
        for (const Vec3& p : mesh.positions)
            world.position(p, false);
        for (std::size_t f = 0; f < mesh.triangles.size(); ++f) {
            std::vector<PolygonCorner> corners(3);
            for (std::size_t i = 0; i < 3; ++i)
                corners[i].position = mesh.triangles[f][i];
            world.polygon(std::move(corners), mesh.surfaceOf[f]);
        }
        world.addTo(loaded_, mesh.name.empty() ? stemOf(source_) : mesh.name, mesh.surfaces, progress_);
    }

    void sayWhatIsLeftOut() {
        const std::string ofScene;
        CountedFindings say(loaded_.findings, ofScene);
        say.add(Severity::Warning, empty_, "object", "with neither mesh nor components left out",
                "export it again if it should be felt");
        say.add(Severity::Warning, lattices_, "beam lattice", "left out", "export it as a mesh");
        say.add(Severity::Warning, strange_, "triangle", "with a material that is not there",
                "it gets a surface without one");
    }

    static constexpr const char* kCorners[] = {"v1", "v2", "v3"};

    const Source& source_;
    const Progress& progress_;
    LoadedScene loaded_;
    std::map<std::string, std::unique_ptr<ThreeMfPart>> parts_;
    std::map<const void*, Mesh> meshes_;                ///< by the node of their object
    std::map<const void*, std::vector<XmlNode>> bases_; ///< by the node of their group
    std::vector<XmlNode> inside_;                       ///< the objects that are being put together
    std::vector<Shown> shown_;
    std::uint64_t triangles_ = 0;
    std::size_t visits_ = 0, empty_ = 0, lattices_ = 0, strange_ = 0;
};

} // namespace

LoadedScene read3mf(const Source& source, const Progress& progress) {
    return ThreeMfReader(source, progress).read();
}

} // namespace tactum
