// One mesh written in every format that loadScene() reads, and a folder to put files into.
#pragma once

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <QTemporaryDir>

#include "core/files/load_scene.h"
#include "core/geometry/triangle_soup.h"

namespace tactum {

/// Files that vanish with the test.
class FileFolder {
public:
    std::filesystem::path write(const std::string& name, const std::string& content) const {
        const std::filesystem::path file = path() / name;
        std::filesystem::remove(file); // a new file is not flushed to the disk, one written over is
        std::ofstream(file, std::ios::binary) << content;
        return file;
    }
    Result<LoadedScene> load(const std::string& name, const std::string& content) const {
        return loadScene(write(name, content));
    }
    std::filesystem::path path() const { return folder_.path().toStdString(); }

private:
    QTemporaryDir folder_;
};

enum class PlyForm { Text, LittleEndian, BigEndian };

/// What the loader found, one sentence a line.
std::string said(const LoadedScene& loaded);

/// Coordinates must be such that float holds them exactly: the binary formats have no more.
std::string asObj(const TriangleSoup& soup);
std::string asPly(const TriangleSoup& soup, PlyForm form);
std::string asStlText(const TriangleSoup& soup);
std::string asStlBinary(const TriangleSoup& soup);
std::string asOff(const TriangleSoup& soup);
/// `nodes`: the members "scenes", "nodes" and more of the JSON; empty for one node with mesh 0.
std::string asGltf(const TriangleSoup& soup, const std::string& nodes = "");
std::string asGlb(const TriangleSoup& soup, const std::string& nodes = "");

/// One animated property of one node: a row of `values` for each key, three rows for a cubic.
struct WrittenChannel {
    int node = 0;
    std::string path; ///< "translation", "rotation", "scale" or "weights"
    std::string interpolation = "LINEAR";
    std::vector<double> times;
    std::vector<std::vector<double>> values;
};
/// A glb of mesh and nodes as above with one animation.
std::string asAnimatedGlb(const TriangleSoup& soup, const std::string& nodes,
                          const std::vector<WrittenChannel>& channels);

struct WrittenMesh {
    std::string name; ///< with its ending
    std::string content;
};
/// The mesh in each of the formats.
std::vector<WrittenMesh> inEveryFormat(const TriangleSoup& soup);

} // namespace tactum
