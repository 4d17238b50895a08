#include "core/files/gltf/gltf_parting.h"

#include <algorithm>
#include <set>

#include "core/base/text.h"
#include "core/files/gltf/gltf_mirror.h"
#include "core/files/gltf/gltf_nodes.h"
#include "core/files/gltf/gltf_standards.h"
#include "core/files/gltf/gltf_surface.h"
#include "core/files/gltf/write_physics.h"
#include "core/scene/world_fields.h"

namespace tactum {
namespace {

const Json* motionIn(const Json& node) {
    const Json* ours = extensionOf(node);
    return ours ? member(*ours, "motion") : nullptr;
}

const Json* poseBelowBody(const Json& node) {
    const Json* ours = extensionOf(node);
    const Json* pose = ours ? member(*ours, "pose") : nullptr;
    return pose && pose->is_object() ? pose : nullptr;
}

/// Takes the channels that move these nodes out of the animations: the objects' motions say it now.
void eraseMotions(Json& root, const auto& isMoved) {
    Json* animations = arrayIn(root, "animations");
    if (!animations) return;
    Json left = Json::array();
    for (Json& animation : *animations) {
        Json channels = Json::array();
        for (const Json& channel : animation.value("channels", Json::array())) {
            const Json* target = member(channel, "target");
            const int node = target ? indexIn(*target, "node", std::size_t(1) << 30) : -1;
            if (node < 0 || !isMoved(node)) channels.push_back(channel);
        }
        if (channels.empty()) continue;
        animation["channels"] = std::move(channels);
        left.push_back(std::move(animation));
    }
    *animations = std::move(left);
}

/// Whoever still needs it is a node that nobody shows.
void eraseInstancing(Json& root) {
    if (const Json* nodes = arrayIn(root, "nodes"))
        for (const Json& node : *nodes)
            if (extensionOf(node, kInstancing)) return;
    eraseUse(root, kInstancing);
    Json* required = arrayIn(root, "extensionsRequired");
    if (!required) return;
    required->erase(std::remove(required->begin(), required->end(), Json(kInstancing)), required->end());
    if (required->empty()) root.erase("extensionsRequired");
}

/// What of a mesh is kept beside its object.
Json withoutGeometry(Json mesh) {
    eraseExtension(mesh, kExtension);
    for (Json& primitive : mesh["primitives"])
        for (const char* key : {"attributes", "indices", "material", "targets"})
            primitive.erase(key);
    return mesh;
}

/// Arrays that our writer never adds to, but for animations, of which eraseMotions() has left the foreign.
bool isAllForeign(std::string_view array) {
    for (const char* name : {"animations", "samplers", "scenes", "skins"})
        if (array == name) return true;
    return false;
}

} // namespace

GltfParting::GltfParting(const Json& json, const std::vector<int>& objects, const std::vector<int>& cameras,
                         bool mechanics)
    : objects_(objects), root_(json) {
    readCounts(json);
    findOwnNodes(json);
    strip(mechanics);
    stripCameras(cameras);
    markForeign(json);
    number();
    noteLost(json);
    noteMoved();
}

void GltfParting::warn(const std::string& sentence, const std::string& remedy) {
    findings_.push_back({Finding::Severity::Warning, "", sentence, remedy});
}

void GltfParting::readCounts(const Json& json) {
    const Json* ours = extensionOf(json);
    const Json* counts = ours ? member(*ours, "foreign") : nullptr;
    const auto complain = [&](const std::string& what) {
        warn(what, "what is foreign is told by what its objects use; save it again");
    };
    if (counts && !counts->is_object()) complain(std::string(kExtension) + ".foreign is not an object");
    for (const char* array : kGltfArrays) {
        const Json* all = arrayIn(root_, array);
        const std::size_t size = all ? all->size() : 0;
        const Json* count = counts ? member(*counts, array) : nullptr;
        std::size_t& head = heads_[array] = ours ? 0 : size;
        foreign_[array].assign(size, 0);
        if (!count) continue;
        if (count->is_number_integer() && *count >= 0 && *count <= size)
            head = count->get<std::size_t>();
        else if (std::string_view(array) != "buffers") // all become one
            complain(std::string(kExtension) + ".foreign." + array + " is " + printable(count->dump(), 20) +
                     ", of " + std::to_string(size) + " that there are");
    }
    const Json* bytes = counts ? member(*counts, "bytes") : nullptr;
    headBytes_ = ours ? 0 : SIZE_MAX;
    if (!bytes) return;
    if (bytes->is_number_integer() && *bytes >= 0)
        headBytes_ = bytes->get<std::size_t>();
    else
        complain(std::string(kExtension) + ".foreign.bytes is " + printable(bytes->dump(), 20));
}

bool GltfParting::isHead(const std::string& array, std::size_t index) const {
    return index < heads_.find(array)->second;
}

/// As our writer makes it: nothing but a place, for one child that moves.
bool GltfParting::isRest(const Json& node) const {
    for (const auto& [key, value] : node.items())
        if (key != "name" && key != "children" && key != "translation" && key != "rotation") return false;
    const Json* children = member(node, "children");
    if (!children || !children->is_array() || children->size() != 1) return false;
    const Json& nodes = root_["nodes"];
    const int child = indexIn(Json{{"i", (*children)[0]}}, "i", nodes.size());
    return child >= 0 && motionIn(nodes[std::size_t(child)]) && std::ranges::binary_search(objects_, child);
}

/// One that hangs foreign nodes below it must stay for them.
void GltfParting::findOwnNodes(const Json& json) {
    const Json* nodes = arrayIn(root_, "nodes");
    const std::size_t count = nodes ? nodes->size() : 0;
    ownNodes_.assign(count, 0), restNodes_.assign(count, 0);
    if (!extensionOf(json)) return;
    for (std::size_t i = heads_["nodes"]; i < count; ++i) {
        const Json& node = (*nodes)[i];
        const bool isObject = std::ranges::binary_search(objects_, int(i));
        restNodes_[i] = isRest(node);
        ownNodes_[i] = restNodes_[i] || (extensionOf(node) && (isObject || !member(node, "mesh")));
    }
    for (bool changed = true; std::exchange(changed, false);)
        for (std::size_t i = 0; i < count; ++i) {
            const Json* children = member((*nodes)[i], "children");
            if (!ownNodes_[i] || restNodes_[i] || !children || !children->is_array()) continue;
            const bool isBody = extensionOf((*nodes)[i])->contains("role");
            for (const Json& child : *children) {
                const int index = indexIn(Json{{"i", child}}, "i", count);
                if (index < 0 || ownNodes_[std::size_t(index)]) continue;
                if (isBody && std::ranges::binary_search(objects_, index)) continue; // it is hung anew
                ownNodes_[i] = 0, changed = true;
            }
        }
}

void GltfParting::visitMaterials(const Json& node, const auto& visit) {
    Json* meshes = arrayIn(root_, "meshes");
    const int mesh = meshes ? indexIn(node, "mesh", meshes->size()) : -1;
    if (mesh < 0) return;
    visitReferences("meshes", (*meshes)[std::size_t(mesh)],
                    [&](const char* array, const Json& index, Naming) {
                        if (std::string_view(array) == "materials") visit(index.get<std::size_t>());
                    });
}

void GltfParting::strip(bool mechanics) {
    if (mechanics) eraseMechanics(root_);
    const std::vector<std::string> copies = copiesIn(root_);
    eraseCopies(root_, copies);
    eraseMotions(root_, [&](int node) {
        return std::ranges::binary_search(objects_, node) ||
               (std::size_t(node) < restNodes_.size() && restNodes_[std::size_t(node)]);
    });
    Json* nodes = arrayIn(root_, "nodes");
    for (std::size_t i = 0; i < restNodes_.size(); ++i) { // an object that stays for its children stays there
        if (!restNodes_[i]) continue;
        Json& moving = (*nodes)[(*nodes)[i]["children"][0].get<std::size_t>()];
        for (const char* key : {"translation", "rotation"})
            if (const Json* rest = member((*nodes)[i], key)) moving[key] = *rest;
    }
    // Of a node that is not shown nothing has become an object: it keeps what it had, but for the copies.
    std::set<std::size_t> felt;
    for (std::size_t i = 0; i < ownNodes_.size(); ++i) {
        Json& node = (*nodes)[i];
        const bool isObject = std::ranges::binary_search(objects_, int(i));
        if (isObject || extensionOf(node)) eraseCopies(node, copies);
        if (const Json* ours = extensionOf(node); ours && ours->contains("role"))
            eraseExtension(node, kExtension); // of one that stays for what hangs below it
        if (!isObject) continue;
        if (const Json* pose = poseBelowBody(node)) // its body is ours, and goes
            node.update(*pose);
        visitMaterials(node, [&](std::size_t material) { felt.insert(material); });
        eraseExtension(node, kExtension);
        eraseExtension(node, kInstancing);
        for (const char* key : {"mesh", "skin", "weights"})
            node.erase(key);
    }
    if (Json* meshes = arrayIn(root_, "meshes"))
        for (Json& mesh : *meshes)
            if (extensionOf(mesh)) eraseCopies(mesh, copies);
    if (Json* materials = arrayIn(root_, "materials"))
        for (const std::size_t each : felt) {
            if (each >= materials->size()) continue;
            eraseLook((*materials)[each]);
            eraseMirror((*materials)[each]);
            eraseExtension((*materials)[each], kExtension);
        }
    if (Json* scenes = arrayIn(root_, "scenes"))
        for (Json& scene : *scenes)
            eraseMirror(scene);
    // What this version knows of our extension of the root is written anew; without other keys it goes.
    eraseUse(root_, kExtension);
    eraseInstancing(root_);
    if (!extensionOf(root_)) return;
    for (const char* key : {"version", "foreign", "copies", "finger", "gravity", "reach"})
        root_["extensions"][kExtension].erase(key);
    root_["extensions"][kExtension].erase(jsonKey(kProxyRadius.key));
    root_["extensions"][kExtension].erase(jsonKey(kShellRadius.key));
    for (const WorldField& field : kWorldFields)
        root_["extensions"][kExtension].erase(jsonKey(field.parameter->key));
    if (root_["extensions"][kExtension].empty()) eraseExtension(root_, kExtension);
}

/// Their nodes stay as places for what is kept beside them, and for what hangs below.
void GltfParting::stripCameras(const std::vector<int>& cameras) {
    for (const int each : cameras) {
        Json& node = root_["nodes"][std::size_t(each)];
        node.erase("camera");
        eraseExtension(node, kExtension);
    }
}

/// Follows what foreign elements name, and what is kept beside objects. What nothing at all has named is
/// another program's too.
void GltfParting::markForeign(const Json& json) {
    Json before = json;
    Marks named = foreign_;
    const VisitReference mark = [&](const char* array, const Json& index, Naming) {
        std::vector<char>& all = marks(named, array);
        if (index.get<std::size_t>() < all.size()) all[index.get<std::size_t>()] = 1;
    };
    for (const char* array : kGltfArrays)
        if (Json* all = arrayIn(before, array))
            for (Json& element : *all)
                visitReferences(array, element, mark);
    visitRootReferences(before, mark);
    for (const char* array : kGltfArrays) {
        const Json* all = arrayIn(root_, array);
        for (std::size_t i = 0; all && i < all->size(); ++i) {
            const bool isNode = std::string_view(array) == "nodes";
            const bool free = isNode ? !ownNodes_[i] : !marks(named, array)[i];
            if (isHead(array, i) || isAllForeign(array) || free) {
                marks(foreign_, array)[i] = 1;
                open_.emplace_back(array, i);
            } else if (isNode || std::string_view(array) == "materials") {
                keepNamedBy(array, (*all)[i]);
            } else if (std::string_view(array) == "meshes") {
                keepNamedBy(array, withoutGeometry((*all)[i]));
            }
        }
    }
    visitRootReferences(root_, [&](const char* array, const Json& index, Naming) {
        std::vector<char>& all = marks(foreign_, array);
        const std::size_t i = index.get<std::size_t>();
        if (i < all.size() && !std::exchange(all[i], 1)) open_.emplace_back(array, i);
    });
    while (!open_.empty()) {
        const auto [array, i] = open_.back();
        open_.pop_back();
        keepNamedBy(array, root_[array][i]);
    }
}

void GltfParting::keepNamedBy(const char* of, Json element) {
    visitReferences(of, element, [&](const char* array, const Json& index, Naming naming) {
        std::vector<char>& all = marks(foreign_, array);
        const std::size_t i = index.get<std::size_t>();
        if (naming == Naming::Lists || i >= all.size() || std::exchange(all[i], 1)) return;
        open_.emplace_back(array, i);
    });
}

void GltfParting::number() {
    for (const auto& [array, isForeign] : foreign_) {
        std::vector<int>& places = places_[array]; // of an array that is not there, too
        int next = 0;
        for (const char each : isForeign)
            places.push_back(each ? next++ : -1);
    }
}

int GltfParting::place(const char* array, int index) const {
    const std::vector<int>& all = places_.find(array)->second;
    return index >= 0 && std::size_t(index) < all.size() ? all[std::size_t(index)] : -1;
}

void GltfParting::renumber(const char* of, Json& element) const {
    visitReferences(of, element, [&](const char* array, Json& index, Naming naming) {
        const std::vector<int>& all = places_.find(array)->second;
        if (index.get<std::size_t>() >= all.size()) return; // damaged already
        const int now = all[index.get<std::size_t>()];
        if (now >= 0)
            index = now;
        else if (naming == Naming::Lists)
            index = nullptr;
    });
}

void GltfParting::settle(Json& root, std::string& binary) const {
    const auto renumbered = [&](const char* of, Json element) {
        renumber(of, element);
        return element;
    };
    // Another program may have packed the data anew: then none of it stands where it was counted.
    std::size_t head = std::min(headBytes_, binary.size());
    if (const Json* views = arrayIn(root, "bufferViews"))
        for (std::size_t i = 0; i < heads_.find("bufferViews")->second; ++i)
            if (sizeIn((*views)[i], "byteOffset") + sizeIn((*views)[i], "byteLength") > head) head = 0;
    std::string data = binary.substr(0, head);
    for (const char* array : kGltfArrays) {
        Json* all = arrayIn(root, array);
        if (!all || std::string_view(array) == "buffers") continue;
        Json left = Json::array();
        for (std::size_t i = 0; i < all->size(); ++i) {
            // Animations without the objects' channels are fewer than in the file; all that is left is
            // foreign.
            if (std::string_view(array) != "animations" && place(array, int(i)) < 0) continue;
            Json& element = left.emplace_back(renumbered(array, std::move((*all)[i])));
            if (std::string_view(array) != "bufferViews" || (isHead(array, i) && head > 0)) continue;
            data.resize((data.size() + 7) / 8 * 8, '\0');
            const std::size_t from = std::min(sizeIn(element, "byteOffset"), binary.size());
            element["byteOffset"] = data.size();
            data.append(binary, from, sizeIn(element, "byteLength"));
        }
        if (left.empty())
            root.erase(array);
        else
            *all = std::move(left);
    }
    const auto places = [&](const char* array, Json& index, Naming) {
        const std::vector<int>& all = places_.find(array)->second;
        const std::size_t i = index.get<std::size_t>();
        if (i < all.size() && all[i] >= 0) index = all[i];
    };
    visitRootReferences(root, places);
    // The scene that our writer adds to a file without one, and to which no other program added anything.
    const Json* scenes = arrayIn(root, "scenes");
    if (scenes && !isHead("scenes", 0) && *scenes == Json::array({Json::object()})) root.erase("scenes");
    binary = std::move(data);
}

/// Our writer makes them anew, and knows only its own members.
void GltfParting::noteLost(const Json& json) {
    for (const char* array : {"accessors", "bufferViews", "images", "textures"}) {
        const auto all = json.find(array);
        if (all == json.end() || !all->is_array()) continue;
        std::set<std::string> lost;
        std::size_t count = 0;
        for (std::size_t i = 0; i < all->size(); ++i) {
            if (place(array, int(i)) >= 0) continue;
            bool has = false;
            for (const char* key : {"extensions", "extras", "sampler"})
                if (member((*all)[i], key)) lost.insert(key), has = true;
            count += has;
        }
        if (count == 0) continue;
        std::string keys;
        for (const std::string& key : lost)
            keys += (keys.empty() ? "" : " and ") + key;
        warn(std::string(array) + ": " + keys + " of " + std::to_string(count) + " of its own " + array +
                 " come from another program",
             "not written when the scene is saved; keep them on a mesh, a node or a material");
    }
    if (const auto buffers = json.find("buffers"); buffers != json.end() && buffers->is_array())
        for (const Json& buffer : *buffers)
            if (member(buffer, "extras") || member(buffer, "extensions"))
                return warn("buffers: extras or extensions of a buffer come from another program",
                            "not written when the scene is saved, as all buffers become one");
}

void GltfParting::noteMoved() {
    std::size_t moved = 0;
    for (const auto& [array, places] : places_)
        for (std::size_t i = 0; i < places.size(); ++i)
            moved += places[i] >= 0 && places[i] != int(i);
    const Json* used = member(root_, "extensionsUsed");
    if (moved == 0 || !used || !used->is_array()) return;
    for (const Json& name : *used)
        if (name.is_string() && !followsReferences(name.get<std::string>()))
            warn(counted(moved, "element") +
                     " that another program added to the file get other indices, and " +
                     inQuotes(name.get<std::string>()) + " is not known here",
                 "indices inside of it stay as they are; look at it in that program after saving");
}

} // namespace tactum
