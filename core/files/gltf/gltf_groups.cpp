#include "core/files/gltf/gltf_groups.h"

#include <algorithm>
#include <utility>

#include "core/base/text.h"
#include "core/files/gltf/gltf_surface.h"
#include "core/scene/numbered_names.h"

namespace tactum {
namespace {

bool hasGroupRole(const Json& node) {
    const Json* ours = node.is_object() ? extensionOf(node) : nullptr;
    const Json* role = ours ? member(*ours, "role") : nullptr;
    return role && *role == kGroupRole && !member(node, "mesh");
}

bool hasPlace(const Json& node) {
    return std::ranges::any_of(std::array{"translation", "rotation", "scale", "matrix"},
                               [&](const char* key) { return node.contains(key); });
}

} // namespace

GltfGroups::GltfGroups(Json& root) : root_(root), nodes_(arrayIn(root, "nodes")) {
    if (!nodes_) return;
    findGroups();
    if (std::ranges::find(isGroup_, 1) != isGroup_.end()) takeAllApart();
    say();
}

void GltfGroups::takeAllApart() {
    Json* scenes = arrayIn(root_, "scenes");
    for (std::size_t i = 0; i < nodes_->size(); ++i)
        if (!isGroup_[i]) claim((*nodes_)[i], "children");
    for (std::size_t i = 0; scenes && i < scenes->size(); ++i)
        claim((*scenes)[i], "nodes");
    for (std::size_t i = 0; scenes && i < scenes->size(); ++i)
        flatten((*scenes)[i], "nodes");
    for (std::size_t i = 0; i < nodes_->size(); ++i)
        if (!isGroup_[i]) flatten((*nodes_)[i], "children");
    for (std::size_t i = 0; i < nodes_->size(); ++i) // which nothing that is shown leads to, too
        if (isGroup_[i]) (*nodes_)[i].erase("children");
    nameThem();
}

int GltfGroups::indexOf(const Json& index) const {
    return indexIn(Json{{"i", index}}, "i", nodes_->size());
}

void GltfGroups::findGroups() {
    const std::size_t count = nodes_->size();
    isGroup_.assign(count, 0), claimed_.assign(count, 0), seen_.assign(count, 0);
    groupOf_.assign(count, -1), parent_.assign(count, -1);
    for (std::size_t i = 0; i < count; ++i)
        if (hasGroupRole((*nodes_)[i])) hasPlace((*nodes_)[i]) ? ++placed_ : isGroup_[i] = 1;
}

/// What hangs elsewhere than on a group stays there.
void GltfGroups::claim(const Json& of, const char* key) {
    const Json* list = of.is_object() ? member(of, key) : nullptr;
    if (!list || !list->is_array()) return;
    for (const Json& each : *list)
        if (const int index = indexOf(each); index >= 0) claimed_[std::size_t(index)] = 1;
}

void GltfGroups::flatten(Json& of, const char* key) {
    Json* list = arrayIn(of, key);
    if (!list) return;
    const bool isNode = std::string_view(key) == "children";
    const int parent = isNode ? int(&of - &(*nodes_)[0]) : -1;
    Json flat = Json::array();
    for (Json& each : *list) {
        const int index = indexOf(each);
        if (index >= 0 && isGroup_[std::size_t(index)])
            takeApart(index, flat);
        else
            flat.push_back(std::move(each));
    }
    for (const Json& each : flat)
        if (const int index = indexOf(each); index >= 0 && isNode) parent_[std::size_t(index)] = parent;
    if (flat.empty())
        of.erase(key);
    else
        *list = std::move(flat);
}

/// A group in a group, and in that one more, are groups of their own beside it.
void GltfGroups::takeApart(int group, Json& list) {
    for (std::vector<int> open{group}; !open.empty();) {
        const int at = open.back();
        open.pop_back();
        if (std::exchange(seen_[std::size_t(at)], 1)) {
            ++doubled_;
            continue;
        }
        const Json* children = arrayIn((*nodes_)[std::size_t(at)], "children");
        for (const Json& each : children ? *children : Json::array()) {
            const int index = indexOf(each);
            if (index < 0)
                ++missing_;
            else if (isGroup_[std::size_t(index)])
                ++nested_, open.push_back(index);
            else if (std::exchange(claimed_[std::size_t(index)], 1))
                ++doubled_;
            else
                groupOf_[std::size_t(index)] = at, list.push_back(index);
        }
    }
}

void GltfGroups::nameThem() {
    names_.resize(nodes_->size());
    std::vector<char> used(nodes_->size(), 0);
    for (const int group : groupOf_)
        if (group >= 0) used[std::size_t(group)] = 1;
    NumberedNames names;
    for (std::size_t i = 0; i < used.size(); ++i) {
        if (!used[i]) continue;
        const Json* name = member((*nodes_)[i], "name");
        const std::string wanted =
            name && name->is_string() ? printable(name->get<std::string>(), kLongestName) : std::string();
        names_[i] = names.take(wanted.empty() ? "Group" : wanted);
    }
}

void GltfGroups::say() {
    std::string wrong;
    const auto add = [&](std::size_t count, const char* what) {
        if (count > 0) wrong += (wrong.empty() ? "" : ", ") + std::to_string(count) + " " + what;
    };
    add(missing_, "with members that are not there");
    add(doubled_, "with members that are elsewhere already");
    add(nested_, "inside of others");
    add(placed_, "with a place of their own");
    if (!wrong.empty())
        findings_.push_back({Finding::Severity::Warning, "",
                             "groups cannot be as the file has them: " + wrong,
                             "what is wrong with them is left out; all objects are there, group them anew"});
}

std::string GltfGroups::of(int node) const {
    for (std::size_t level = 0; node >= 0 && level <= groupOf_.size();
         node = parent_[std::size_t(node)], ++level)
        if (names_.empty())
            return {};
        else if (const int group = groupOf_[std::size_t(node)]; group >= 0)
            return names_[std::size_t(group)];
    return {};
}

Json groupNodeJson(const std::string& name) {
    return {{"name", name}, {"extensions", {{kExtension, {{"role", kGroupRole}}}}}};
}

} // namespace tactum
