// What of a glTF file is ours and what another program's, whatever its place in the arrays.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/files/gltf/gltf_references.h"
#include "core/scene/findings.h"

namespace tactum {

/// Parts a file. Of one without our extension all is foreign and keeps its place. In one that we have written
/// the counts in the root say what was foreign then, and that keeps its place too. Of what comes behind, ours
/// is what only our objects name; all else was put in by another program, and moves to the foreign beginning.
class GltfParting {
public:
    /// `objects`: the nodes that became objects, in rising order; `cameras`: those that became saved cameras.
    /// `mechanics`: bodies and joints were read; our writer makes them anew.
    GltfParting(const Json& json, const std::vector<int>& objects, const std::vector<int>& cameras,
                bool mechanics);

    /// The root without what our writer makes anew: our extension and copies, the meshes of objects, the
    /// animations that move them. Elements of ours are in it still; settle() takes them out.
    const Json& root() const { return root_; }
    /// `root`, as it comes from root(), with the foreign elements alone; their data come from `binary`.
    void settle(Json& root, std::string& binary) const;

    /// The foreign place of an element; -1 for one of ours.
    int place(const char* array, int index) const;
    /// Gives the indices in an element of the file their foreign places.
    void renumber(const char* array, Json& element) const;

    /// What is wrong with the counts, and what of another program cannot be kept.
    const std::vector<Finding>& findings() const { return findings_; }

private:
    using Marks = std::map<std::string, std::vector<char>, std::less<>>;

    void readCounts(const Json& json);
    void strip(bool mechanics);
    void stripCameras(const std::vector<int>& cameras);
    void visitMaterials(const Json& node, const auto& visit);
    void findOwnNodes(const Json& json);
    bool isRest(const Json& node) const;
    void markForeign(const Json& json);
    void keepNamedBy(const char* array, Json element);
    void number();
    void noteLost(const Json& json);
    void noteMoved();
    void warn(const std::string& sentence, const std::string& remedy);
    bool isHead(const std::string& array, std::size_t index) const;
    std::vector<char>& marks(Marks& of, const char* array) { return of.find(array)->second; }

    const std::vector<int>& objects_;
    Json root_;
    std::map<std::string, std::size_t, std::less<>> heads_; ///< how many elements keep their places
    std::size_t headBytes_ = 0;
    Marks foreign_; ///< by array and index
    std::vector<char> ownNodes_, restNodes_;
    std::vector<std::pair<const char*, std::size_t>> open_; ///< foreign, their references not followed yet
    std::map<std::string, std::vector<int>, std::less<>> places_;
    std::vector<Finding> findings_;
};

} // namespace tactum
