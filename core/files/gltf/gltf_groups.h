// Groups of a scene as nodes of a glTF file: one without a place of its own above each, at the root.
#pragma once

#include <string>
#include <vector>

#include "core/files/gltf/gltf_model.h"
#include "core/scene/findings.h"

namespace tactum {

/// What our extension of a node says it was made for.
inline constexpr const char* kGroupRole = "group";

/// The groups of a file that is read. Whatever hung on one hangs on what that hung on from here on: nobody
/// else has to know of them. What a file cannot mean is in no group, or in that where it was found first; one
/// finding says it.
class GltfGroups {
public:
    /// Takes them out of the tree of `root`.
    explicit GltfGroups(Json& root);
    /// Of a node, or of the nearest one above it; empty: none. The tree has been seen to have no cycle.
    std::string of(int node) const;
    const std::vector<Finding>& findings() const { return findings_; }

private:
    int indexOf(const Json& index) const;
    void findGroups();
    void claim(const Json& of, const char* key);
    void flatten(Json& of, const char* key);
    void takeAllApart();
    void takeApart(int group, Json& list);
    void nameThem();
    void say();

    Json& root_;
    Json* nodes_ = nullptr;
    std::vector<char> isGroup_, claimed_, seen_;
    std::vector<int> groupOf_, parent_; ///< by node; -1 for none
    std::vector<std::string> names_;    ///< by group node
    std::vector<Finding> findings_;
    std::size_t missing_ = 0, doubled_ = 0, nested_ = 0, placed_ = 0;
};

/// The node of one; its children are to be added.
Json groupNodeJson(const std::string& name);

} // namespace tactum
