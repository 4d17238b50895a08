// X3D in its XML form, with H3D's haptic nodes. Every Shape is an object in the world's frame. The unit of
// X3D is the metre unless its head says another one, its y axis points up.
#include <map>

#include "core/base/text.h"
#include "core/files/x3d/x3d_geometry.h"
#include "core/files/x3d/x3d_metadata.h"
#include "core/files/x3d/x3d_surface.h"
#include "core/scene/value_checks.h"

namespace tactum {
namespace {

using Affine = Eigen::Affine3d;
using Severity = Finding::Severity;

Eigen::AngleAxisd turnOf(const std::vector<double>& r) {
    const Vec3 axis(r[0], r[1], r[2]);
    return {r[3], axis.norm() > 0 ? axis.normalized().eval() : Vec3::UnitZ().eval()};
}

class X3dReader {
public:
    X3dReader(const Source& source, const Progress& progress)
        : source_(source), progress_(progress), document_(source),
          surfaces_(document_, source, loaded_.findings) {}

    LoadedScene read() {
        Place root;
        root.toWorld.scale(unit());
        visit(document_.scene(), root, 0);
        if (const auto radius = surfaces_.proxyRadius()) loaded_.scene.proxyRadius = *radius;
        sayWhatIsLeftOut();
        return std::move(loaded_);
    }

private:
    /// What a node gets from those above it.
    struct Place {
        Affine toWorld = Affine::Identity();
        std::string name;
        bool isNamedByUs = false; ///< by our metadata, which no DEF below it overrules
        bool isHidden = false;    ///< in a Switch of ours that shows nothing
    };

    /// An object that our own writer made: a Shape for each surface and kind of face.
    struct Ours {
        Ours(const Source& source, const Place& at) : mesh(source, at.toWorld), place(at) {}

        WorldMesh mesh;
        Place place;
        std::vector<Surface> surfaces;
    };

    /// Of the file's lengths, in metres: <unit category="length" conversionFactor="0.001"/> in its head.
    double unit() {
        double factor = 1;
        for (const X3dNode unit : document_.all({"unit"})) {
            const std::string_view category = unit.attribute("category").value();
            if (category == "length") factor = document_.number(unit, "conversionFactor", 1);
            if (category == "angle" && document_.number(unit, "conversionFactor", 1) != 1)
                document_.fail(unit, "gives angles in another unit than radian; export it in radian");
            if (!(factor > 0)) document_.fail(unit, "has a length of nothing; export it again");
        }
        return factor;
    }

    static Place namedPlace(X3dNode node, const Place& parent) {
        Place place = parent;
        const auto ours = X3dDocument::metadata(node, kX3dObjectSet, "name");
        if (ours)
            place.name = *ours;
        else if (const auto def = node.attribute("DEF"); def && !parent.isNamedByUs)
            place.name = def.value();
        place.isNamedByUs = ours || parent.isNamedByUs;
        return place;
    }

    void visit(X3dNode given, const Place& parent, int depth) {
        constexpr int kDeepest = 128;
        constexpr std::size_t kMaxVisits = 1'000'000;
        const X3dNode node = document_.resolved(given);
        if (!node) return;
        if (depth > kDeepest)
            document_.fail(node, "lies deeper than 128 levels, or inside itself; flatten it");
        if (++visits_ > kMaxVisits)
            document_.fail(node, "is used too often; export the scene with fewer copies");
        if (progress_.isCancelled()) throw ReadFault{cancelledError().value()};
        const std::string_view kind = node.name();
        Place here = namedPlace(node, parent);
        if (kind == "Shape") return addShape(node, here);
        if (kind == "Inline") ++inlines_;
        if (kind == "Inline" || kind == "ProtoDeclare" || kind == "Appearance") return;
        if (kind == "RigidBodyCollection") return; // shapes for bodies to meet, which nobody sees
        here.toWorld = here.toWorld * transformOf(node);
        const bool begins = !ours_ && X3dDocument::metadata(node, kX3dObjectSet, "name");
        if (begins)
            ours_.emplace(source_, here), here.isHidden = false; // from here on it is a surface that is
        const bool hides = isHiddenByUs(node);
        here.isHidden |= hides;
        int number = 0;
        for (const X3dNode child : node.children()) {
            if (child.type() != pugi::node_element || !(isChosen(node, number++) || hides)) continue;
            visit(child, here, depth + 1);
        }
        if (begins) endOurs();
    }

    /// Our writer hides an object or a surface by a Switch around it.
    bool isHiddenByUs(X3dNode node) const {
        if (node.name() != std::string_view("Switch") || document_.number(node, "whichChoice", -1) != -1)
            return false;
        return ours_ || X3dDocument::metadata(node.first_child(), kX3dObjectSet, "name");
    }

    void endOurs() {
        Ours& ours = *ours_;
        const std::size_t before = loaded_.scene.objects.size();
        if (ours.mesh.positions() > 0)
            ours.mesh.addTo(loaded_, ours.place.name, std::move(ours.surfaces), progress_);
        if (loaded_.scene.objects.size() > before)
            loaded_.scene.objects.back().visible = !ours.place.isHidden;
        ours_.reset();
    }

    /// One that is there already goes on: its lines and points are Shapes of their own.
    Index surfaceOfOurs(X3dNode shape, bool isHidden) {
        Surface surface = surfaces_.surfaceOf(shape);
        surface.visible = !isHidden;
        std::vector<Surface>& all = ours_->surfaces;
        const auto known = std::ranges::find_if(all, [&](const Surface& other) {
            return other.name == surface.name && other.material == surface.material &&
                   other.visible == surface.visible;
        });
        const Index number = Index(known - all.begin());
        if (known == all.end()) all.push_back(std::move(surface));
        return number;
    }

    /// A Switch shows one of its children, an LOD the first, which is the finest.
    bool isChosen(X3dNode node, int number) const {
        const std::string_view kind = node.name();
        if (kind == "Switch") return number == int(document_.number(node, "whichChoice", -1));
        return kind != "LOD" || number == 0;
    }

    Affine transformOf(X3dNode node) const {
        const std::string_view kind = node.name();
        Affine local = Affine::Identity();
        const auto vector = [&](const char* field, double otherwise) {
            return Vec3(document_.tuple(node, field, {otherwise, otherwise, otherwise}).data());
        };
        const auto turn = [&](const char* field) {
            return turnOf(document_.tuple(node, field, {0, 0, 1, 0}));
        };
        if (kind == "Transform") {
            const Vec3 centre = vector("center", 0);
            const auto scaleTurn = turn("scaleOrientation");
            local.translate(vector("translation", 0)).translate(centre).rotate(turn("rotation"));
            local.rotate(scaleTurn).scale(vector("scale", 1)).rotate(scaleTurn.inverse()).translate(-centre);
        }
        if (kind == "DynamicTransform") // of H3D: a free body, at rest here
            local.translate(vector("position", 0)).rotate(turn("orientation"));
        if (kind == "MatrixTransform") { // of H3D: column by column
            const auto m = document_.tuple(node, "matrix", {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1});
            local.matrix() = Eigen::Map<const Eigen::Matrix4d>(m.data());
            if (local.matrix().row(3) != Eigen::RowVector4d(0, 0, 0, 1))
                document_.fail(node, "has a matrix that is not affine; export it again");
        }
        return local;
    }

    /// Every use of a shape is a mesh of its own, so that a few lines could ask for any number of them.
    void demandBounded(X3dNode shape, std::size_t positions) {
        constexpr std::size_t kMaxShapes = 20'000, kMaxCopied = 10'000'000,
                              kLeastOfOne = 6; // bytes: "0 0 0,"
        const std::size_t most = kMaxCopied + source_.bytes().size() / kLeastOfOne;
        positions_ += positions;
        if (++shapes_ > kMaxShapes)
            document_.fail(shape, "is the " + std::to_string(shapes_) +
                                      "th shape to be shown; join shapes, or export fewer copies");
        if (positions_ > most && shapes_ > 1)
            document_.fail(shape, "brings the copies of all shapes to more than 10 million vertices; export "
                                  "fewer copies");
    }

    void addShape(X3dNode shape, const Place& place) {
        if (ours_) {
            const std::size_t before = ours_->mesh.positions();
            ours_->mesh.moveTo(place.toWorld);
            addGeometries(shape, ours_->mesh, surfaceOfOurs(shape, place.isHidden), true);
            return demandBounded(shape, ours_->mesh.positions() - before);
        }
        WorldMesh mesh(source_, place.toWorld);
        addGeometries(shape, mesh, 0, false);
        if (mesh.positions() == 0) return;
        demandBounded(shape, mesh.positions());
        mesh.addTo(loaded_, place.name.empty() ? stemOf(source_) : place.name, {surfaces_.surfaceOf(shape)},
                   progress_);
        if (progress_.report)
            progress_.report(std::min(1.0, double(shape.offset_debug()) / double(source_.bytes().size())));
    }

    void addGeometries(X3dNode shape, WorldMesh& mesh, Index surface, bool welded) {
        for (const X3dNode child : shape.children()) {
            const X3dNode geometry = document_.resolved(child);
            const std::string_view kind = geometry.name();
            if (!geometry || kind == "Appearance" || kind.starts_with("Metadata")) continue;
            if (geometry.type() == pugi::node_element &&
                !addGeometry(document_, geometry, mesh, surface, welded))
                ++unknown_[std::string(kind)];
        }
    }

    void sayWhatIsLeftOut() {
        const auto say = [&](std::size_t count, const std::string& noun, const char* remedy,
                             Severity severity = Severity::Warning) {
            if (count > 0)
                loaded_.findings.push_back({severity, "", counted(count, noun) + " left out", remedy});
        };
        for (const auto& [kind, count] : unknown_)
            say(count, "geometry of the kind " + inQuotes(kind), "export it as IndexedFaceSet");
        say(inlines_, "Inline", "open that file itself, or join the two");
        const auto movers = document_.all({"PositionInterpolator", "OrientationInterpolator", "Script"});
        say(movers.size(), "animation or script", "everything stands where the file puts it");
        say(document_.all({"RigidBodyCollection"}).size(), "collection of rigid bodies",
            "everything stands where the file puts it");
        say(document_.all({"DirectionalLight", "PointLight", "SpotLight"}).size(), "light", "not felt",
            Severity::Note);
        say(document_.all({"Viewpoint", "OrthoViewpoint"}).size(), "viewpoint", "the view shows everything",
            Severity::Note);
        const auto effects =
            document_.all({"ForceField", "SpringEffect", "ViscosityEffect", "PositionFunctionEffect",
                           "MagneticGeometryEffect", "TimeFunctionEffect", "RotationalSpringEffect"});
        say(effects.size(), "force effect of H3D", "surfaces are felt, not the space between them");
    }

    const Source& source_;
    const Progress& progress_;
    LoadedScene loaded_;
    X3dDocument document_;
    X3dSurfaces surfaces_;
    std::optional<Ours> ours_; ///< being read
    std::size_t visits_ = 0, inlines_ = 0, shapes_ = 0, positions_ = 0;
    std::map<std::string, std::size_t> unknown_;
};

} // namespace

LoadedScene readX3d(const Source& source, const Progress& progress) {
    return X3dReader(source, progress).read();
}

} // namespace tactum
