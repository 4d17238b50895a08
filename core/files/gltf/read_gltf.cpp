// glTF 2.0 and glb. Every node with a mesh is an object, every material of the mesh a surface. The rigid part
// of the node's transform is the object's pose, what is left of it goes into the vertices. A node that is
// animated, or has an animated ancestor, moves. Axes stay as in the file. What our own extension says counts
// more than what others can read; what neither knows is kept for saving.
#include <cstring>
#include <map>
#include <optional>
#include <set>

#include "core/base/text.h"
#include "core/files/corner_pool.h"
#include "core/files/gltf/gltf_animation.h"
#include "core/files/gltf/gltf_cameras.h"
#include "core/files/gltf/gltf_foreign.h"
#include "core/files/gltf/gltf_groups.h"
#include "core/files/gltf/gltf_mesh.h"
#include "core/files/gltf/gltf_mirror.h"
#include "core/files/gltf/gltf_motion.h"
#include "core/files/gltf/gltf_nodes.h"
#include "core/files/gltf/gltf_packed.h"
#include "core/files/gltf/gltf_physics.h"
#include "core/files/gltf/gltf_references.h"
#include "core/files/gltf/gltf_standards.h"
#include "core/files/gltf/gltf_surface.h"
#include "core/files/gltf/gltf_weed.h"
#include "core/files/gltf/soup_shelf.h"
#include "core/files/gltf/write_physics.h"
#include "core/files/images/read_image.h"
#include "core/files/readers.h"
#include "core/scene/groups.h"
#include "core/scene/selection_sets.h"

namespace tactum {
namespace {

using Severity = Finding::Severity;

GltfFile weeded(const Source& source, std::size_t& damagedAnimations) {
    GltfFile file = openGltf(source);
    if (const Json* asset = member(file.json, "asset"); !asset || !member(*asset, "version"))
        source.fail(
            "does not say which version of glTF it is (asset.version), and only 2.0 is read; export it "
            "again");
    damagedAnimations = eraseDamagedAnimations(file.json);
    return file;
}

tinygltf::Model unpacked(const Source& source, GltfFile& file) {
    tinygltf::Model model = parseGltf(source, file);
    unpackMeshes(source, file.json, model);
    return model;
}

class GltfReader {
public:
    GltfReader(const Source& source, const Progress& progress)
        : source_(source), progress_(progress), file_(weeded(source, damagedAnimations_)),
          groups_(file_.json), model_(unpacked(source, file_)), meshes_(source, file_, model_, progress) {}

    LoadedScene read();

private:
    void demandOurVersion() const;
    void noteInstances(std::size_t meshes);
    void readRoot();
    void readMirroredRoot();
    void readReach(const Json& ours);
    void readFinger(int view);
    void readMechanics(const GltfMotions& motions);
    bool hasMechanics() const { return !loaded_.scene.mechanics.bodies.empty(); }
    void place(const PlacedMesh& placed, const RawMesh& raw);
    void keepCameras(const std::vector<PlacedCamera>& cameras);
    void keep(SceneObject& object, const PlacedMesh& placed, const RawMesh& raw);
    void readNode(SceneObject& object, const PlacedMesh& placed, const Json& ours);
    Kept keptOf(const char* array, int index, Json primitives = {}) const;
    Json keptPrimitives(int mesh, const RawMesh& raw);
    void noteLostAttributes(const std::vector<PlacedMesh>& placed);
    void keepForeign();
    Surface surfaceOf(int material, const PlacedMesh& placed, const RawMesh& raw);
    void sayEmptyLayers(const Surface& surface);
    void sayMirrored();
    std::shared_ptr<const PaintedValues> paintOf(const Json& painted, const RawMesh& raw,
                                                 std::vector<std::string>& complaints);
    std::shared_ptr<const TextureImage> imageAt(int texture);
    void say(Severity severity, const std::string& object, const std::string& sentence,
             const std::string& remedy) {
        loaded_.findings.push_back({severity, object, sentence, remedy});
    }

    const Source& source_;
    const Progress& progress_;
    std::size_t damagedAnimations_ = 0; ///< which file_ has no more
    GltfFile file_;
    GltfGroups groups_; ///< which file_ has no more
    tinygltf::Model model_;
    GltfMeshReader meshes_;
    std::vector<std::string> copies_ = copiesIn(file_.json); ///< of our own writer
    std::vector<int> objectNodes_;                           ///< rising
    std::optional<GltfParting> parting_;
    LoadedScene loaded_;
    SoupShelf shelf_;
    std::map<int, std::shared_ptr<const TextureImage>> images_;  ///< by texture
    std::map<int, std::shared_ptr<const PaintedValues>> paints_; ///< by buffer view
    std::size_t painted_ = 0;                                    ///< values of these
    std::map<int, BodyId> bodyOfNode_;
    bool wasOurs_ = false;              ///< only a copy of what we had written is left, in extras
    std::set<int> mirrored_;            ///< materials whose feel is that copy
    std::set<std::string> withoutFeel_; ///< surfaces without any
};

/// Scale, shear, mirroring and offset of a mesh; a mirror turns every triangle over, as glTF demands.
TriangleSoup stretched(TriangleSoup soup, const Mat3& stretch, const Vec3& offset) {
    const double volume = stretch.determinant();
    for (Vec3& p : soup.positions)
        p = stretch * p + offset;
    if (std::abs(volume) < 1e-30) {
        soup.cornerNormals.clear(); // flattened: they have no meaning any more
        return soup;
    }
    const Mat3 forNormals = stretch.inverse().transpose();
    for (auto& n : soup.cornerNormals)
        n = (forNormals * n.cast<double>()).normalized().cast<float>();
    if (volume > 0) return soup;
    for (std::size_t f = 0; f < soup.triangles.size(); ++f) {
        if (soup.triangles[f][1] == soup.triangles[f][2]) continue; // a segment or a point has no sides
        std::swap(soup.triangles[f][1], soup.triangles[f][2]);
        if (!soup.cornerNormals.empty())
            std::swap(soup.cornerNormals[3 * f + 1], soup.cornerNormals[3 * f + 2]);
        if (!soup.cornerUvs.empty()) std::swap(soup.cornerUvs[3 * f + 1], soup.cornerUvs[3 * f + 2]);
    }
    return soup;
}

void noteStretchedRotations(const tinygltf::Model& model, std::vector<Finding>& findings) {
    const auto count = std::ranges::count_if(model.nodes, [](const tinygltf::Node& node) {
        if (node.rotation.size() != 4) return false;
        const QuatCoefficients rotation(node.rotation.data());
        return isUsable(rotation) && needsUnitLength(rotation);
    });
    if (count > 0)
        findings.push_back(
            {Finding::Severity::Warning, "",
             counted(std::size_t(count), "node") + " with a rotation that is not of unit length",
             "brought to unit length; re-export the file"});
}

/// As many as the accessors speak of: whether they are there is seen when they are read.
std::uint64_t trianglesOf(const tinygltf::Model& model, const std::vector<PlacedMesh>& placed) {
    std::uint64_t bytes = 0; // more elements than bytes are a lie, which the reading finds
    for (const tinygltf::Buffer& buffer : model.buffers)
        bytes += buffer.data.size();
    const auto countOf = [&](int accessor) -> std::uint64_t {
        if (accessor < 0 || std::size_t(accessor) >= model.accessors.size()) return 0;
        const tinygltf::Accessor& of = model.accessors[std::size_t(accessor)];
        return of.count <= bytes || of.sparse.isSparse ? of.count : 0;
    };
    std::vector<std::uint64_t> ofMesh;
    for (const tinygltf::Mesh& mesh : model.meshes) {
        ofMesh.push_back(0);
        for (const tinygltf::Primitive& primitive : mesh.primitives) {
            const auto positions = primitive.attributes.find("POSITION");
            const bool indexed = primitive.indices >= 0;
            if (positions == primitive.attributes.end()) continue;
            const std::uint64_t count = countOf(indexed ? primitive.indices : positions->second);
            const bool triangles = primitive.mode < 0 || primitive.mode == TINYGLTF_MODE_TRIANGLES;
            ofMesh.back() += std::min(count / (triangles ? 3 : 1), kMaxShownTriangles + 1);
        }
    }
    std::uint64_t all = 0;
    for (const PlacedMesh& each : placed)
        all += ofMesh[std::size_t(each.mesh)];
    return all;
}

LoadedScene GltfReader::read() {
    demandOurVersion();
    readRoot();
    std::map<int, RawMesh> meshes;
    CountedFindings(loaded_.findings, "")
        .add(Severity::Warning, damagedAnimations_, "animation", "that is damaged left out",
             "what it moves stands still; export it again");
    loaded_.findings.insert(loaded_.findings.end(), groups_.findings().begin(), groups_.findings().end());
    const GltfMotions motions(source_, model_);
    loaded_.findings.insert(loaded_.findings.end(), motions.findings().begin(), motions.findings().end());
    noteStretchedRotations(model_, loaded_.findings);
    const std::vector<PlacedMesh> all = placedMeshes(source_, model_, motions);
    demandBounded(source_, all.size(), trianglesOf(model_, all));
    readMechanics(motions);
    for (const PlacedMesh& placed : all)
        objectNodes_.push_back(placed.node);
    std::ranges::sort(objectNodes_);
    noteInstances(all.size());
    const std::vector<PlacedCamera> cameras =
        placedCameras(source_, model_, file_.json, motions, loaded_.findings);
    std::vector<int> cameraNodes;
    for (const PlacedCamera& placed : cameras)
        cameraNodes.push_back(placed.node);
    parting_.emplace(file_.json, objectNodes_, cameraNodes, hasMechanics());
    loaded_.findings.insert(loaded_.findings.end(), parting_->findings().begin(), parting_->findings().end());
    for (const PlacedMesh& placed : all) {
        const auto [mesh, isNew] = meshes.try_emplace(placed.mesh);
        if (isNew) {
            mesh->second = meshes_.read(placed.mesh);
            for (const std::string& complaint : mesh->second.complaints)
                say(Severity::Warning, "", complaint, "left out; export it again");
        } else
            meshes_.countTriangles(mesh->second.soup.triangles.size());
        place(placed, mesh->second);
    }
    gatherGroups(loaded_.scene);
    noteLostAttributes(all);
    sayMirrored();
    keepCameras(cameras);
    keepForeign();
    return std::move(loaded_);
}

/// A node can be there many times, and is one for whatever else is in the file.
void GltfReader::noteInstances(std::size_t meshes) {
    objectNodes_.erase(std::unique(objectNodes_.begin(), objectNodes_.end()), objectNodes_.end());
    if (meshes > objectNodes_.size())
        say(Severity::Note, "",
            counted(meshes - objectNodes_.size(), "further instance") + " of a mesh by " + kInstancing,
            "each is an object of its own, and is written as one");
}

void GltfReader::demandOurVersion() const {
    if (const auto later = laterFormat(file_.json))
        source_.fail("was written by a later Tactum (version " + *later + " of its format, this one reads " +
                     std::to_string(kFormatMajor) + "); update the program");
}

void GltfReader::readRoot() {
    const Json* ours = extensionOf(file_.json);
    loaded_.ours = ours != nullptr;
    const Json* radius = ours ? member(*ours, jsonKey(kProxyRadius.key).c_str()) : nullptr;
    if (radius && radius->is_number()) loaded_.scene.proxyRadius = radius->get<double>();
    if (!ours) readMirroredRoot();
    if (ours) readReach(*ours);
    if (ours && ours->contains(jsonKey(kProxyRadius.key)) && !(radius && radius->is_number()))
        say(Severity::Warning, "", std::string(kExtension) + ".proxyRadius is not a number",
            "the initial value is used");
    if (const auto strange = strangeVersion(file_.json))
        say(Severity::Warning, "",
            std::string(kExtension) + ".version " + *strange + " is not a version of the form 1.0",
            "read as version " + std::to_string(kFormatMajor) + "." + std::to_string(kFormatMinor));
    if (const Json* copies = ours ? member(*ours, "copies") : nullptr;
        copies && !(copies->is_array() && copies->size() == copies_.size()))
        say(Severity::Warning, "", std::string(kExtension) + ".copies names what is no copy",
            "only the extensions that are written as copies are written anew");
    if (ours && member(*ours, "finger")) readFinger(indexIn(*ours, "finger", model_.bufferViews.size()));
}

void GltfReader::readReach(const Json& ours) {
    Reach& reach = loaded_.scene.reach;
    const Json* mode = member(ours, "reach");
    const auto known =
        std::ranges::find_if(kReachChoices, [&](const auto& each) { return mode && *mode == each.key; });
    if (known != kReachChoices.end()) reach.mode = ReachMode(known - kReachChoices.begin());
    const Json* shell = member(ours, jsonKey(kShellRadius.key).c_str());
    const bool number =
        shell && shell->is_number() && shell->get<double>() == kShellRadius.clamped(shell->get<double>());
    if (number) reach.shell = shell->get<double>();
    if (mode && known == kReachChoices.end())
        say(Severity::Warning, "", std::string(kExtension) + ".reach is none of position, rate and drift",
            "hands reach by position");
    if (shell && !number)
        say(Severity::Warning, "", std::string(kExtension) + ".shellRadius is no number from 0.005 to 0.5 m",
            "the initial value is used");
}

void GltfReader::readMirroredRoot() {
    const auto any = [&](const char* array) {
        const Json* all = arrayIn(file_.json, array);
        for (const Json& element : all ? *all : Json::array()) {
            const Json ours = mirrored(element);
            const auto radius = ours.find(jsonKey(kProxyRadius.key));
            if (radius != ours.end() && radius->is_number()) loaded_.scene.proxyRadius = *radius;
            wasOurs_ |= !ours.empty();
        }
    };
    any("scenes");
    any("materials");
}

void GltfReader::readMechanics(const GltfMotions& motions) {
    const auto meshAt = [&](int mesh) {
        const RawMesh raw = meshes_.read(mesh);
        meshes_.countTriangles(raw.soup.triangles.size());
        ShapeMesh shape{raw.soup.positions, raw.soup.triangles};
        std::erase_if(shape.faces, [](const auto& face) { return cornersOf(face) < 3; });
        return shape;
    };
    GltfPhysics physics = readPhysics(source_, model_, file_.json, motions, meshAt);
    loaded_.scene.mechanics = std::move(physics.mechanics);
    bodyOfNode_ = std::move(physics.bodyOfNode);
    loaded_.findings.insert(loaded_.findings.end(), physics.findings.begin(), physics.findings.end());
}

void GltfReader::readFinger(int view) {
    std::vector<FingerPoint> finger;
    if (view >= 0) {
        const tinygltf::BufferView& of = model_.bufferViews[std::size_t(view)];
        const unsigned char* data = model_.buffers[std::size_t(of.buffer)].data.data() + of.byteOffset;
        std::array<double, 4> row{};
        for (std::size_t at = 0; at + sizeof row <= of.byteLength; at += sizeof row) {
            std::memcpy(row.data(), data + at, sizeof row);
            finger.push_back({row[0], Vec3(row.data() + 1)});
        }
    }
    if (isFingerPath(finger))
        loaded_.scene.finger = std::make_shared<const std::vector<FingerPoint>>(std::move(finger));
    else
        say(Severity::Warning, "", "its finger path has no rows of rising time",
            "left out; give it another one");
}

void GltfReader::place(const PlacedMesh& placed, const RawMesh& raw) {
    const bool asItIs = placed.stretch == Mat3::Identity() && placed.offset.isZero(0);
    TriangleSoup soup = asItIs ? raw.soup : stretched(raw.soup, placed.stretch, placed.offset);
    for (const Vec3& p : soup.positions)
        if (!isCoordinate(p.cwiseAbs().maxCoeff()))
            source_.fail("coordinate of node " + inQuotes(placed.name) + " is beyond 1e6 m; scale the model");
    std::vector<Surface> surfaces;
    for (const int material : raw.materials)
        surfaces.push_back(surfaceOf(material, placed, raw));
    const std::size_t before = loaded_.scene.objects.size();
    addObject(loaded_, placed.name.empty() ? stemOf(source_) : placed.name, raw.report, std::move(soup),
              std::move(surfaces), Progress{{}, progress_.cancelled});
    if (loaded_.scene.objects.size() == before) return;
    SceneObject& object = loaded_.scene.objects.back();
    object.geometry = shelf_.shared(object.geometry);
    if (areSetsOf(raw.sets, object.geometry->triangles.size())) object.sets = raw.sets;
    object.pose = placed.pose;
    object.motion = placed.motion;
    object.group = groups_.of(placed.node);
    if (const auto body = bodyOfNode_.find(placed.node); body != bodyOfNode_.end())
        object.body = body->second;
    keep(object, placed, raw);
    const auto warn = [&](bool applies, const char* sentence, const char* remedy) {
        if (applies) say(Severity::Warning, object.name, sentence, remedy);
    };
    warn(placed.bends, "is scaled or sheared while it moves",
         "only its rigid motion is felt; give its ancestors an even scale");
    warn(placed.deforms, "is deformed by a skin or by morph targets",
         "felt in the shape that it has at rest");
}

/// A camera that does not say what it looks at looks at the middle of the scene.
void GltfReader::keepCameras(const std::vector<PlacedCamera>& cameras) {
    const Bounds box = boundsOf(loaded_.scene);
    const double size = box.diagonal() > 0 ? box.diagonal() : 1;
    for (const PlacedCamera& placed : cameras) {
        SavedCamera camera = placed.camera;
        const Vec3 to = (box.empty() ? Vec3(Vec3::Zero()) : box.centre()) - camera.pose.translation;
        if (!isCamera(camera)) // nor is anything else of it wrong: see placedCameras()
            camera.ahead = std::clamp(-camera.pose.rotateInverse(to).z(), 0.1 * size, 10 * size);
        camera.kept = keptOf("nodes", placed.node);
        camera.keptCamera = keptOf("cameras", placed.index);
        loaded_.scene.cameras.push_back(std::move(camera));
    }
}

/// What our extension of the node says, and all that nobody here knows.
void GltfReader::keep(SceneObject& object, const PlacedMesh& placed, const RawMesh& raw) {
    object.kept = keptOf("nodes", placed.node);
    object.keptMesh = keptOf("meshes", placed.mesh, keptPrimitives(placed.mesh, raw));
    if (const Json* ours = extensionOf(file_.json["nodes"][std::size_t(placed.node)]))
        readNode(object, placed, *ours);
}

void GltfReader::readNode(SceneObject& object, const PlacedMesh& placed, const Json& ours) {
    const auto complain = [&](const std::string& what, const char* remedy) {
        say(Severity::Warning, object.name, std::string(kExtension) + "." + what, remedy);
    };
    const auto visible = ours.find("visible");
    if (visible != ours.end() && visible->is_boolean())
        object.visible = visible->get<bool>();
    else if (visible != ours.end())
        complain("visible is not true or false", "it is visible");
    const Json* motion = member(ours, "motion");
    const auto exact = motion ? motionOf(*motion) : std::nullopt;
    if (motion && !exact) return complain("motion is damaged", "its animation is felt, in single precision");
    if (motion && !placed.rest)
        return complain("motion is not that of its nodes any more",
                        "its animation is felt, in single precision");
    if (motion) object.motion = std::make_shared<const Motion>(*exact);
    if (motion) object.pose = *placed.rest;
    object.pose = exactPose(ours, object.pose).value_or(object.pose);
}

/// What others have put into the primitives of a mesh, by the surfaces and kinds that these become.
Json GltfReader::keptPrimitives(int mesh, const RawMesh& raw) {
    Json kept = Json::array();
    for (const Json& primitive : file_.json["meshes"][std::size_t(mesh)]["primitives"]) {
        if (!member(primitive, "extensions") && !member(primitive, "extras")) continue;
        const int material = indexIn(primitive, "material", model_.materials.size());
        const auto surface = std::ranges::find(raw.materials, material) - raw.materials.begin();
        const int mode = primitive.value("mode", 4);
        Json as{{"surface", surface}, {"corners", mode == 0 ? 1 : mode <= 3 ? 2 : 3}};
        const bool doubled = std::ranges::any_of(kept, [&](const Json& other) {
            return other["surface"] == as["surface"] && other["corners"] == as["corners"];
        });
        if (doubled) {
            say(Severity::Warning, "",
                "meshes[" + std::to_string(mesh) +
                    "] has two primitives of one material with extensions or extras",
                "those of the first are written when the scene is saved");
            break;
        }
        for (const char* key : {"extensions", "extras"})
            if (const Json* found = member(primitive, key)) as[key] = *found;
        kept.push_back(std::move(as));
    }
    return kept;
}

/// An element without what the reader makes of it. Its place counts only in the foreign part of the file.
Kept GltfReader::keptOf(const char* array, int index, Json primitives) const {
    const auto all = file_.json.find(array);
    if (all == file_.json.end() || index < 0 || std::size_t(index) >= all->size()) return {};
    Json element = (*all)[std::size_t(index)];
    for (const char* key :
         {"primitives", "mesh", "children", "translation", "rotation", "scale", "matrix", "skin", "weights"})
        element.erase(key);
    if (!primitives.empty()) element["primitives"] = std::move(primitives);
    eraseCopies(element, copies_);
    eraseExtension(element, kInstancing);
    if (hasMechanics()) eraseMechanics(element);
    if (array == std::string_view("materials")) eraseLook(element), eraseMirror(element);
    parting_->renumber(array, element);
    return {parting_->place(array, index), std::make_shared<const std::string>(
                                               element.dump(-1, ' ', false, Json::error_handler_t::replace))};
}

/// What a mesh has for the eye alone, and what saving does not keep.
void GltfReader::noteLostAttributes(const std::vector<PlacedMesh>& placed) {
    std::set<std::string> lost;
    for (const PlacedMesh& each : placed)
        for (const tinygltf::Primitive& primitive : model_.meshes[std::size_t(each.mesh)].primitives)
            for (const auto& [name, accessor] : primitive.attributes)
                if (name.starts_with("COLOR_") || (name.starts_with("TEXCOORD_") && name != "TEXCOORD_0") ||
                    (name.starts_with("_") && paintNumber(name) < 0) || (name == "TANGENT" && !loaded_.ours))
                    lost.insert(printable(name, kLongestName));
    for (const std::string& name : lost)
        say(Severity::Note, "",
            name + " of its meshes is " + (name.starts_with("_") ? "another program's" : "for the eye alone"),
            "not written when the scene is saved");
}

void GltfReader::keepForeign() {
    std::vector<std::string> missing;
    std::size_t idle = 0;
    loaded_.scene.kept.foreign = foreignOf(source_, file_, model_, *parting_, missing, idle);
    for (const std::string& image : missing)
        say(Severity::Note, "", "its picture " + inQuotes(image) + " is not in its folder or of another kind",
            "not needed for touch; put it beside the file to keep it when saving");
    if (idle > 0)
        say(Severity::Note, "",
            std::to_string(idle) + " of its meshes stay in the file as they were, though no node shows them",
            "something that is not known here may use their data; leave them out where they come from");
}

Surface GltfReader::surfaceOf(int material, const PlacedMesh& placed, const RawMesh& raw) {
    Surface surface = namedSurface("surface");
    const auto image = [&](int texture) { return imageAt(texture); };
    std::vector<std::string> said;
    const Json copy =
        material < 0 ? Json::object() : mirrored(file_.json["materials"][std::size_t(material)]);
    if (!extensionOf(file_.json) && copy.empty())
        readStandards(file_.json, file_.json["nodes"][std::size_t(placed.node)],
                      file_.json["meshes"][std::size_t(placed.mesh)], image, surface, said);
    for (const std::string& sentence : said)
        say(Severity::Note, printable(placed.name), sentence,
            "set it in the inspector if it should be another");
    if (material < 0) {
        withoutFeel_.insert(placed.name);
        return surface;
    }
    const tinygltf::Material& m = model_.materials[std::size_t(material)];
    surface.name = m.name.empty() ? "material " + std::to_string(material) : m.name;
    const std::vector<double>& base = m.pbrMetallicRoughness.baseColorFactor;
    for (std::size_t i = 0; i < 3 && i < base.size(); ++i)
        if (std::isfinite(base[i])) surface.colour[int(i)] = float(std::clamp(base[i], 0.0, 1.0));
    surface.kept = keptOf("materials", material);
    const Json* ours = extensionOf(file_.json["materials"][std::size_t(material)]);
    if (!ours && copy.empty()) withoutFeel_.insert(surface.name);
    if (!ours && copy.empty()) return surface;
    std::vector<std::string> complaints;
    const auto paint = [&](const Json& painted) { return paintOf(painted, raw, complaints); };
    readSurfaceJson(ours ? *ours : copy, ours ? kExtension : kMirror, {image, paint}, surface, complaints);
    for (const std::string& complaint : complaints)
        say(Severity::Warning, "", "material " + inQuotes(surface.name) + ": " + complaint,
            "the initial value is used");
    if (!ours && mirrored_.insert(material).second) sayEmptyLayers(surface);
    return surface;
}

/// What extras cannot hold.
void GltfReader::sayEmptyLayers(const Surface& surface) {
    const auto isEmpty = [](const TexturePattern& pattern) {
        return (pattern.source == TextureSource::Image && !pattern.image) ||
               (pattern.source == TextureSource::Painted && !pattern.painted.values);
    };
    for (const TextureLayer& layer : surface.layers)
        if (isEmpty(layer.pattern) || (layer.mask && isEmpty(*layer.mask)))
            say(Severity::Warning, "",
                "layer " + inQuotes(layer.name) + " of material " + inQuotes(surface.name) +
                    " has lost its picture or paint on the way through another program",
                "bring it back from the scene as it was: tactum feel");
}

void GltfReader::sayMirrored() {
    if (!wasOurs_) return;
    if (!mirrored_.empty())
        say(Severity::Note, "",
            std::string(kExtension) + " is not there; the feel of " + counted(mirrored_.size(), "material") +
                " comes from extras",
            "exact positions and motions, gravity and the finger path are not in extras: tactum feel brings "
            "back what surfaces had");
    for (const std::string& name : withoutFeel_)
        say(Severity::Warning, "",
            inQuotes(printable(name)) + " has lost its feel on the way through another program",
            "bring it back from the scene as it was, by its name: tactum feel");
}

std::shared_ptr<const PaintedValues> GltfReader::paintOf(const Json& painted, const RawMesh& raw,
                                                         std::vector<std::string>& complaints) {
    const int number = indexIn(painted, "attribute", kMaxPaints);
    if (const auto found = raw.paints.find(number); found != raw.paints.end()) return found->second;
    const int view = indexIn(painted, "bufferView", model_.bufferViews.size());
    if (const auto found = paints_.find(view); found != paints_.end()) return found->second;
    const tinygltf::BufferView* of = view < 0 ? nullptr : &model_.bufferViews[std::size_t(view)];
    const std::size_t count = of ? of->byteLength / sizeof(float) : 0;
    painted_ += count;
    if (count == 0 || painted_ > kMaxPaintedValues) {
        complaints.push_back("what is painted names values that are not there");
        return nullptr;
    }
    std::vector<float> values(count);
    std::memcpy(values.data(), model_.buffers[std::size_t(of->buffer)].data.data() + of->byteOffset,
                count * sizeof(float));
    return paints_[view] = std::make_shared<const PaintedValues>(std::move(values));
}

std::shared_ptr<const TextureImage> GltfReader::imageAt(int texture) {
    const auto [found, isNew] = images_.try_emplace(texture);
    if (!isNew) return found->second;
    const Json& root = file_.json;
    const auto count = [&](const char* array) {
        return root.contains(array) && root[array].is_array() ? root[array].size() : 0;
    };
    const bool known = texture >= 0 && std::size_t(texture) < count("textures");
    const int image = known ? indexIn(root["textures"][std::size_t(texture)], "source", count("images")) : -1;
    const std::string where = "texture " + std::to_string(texture);
    if (image < 0) {
        say(Severity::Warning, "", where + " of a layer is not there",
            "the layer is not felt; choose its image again");
        return nullptr;
    }
    const Json& json = root["images"][std::size_t(image)];
    const auto read =
        readImage(imageBytes(source_, json, model_), json.value("name", std::string()), source_.path());
    if (!read)
        say(Severity::Warning, "", where + " of a layer cannot be read: " + read.error().text,
            "the layer is not felt; choose its image again");
    else
        found->second = read->image;
    return found->second;
}

} // namespace

LoadedScene readGltf(const Source& source, const Progress& progress) {
    try {
        return GltfReader(source, progress).read();
    } catch (const Json::exception& fault) { // a value has a type that nobody expects
        source.fail("has JSON that is not glTF (" + printable(fault.what(), 160) + "); re-export it");
    }
}

} // namespace tactum
