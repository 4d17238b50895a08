// What a file holds beside the scene: parts of other programs, which are given back when the scene is saved.
#pragma once

#include <memory>
#include <string>

namespace tactum {

/// Beside one value that came from a glTF file. Not a value of the scene: every two are equal, so that
/// neither undo nor a comparison sees it.
struct Kept {
    int index = -1; ///< of the element in KeptFile::json; -1 for none
    std::shared_ptr<const std::string>
        json; ///< the element as JSON, its known keys to be overwritten; may be null

    bool operator==(const Kept&) const { return true; }
};

/// Beside a scene: all of the file that did not become a part of it, with its data.
struct ForeignGltf {
    std::string json;   ///< a glTF root object
    std::string binary; ///< its only buffer
};
struct KeptFile {
    std::shared_ptr<const ForeignGltf> foreign; ///< null for a file without such parts

    bool operator==(const KeptFile&) const { return true; }
};

} // namespace tactum
