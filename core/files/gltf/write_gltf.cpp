// Foreign parts keep their places at the beginning of each array, what is ours comes after them; how long the
// foreign beginnings are is written down, so that a reader can tell the two apart.
#include "core/files/gltf/write_gltf.h"

#include <map>
#include <set>

#include "core/files/gltf/drawn_mesh.h"
#include "core/files/gltf/gltf_animation.h"
#include "core/files/gltf/gltf_cameras.h"
#include "core/files/gltf/gltf_foreign.h"
#include "core/files/gltf/gltf_groups.h"
#include "core/files/gltf/gltf_mirror.h"
#include "core/files/gltf/gltf_standards.h"
#include "core/files/gltf/gltf_surface.h"
#include "core/files/gltf/soup_shelf.h"
#include "core/files/gltf/write_physics.h"
#include "core/files/unique_names.h"
#include "core/scene/kept_elsewhere.h"
#include "core/scene/world_fields.h"

namespace tactum {
namespace {

constexpr std::size_t kLargestGlb = (std::size_t(1) << 32) - 64;

class GltfWriter {
public:
    GltfWriter(const Scene& scene, const Progress& progress)
        : scene_(scene), progress_(progress), root_(foreignRoot(scene)), foreign_(arrayCounts(root_)),
          tree_(root_),
          data_(root_, scene.kept.foreign ? scene.kept.foreign->binary : std::string(), progress),
          maps_(progress), copies_(root_, data_, maps_, scene.mechanics.bodies.empty()),
          meshOf_([this](const auto& mesh) { return addShapeMesh(mesh); }),
          physics_(root_, data_, scene.mechanics, meshOf_) {
        for (const RigidBody& body : scene.mechanics.bodies)
            bodies_[body.id] = &body;
        for (const SceneObject& object : scene.objects)
            if (canShowBumps(object)) bumpy_.insert(shelf_.shared(object.geometry).get());
        foreign_["bytes"] = scene.kept.foreign ? scene.kept.foreign->binary.size() : 0;
    }

    Result<std::string> write();

private:
    /// What is painted on one mesh, by the numbers of their attributes.
    using Paints = std::vector<std::shared_ptr<const PaintedValues>>;

    /// A soup in the binary chunk: what meshes of any surfaces share.
    struct Stored {
        Json attributes, exact;
        std::vector<Index> copies;  ///< the position of each vertex beyond the soup's positions
        Paints paints;              ///< on some of its objects
        std::vector<int> accessors; ///< of these
        std::vector<std::pair<DrawnPart, int>> parts; ///< without their vertices, and the accessor of these
    };

    Stored& stored(const std::shared_ptr<const TriangleSoup>& soup, std::size_t surfaces);
    Json paintJson(const std::shared_ptr<const PaintedValues>& painted, const SceneObject& object,
                   Paints& paints);
    int paintAccessor(const std::shared_ptr<const PaintedValues>& painted, Stored& store);
    int addMaterial(const SceneObject& object, Index at, Paints& paints);
    Json setsJson(const SceneObject& object);
    int addMesh(const SceneObject& object);
    int addShapeMesh(const std::shared_ptr<const ShapeMesh>& mesh);
    int addNode(const SceneObject& object);
    int addCamera(const SavedCamera& camera);
    std::vector<int> addNodes();
    void hang(const std::string& group, int node, std::vector<int>& roots);
    const RigidBody* bodyOf(BodyId id) const;
    int put(const char* array, Json element, const Kept& kept, std::set<int>& claimed);
    int place(Json node, const Kept& kept, const Pose& pose);
    void finishRoot(const std::vector<int>& roots);

    const Scene& scene_;
    const Progress& progress_;
    Json root_;
    Json foreign_; ///< how many elements of each array are not ours
    ForeignTree tree_;
    GltfData data_;
    SurfaceMaps maps_;
    StandardCopies copies_;
    AddShapeMesh meshOf_;
    PhysicsWriter physics_;
    SoupShelf shelf_;
    std::set<const TriangleSoup*> bumpy_; ///< with tangents
    std::map<const TriangleSoup*, Stored> soups_;
    std::map<const TriangleSoup*, int> shapes_; ///< their meshes
    std::set<int> claimedNodes_, claimedMaterials_, claimedCameras_;
    std::vector<int> nodes_;            ///< of each object
    std::map<std::string, int> groups_; ///< their nodes
    std::map<BodyId, const RigidBody*> bodies_;
};

/// `json` with the members of `ours` over its own; a null takes one away.
Json overlaid(const Kept& kept, const Json& ours) {
    Json json = kept.json ? Json::parse(*kept.json, nullptr, false) : Json::object();
    if (!json.is_object()) json = Json::object();
    json.merge_patch(ours);
    return json;
}

/// Of a file by a later version of the program: members that this one does not know, of layers by their names
/// too.
void keepUnknownKeys(const Json& before, Json& now) {
    for (const auto& [key, value] : before.items()) {
        if (key == "painted") continue;             // it says where the values were
        if (!now.contains(key) && key != "texture") // that of a pattern: of an image that it has no more
            now[key] = value;
        else if (value.is_object() && now.contains(key) && now[key].is_object())
            keepUnknownKeys(value, now[key]);
        else if (key == "layers" && value.is_array() && now[key].is_array())
            for (std::size_t i = 0; i < std::min(value.size(), now[key].size()); ++i)
                if (value[i].is_object() && value[i].value("name", Json()) == now[key][i]["name"])
                    keepUnknownKeys(value[i], now[key][i]);
    }
}

Json colourJson(const Json& material, const Eigen::Vector3f& colour) {
    const Json* pbr = member(material, "pbrMetallicRoughness");
    const Json* base = pbr ? member(*pbr, "baseColorFactor") : nullptr;
    const bool has = base && base->is_array() && base->size() == 4;
    return {colour.x(), colour.y(), colour.z(), has ? (*base)[3] : Json(1.0)};
}

/// A member to write into; what another program has left there in another form goes.
Json& objectAt(Json& parent, const char* key) {
    Json& found = parent[key];
    if (!found.is_object()) found = Json::object();
    return found;
}

/// What others have put into a primitive of the same surface and kind.
Json withKept(const Json& mesh, const DrawnPart& part, Json primitive) {
    const Json* all = member(mesh, "primitives");
    for (const Json& kept : all && all->is_array() ? *all : Json::array()) {
        if (kept.value("surface", -1) != int(part.surface) || kept.value("corners", 0) != part.corners)
            continue;
        for (const char* key : {"extensions", "extras"})
            if (const Json* found = member(kept, key)) primitive[key] = *found;
    }
    return primitive;
}

auto findSame(const auto& paints, const std::shared_ptr<const PaintedValues>& painted) {
    return std::ranges::find_if(paints,
                                [&](const auto& other) { return other == painted || *other == *painted; });
}

/// An attribute of the vertices where there is a value for each position, else the bare numbers.
Json GltfWriter::paintJson(const std::shared_ptr<const PaintedValues>& painted, const SceneObject& object,
                           Paints& paints) {
    if (painted->size() != object.geometry->positions.size())
        return {{"bufferView", data_.addRawView(painted->all())}};
    const auto known = findSame(paints, painted);
    const auto number = known - paints.begin();
    if (known == paints.end()) paints.push_back(painted);
    return {{"attribute", number}};
}

/// Objects of one mesh may be painted alike.
int GltfWriter::paintAccessor(const std::shared_ptr<const PaintedValues>& painted, Stored& store) {
    const auto known = findSame(store.paints, painted);
    if (known != store.paints.end()) return store.accessors[std::size_t(known - store.paints.begin())];
    std::vector<float> values = painted->all();
    for (const Index position : store.copies)
        values.push_back(painted->all()[position]);
    store.paints.push_back(painted);
    return store.accessors.emplace_back(data_.addAttribute(values));
}

int GltfWriter::addMaterial(const SceneObject& object, Index at, Paints& paints) {
    const Surface& surface = object.surfaces[at];
    const WriteShared shared{[&](const auto& image) { return data_.addTexture(image); },
                             [&](const auto& painted) { return paintJson(painted, object, paints); }};
    Json material = overlaid(surface.kept, {{"name", surface.name}});
    if (surface.kept.index == kOfAnotherFile) material = lookAlone(material);
    if (!surface.kept.json)
        material.merge_patch({{"doubleSided", true}, {"pbrMetallicRoughness", usualLook()}});
    objectAt(material, "pbrMetallicRoughness")["baseColorFactor"] = colourJson(material, surface.colour);
    Json ours = surfaceJson(surface, shared);
    if (const Json* before = extensionOf(material)) keepUnknownKeys(*before, ours);
    addMirror(material, ours);
    objectAt(material, "extensions")[kExtension] = std::move(ours);
    copies_.addLook(object, at, material);
    return put("materials", std::move(material), surface.kept, claimedMaterials_);
}

/// In its foreign place, if it has one that is still free.
int GltfWriter::put(const char* array, Json element, const Kept& kept, std::set<int>& claimed) {
    const int index = kept.index;
    if (index < 0 || std::size_t(index) >= foreign_.value(array, std::size_t(0)) ||
        !claimed.insert(index).second)
        return data_.add(array, std::move(element));
    root_[array][std::size_t(index)] = std::move(element);
    return index;
}

GltfWriter::Stored& GltfWriter::stored(const std::shared_ptr<const TriangleSoup>& soup,
                                       std::size_t surfaces) {
    const auto [found, isNew] = soups_.try_emplace(shelf_.shared(soup).get());
    Stored& store = found->second;
    if (!isNew) return store;
    DrawnMesh mesh = drawn(*soup, surfaces);
    store.attributes["POSITION"] = data_.addAttribute(mesh.positions, true);
    if (!mesh.normals.empty()) store.attributes["NORMAL"] = data_.addAttribute(mesh.normals, false);
    if (!mesh.uvs.empty()) store.attributes["TEXCOORD_0"] = data_.addAttribute(mesh.uvs);
    if (bumpy_.contains(found->first)) store.attributes["TANGENT"] = data_.addAttribute(tangentsOf(mesh));
    if (!mesh.copies.empty()) store.exact["copies"] = data_.addRawView(mesh.copies);
    if (!mesh.order.empty()) store.exact["order"] = data_.addRawView(mesh.order);
    if (!mesh.positionsAreExact) store.exact["positions"] = data_.addRawView(soup->positions);
    if (!mesh.uvsAreExact) store.exact["uvs"] = data_.addRawView(mesh.trueUvs);
    for (DrawnPart& part : mesh.parts)
        store.parts.emplace_back(DrawnPart{part.surface, part.corners, {}}, data_.addIndices(part.vertices));
    store.copies = std::move(mesh.copies);
    return store;
}

/// With how many triangles the mesh has, so that a reader finds out when it is another one.
Json GltfWriter::setsJson(const SceneObject& object) {
    Json sets = Json::array();
    for (const NamedTriangles& each : object.sets)
        sets.push_back({{"name", each.name}, {"ranges", data_.addRawView(each.triangles)}});
    return {{"of", object.geometry->triangles.size()}, {"parts", std::move(sets)}};
}

int GltfWriter::addMesh(const SceneObject& object) {
    constexpr int kModes[] = {0, 1, 4};
    Stored& store = stored(object.geometry, object.surfaces.size());
    Json ours = store.exact.is_null() ? Json::object() : store.exact;
    Paints paints;
    for (Index i = 0; i < object.surfaces.size(); ++i)
        ours["surfaces"].push_back(addMaterial(object, i, paints));
    if (!object.sets.empty()) ours["sets"] = setsJson(object);
    Json attributes = store.attributes;
    for (std::size_t i = 0; i < paints.size(); ++i)
        attributes[std::string(kPaintAttribute) + std::to_string(i)] = paintAccessor(paints[i], store);
    Json mesh = overlaid(object.keptMesh, {{"name", object.name}, {"weights", nullptr}});
    Json primitives = Json::array();
    for (const auto& [part, indices] : store.parts)
        primitives.push_back(withKept(mesh, part,
                                      {{"attributes", attributes},
                                       {"indices", indices},
                                       {"mode", kModes[part.corners - 1]},
                                       {"material", ours["surfaces"][part.surface]}}));
    mesh["primitives"] = std::move(primitives);
    if (Json* before =
            objectAt(mesh, "extensions").contains(kExtension) ? &mesh["extensions"][kExtension] : nullptr) {
        for (const char* key : {"surfaces", "positions", "copies", "order", "uvs", "sets"})
            before->erase(key); // of the geometry of then
        keepUnknownKeys(*before, ours);
    }
    objectAt(mesh, "extensions")[kExtension] = std::move(ours);
    return data_.add("meshes", std::move(mesh));
}

/// A shape is a mesh without surfaces; points alone are drawn as points.
int GltfWriter::addShapeMesh(const std::shared_ptr<const ShapeMesh>& mesh) {
    auto soup = std::make_shared<TriangleSoup>();
    soup->positions = mesh->points;
    soup->triangles = mesh->faces;
    if (mesh->faces.empty())
        for (Index i = 0; i < mesh->points.size(); ++i)
            soup->triangles.push_back({i, i, i});
    soup->surfaceOf.assign(soup->triangles.size(), 0);
    const std::shared_ptr<const TriangleSoup> shared = shelf_.shared(soup);
    const auto [found, isNew] = shapes_.try_emplace(shared.get());
    if (!isNew) return found->second;
    const Stored& store = stored(shared, 1);
    Json json{{"name", "collider"}, {"primitives", Json::array()}};
    for (const auto& [part, indices] : store.parts)
        json["primitives"].push_back(
            {{"attributes", store.attributes}, {"indices", indices}, {"mode", part.corners == 3 ? 4 : 0}});
    json["extensions"][kExtension] = store.exact.is_null() ? Json::object() : store.exact;
    return found->second = data_.add("meshes", std::move(json));
}

const RigidBody* GltfWriter::bodyOf(BodyId id) const {
    const auto found = bodies_.find(id);
    return found == bodies_.end() ? nullptr : found->second;
}

/// Into its foreign place, if it has one, without the part of the tree above it.
int GltfWriter::place(Json node, const Kept& kept, const Pose& pose) {
    const int index = kept.index;
    if (index < 0 || std::size_t(index) >= foreign_["nodes"] || !claimedNodes_.insert(index).second)
        return data_.add("nodes", std::move(node));
    tree_.uproot(index, pose); // of the world: its body stands still when the file is written
    if (const Json* children = member(root_["nodes"][std::size_t(index)], "children"))
        node["children"] = *children;
    root_["nodes"][std::size_t(index)] = std::move(node);
    return index;
}

int GltfWriter::addNode(const SceneObject& object) {
    const RigidBody* body = bodyOf(object.body);
    const Pose pose = body ? body->pose.inverse() * object.pose : object.pose;
    const Json standing = nodePoseJson(pose);
    const bool isExact = !body && standing == poseJson(pose);
    const Json ours{{"visible", object.visible},
                    {"motion", nullptr},
                    {"pose", isExact ? Json(nullptr) : poseJson(object.pose)}};
    Json node = overlaid(object.kept, {{"name", object.name}, {"extensions", {{kExtension, ours}}}});
    if (object.motion) node["extensions"][kExtension]["motion"] = motionJson(*object.motion);
    if (object.geometry && !object.geometry->triangles.empty()) node["mesh"] = addMesh(object);
    if (!object.motion) {
        node.update(standing);
        return nodes_.emplace_back(place(std::move(node), object.kept, object.pose));
    }
    const int moving = nodes_.emplace_back(place(std::move(node), object.kept, object.pose));
    Json rest = standing;
    rest["name"] = object.name + " at rest";
    rest["children"] = {moving};
    addAnimation(data_, *object.motion, moving, object.name);
    return data_.add("nodes", std::move(rest));
}

int GltfWriter::addCamera(const SavedCamera& camera) {
    Json node = overlaid(camera.kept, cameraNodeJson(camera));
    node["camera"] = put("cameras", cameraJson(camera), camera.keptCamera, claimedCameras_);
    return place(std::move(node), camera.kept, camera.pose);
}

/// Rows of t, x, y, z.
std::vector<double> fingerNumbers(const std::vector<FingerPoint>& finger) {
    std::vector<double> numbers;
    for (const FingerPoint& point : finger)
        numbers.insert(numbers.end(), {point.t, point.position.x(), point.position.y(), point.position.z()});
    return numbers;
}

void GltfWriter::finishRoot(const std::vector<int>& roots) {
    Json& asset = objectAt(root_, "asset");
    asset["version"] = "2.0";
    asset["generator"] = "Tactum";
    const int scene = std::max(0, indexIn(root_, "scene", data_.count("scenes")));
    if (data_.count("scenes") == 0) data_.add("scenes", Json::object());
    Json& nodes = root_["scenes"][std::size_t(scene)]["nodes"];
    Json all = roots;
    if (nodes.is_array())
        for (const Json& other : nodes)
            if (std::ranges::find(all, other) == all.end()) all.push_back(other);
    if (all.empty())
        root_["scenes"][std::size_t(scene)].erase("nodes");
    else
        nodes = std::move(all);
    root_["scene"] = scene;
    Json ours{{"version", std::to_string(kFormatMajor) + "." + std::to_string(kFormatMinor)},
              {jsonKey(kProxyRadius.key), scene_.proxyRadius},
              {"foreign", foreign_},
              {"copies", copies_.wrote()}};
    const bool moves = !scene_.mechanics.bodies.empty();
    Json numbers{{jsonKey(kProxyRadius.key), scene_.proxyRadius}}; // what extras can hold
    ours["gravity"] = moves ? vectorJson(scene_.mechanics.gravity) : Json(nullptr);
    for (const WorldField& field : kWorldFields) {
        const double value = scene_.mechanics.*field.value;
        const std::string key = jsonKey(field.parameter->key);
        ours[key] = nullptr;
        if (moves && value != field.parameter->initial) ours[key] = numbers[key] = value;
    }
    const Reach& reach = scene_.reach;
    ours["reach"] =
        reach.mode == ReachMode::Position ? Json(nullptr) : Json(kReachChoices[std::size_t(reach.mode)].key);
    ours[jsonKey(kShellRadius.key)] = reach.shell == kUsualShell ? Json(nullptr) : Json(reach.shell);
    addMirror(root_["scenes"][std::size_t(scene)], numbers);
    ours["finger"] = scene_.finger ? Json(data_.addRawView(fingerNumbers(*scene_.finger))) : Json(nullptr);
    objectAt(root_, "extensions").merge_patch({{kExtension, ours}});
    Json& used = root_["extensionsUsed"];
    if (!used.is_array()) used = Json::array();
    if (std::ranges::find(used, Json(kExtension)) == used.end()) used.push_back(kExtension);
}

/// At the root, or on the node of its group, which is where the first of it is.
void GltfWriter::hang(const std::string& group, int node, std::vector<int>& roots) {
    if (group.empty()) return roots.push_back(node);
    const auto [known, isNew] = groups_.try_emplace(group);
    if (isNew) roots.push_back(known->second = data_.add("nodes", groupNodeJson(group)));
    root_["nodes"][std::size_t(known->second)]["children"].push_back(node);
}

/// Those of the scene: what stands still, and bodies with what moves with them, in the author's order as far
/// as objects of one body stand together.
std::vector<int> GltfWriter::addNodes() {
    physics_.addParts();
    std::map<BodyId, std::vector<int>> below;
    std::map<BodyId, std::string> groupOf; // of the first of each
    struct Met {
        BodyId body;
        int node;
        std::string group;
    };
    std::vector<Met> order; // a body or an object, as it is met first
    for (std::size_t i = 0; i < scene_.objects.size() && !progress_.isCancelled(); ++i) {
        if (progress_.report) progress_.report(double(i) / double(scene_.objects.size()));
        const SceneObject& object = scene_.objects[i];
        const int node = addNode(object);
        if (!bodyOf(object.body))
            order.push_back({kWorldBody, node, object.group});
        else if (below[object.body].empty())
            order.push_back({object.body, -1, groupOf[object.body] = object.group});
        if (bodyOf(object.body)) below[object.body].push_back(node);
    }
    std::vector<int> roots;
    auto next = scene_.mechanics.bodies.begin();
    const auto addBodiesTo = [&](const auto& end) {
        for (; next < end; ++next)
            hang(groupOf[next->id], physics_.addBody(*next, below[next->id]), roots);
    };
    for (const auto& [body, node, group] : order)
        if (body == kWorldBody)
            hang(group, node, roots);
        else
            addBodiesTo(scene_.mechanics.bodies.begin() + (bodyOf(body) - scene_.mechanics.bodies.data()) +
                        1);
    addBodiesTo(scene_.mechanics.bodies.end());
    roots.insert(roots.end(), physics_.still().begin(), physics_.still().end());
    for (const SavedCamera& camera : scene_.cameras)
        roots.push_back(addCamera(camera));
    return roots;
}

Result<std::string> GltfWriter::write() {
    const std::vector<int> roots = addNodes();
    if (progress_.isCancelled()) return cancelledError();
    for (std::size_t i = 0; i < nodes_.size(); ++i)
        copies_.add(scene_.objects[i], nodes_[i],
                    indexIn(root_["nodes"][std::size_t(nodes_[i])], "mesh", data_.count("meshes")));
    if (progress_.isCancelled()) return cancelledError();
    finishRoot(roots);
    const std::string binary = data_.finish();
    if (binary.size() > kLargestGlb)
        return inputError("the scene has more than the 4 GiB that a .glb can hold; simplify its meshes");
    std::string glb = packGlb(root_, binary);
    if (glb.size() > kLargestGlb)
        return inputError("the scene has more than the 4 GiB that a .glb can hold; simplify its meshes");
    return glb;
}

} // namespace

Result<GltfFiles> gltfFilesOf(const Scene& scene, std::string_view stem, const Progress& progress) {
    const auto glb = glbOf(scene, progress);
    if (!glb) return tl::unexpected<Error>(glb.error());
    const Source whole = Source::ofBytes("scene", *glb);
    GltfFile parts = openGltf(whole); // its binary is a part of it
    GltfFiles files;
    if (!parts.binary.empty()) {
        files.binary = parts.binary.substr(0, parts.json["buffers"][0]["byteLength"].get<std::size_t>());
        files.binaryName = sideFileStem(stem) + ".bin"; // nothing in it needs a % in a URI
        parts.json["buffers"][0]["uri"] = files.binaryName;
    }
    files.json = parts.json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
    return files;
}

Result<std::string> glbOf(const Scene& scene, const Progress& progress) {
    try {
        return GltfWriter(scene, progress).write();
    } catch (const Json::exception&) { // what another program left has a form that nobody thought of
        return inputError(
            "the parts of another program that came with the scene are damaged; open its file in "
            "that program and export it again");
    }
}

} // namespace tactum
