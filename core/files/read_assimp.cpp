// 3DS, FBX and DAE, read by Assimp out of memory: it opens no file. Every node with meshes is an object in
// the world's frame, every material of it a surface. Assimp takes the axes and the unit of DAE into the
// root's transform; those of FBX it hands over as numbers.
#include <assimp/BaseImporter.h>
#include <assimp/Importer.hpp>
#include <assimp/ProgressHandler.hpp>
#include <assimp/importerdesc.h>
#include <assimp/material.h>
#include <assimp/scene.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include <Eigen/Eigenvalues>

#include "core/base/text.h"
#include "core/files/bump_layers.h"
#include "core/files/fbx_head.h"
#include "core/files/world_mesh.h"

namespace tactum {
namespace {

using Severity = Finding::Severity;

/// Returns false where Assimp should stop.
class Listener final : public Assimp::ProgressHandler {
public:
    explicit Listener(const Progress& progress) : progress_(progress) {}
    bool Update(float part) override {
        if (progress_.report && part > 0) progress_.report(std::min(0.7, 0.7 * double(part)));
        return !progress_.isCancelled();
    }

private:
    const Progress& progress_;
};

/// Only the reader that was asked for: the others would try their luck with a file that is not what it is
/// called.
void keepReaderOf(Assimp::Importer& importer, const std::string& ending) {
    for (std::size_t i = importer.GetImporterCount(); i-- > 0;) {
        const std::string endings = " " + std::string(importer.GetImporterInfo(i)->mFileExtensions) + " ";
        if (endings.find(" " + ending + " ") != std::string::npos) continue;
        Assimp::BaseImporter* other = importer.GetImporter(i);
        importer.UnregisterLoader(other);
        delete other;
    }
}

/// Assimp makes a chain of nodes of what moves one node of FBX: "lid_$AssimpFbx$_PreRotation" above "lid".
constexpr std::string_view kHelper = "_$AssimpFbx$_";

bool isHelper(const aiNode& node) {
    return std::string_view(node.mName.C_Str()).find(kHelper) != std::string_view::npos;
}

template <class T> std::optional<T> said(const aiMetadata* data, const char* key) {
    T value{};
    if (!data || !data->Get(key, value)) return std::nullopt;
    return value;
}

FbxAxis axisOf(const aiMetadata* data, const char* axis, const char* sign, int usual) {
    return {said<int>(data, axis).value_or(usual), said<int>(data, sign).value_or(1)};
}

/// How much larger the longest and the shortest of three axes have become.
std::pair<double, double> scalesOf(const Mat3& linear) {
    const Vec3 squares = Eigen::SelfAdjointEigenSolver<Mat3>(linear.transpose() * linear).eigenvalues();
    return {std::sqrt(std::max(0.0, squares[0])), std::sqrt(std::max(0.0, squares[2]))};
}

Eigen::Affine3d affineOf(const aiMatrix4x4& m) {
    Eigen::Affine3d affine;
    affine.matrix() << m.a1, m.a2, m.a3, m.a4, m.b1, m.b2, m.b3, m.b4, m.c1, m.c2, m.c3, m.c4, m.d1, m.d2,
        m.d3, m.d4;
    return affine;
}

class AssimpReader {
public:
    AssimpReader(const Source& source, const Progress& progress)
        : source_(source), progress_(progress), ending_(lowerCase(source.path().extension().string())),
          bumps_(source.path().parent_path()) {
        ending_.erase(0, 1);
    }

    LoadedScene read() {
        if (ending_ == "fbx")
            if (const auto refusal = fbxRefusal(source_.bytes())) source_.fail(*refusal);
        keepReaderOf(importer_, ending_);
        // Without pivots Assimp hands a node's geometric transform down to its children.
        importer_.SetPropertyBool(AI_CONFIG_IMPORT_FBX_PRESERVE_PIVOTS, true);
        importer_.SetPropertyBool(AI_CONFIG_IMPORT_COLLADA_USE_COLLADA_NAMES, true);
        importer_.SetProgressHandler(new Listener(progress_)); // the importer's own from here on
        const std::string_view bytes = source_.bytes();
        scene_ = importer_.ReadFileFromMemory(bytes.data(), bytes.size(), 0, ending_.c_str());
        if (progress_.isCancelled()) throw ReadFault{cancelledError().value()};
        if (!scene_ || !scene_->mRootNode)
            source_.fail("cannot be read" + reason() +
                         "; the file may be damaged: export it again, or as glTF");
        demandBounded();
        walk();
        sayWhatIsLeftOut();
        loaded_.unitGuessed = !hasUnit();
        loaded_.upGuessed = ending_ == "3ds"; // the others say it, or their format does
        if (loaded_.unitGuessed) loaded_.findings.push_back(unitGuess(loaded_.scene));
        return std::move(loaded_);
    }

private:
    /// As Assimp says it; nothing where it speaks of its own name for what lies in memory.
    std::string reason() const {
        const std::string_view said = importer_.GetErrorString();
        return said.empty() || said.find("$$$") != std::string_view::npos ? "" : ": " + printable(said, 300);
    }

    /// What one unit of the vertices is beyond the transforms, in metres.
    double unit() const {
        float centimetres = 0;
        const bool known = scene_->mMetaData && scene_->mMetaData->Get("UnitScaleFactor", centimetres);
        return known && centimetres > 0 ? 0.01 * double(centimetres) : 1;
    }

    /// From the file's axes and unit to ours.
    Eigen::Affine3d toOurs() {
        const aiMetadata* const data = scene_->mMetaData;
        const auto axes = fromFbxAxes(axisOf(data, "CoordAxis", "CoordAxisSign", 0),
                                      axisOf(data, "UpAxis", "UpAxisSign", 1),
                                      axisOf(data, "FrontAxis", "FrontAxisSign", 2));
        if (!axes)
            loaded_.findings.push_back({Severity::Warning, "", "names axes that are no frame",
                                        "y is taken as up; turn it if it is not"});
        return Eigen::Affine3d(unit() * axes.value_or(Mat3::Identity()));
    }

    bool hasUnit() const {
        if (ending_ == "fbx")
            return unit() != 1 || source_.bytes().find("UnitScaleFactor") != std::string_view::npos;
        return ending_ == "dae" && source_.bytes().find("meter=") != std::string_view::npos;
    }

    /// One mesh may stand under any number of nodes.
    void demandBounded() const {
        std::size_t shown = 0;
        std::uint64_t faces = 0;
        std::vector<const aiNode*> open{scene_->mRootNode};
        while (!open.empty()) {
            const aiNode& node = *open.back();
            open.pop_back();
            shown += node.mNumMeshes > 0;
            for (unsigned i = 0; i < node.mNumMeshes; ++i)
                faces += scene_->mMeshes[node.mMeshes[i]]->mNumFaces;
            open.insert(open.end(), node.mChildren, node.mChildren + node.mNumChildren);
        }
        tactum::demandBounded(source_, shown, faces);
    }

    struct Step {
        const aiNode* node;
        Eigen::Affine3d toWorld; ///< of what is above it
        Mat3 parent;             ///< the linear part of it, where the node above in the file stands
    };

    void walk() {
        const Eigen::Affine3d root = toOurs();
        std::vector<Step> open{{scene_->mRootNode, root, root.linear()}};
        while (!open.empty()) {
            const Step step = open.back();
            open.pop_back();
            const Eigen::Affine3d here =
                isIdle(*step.node) ? step.toWorld : step.toWorld * affineOf(step.node->mTransformation);
            if (step.node->mNumMeshes > 0) {
                oddlyScaled_ += inheritsScaleOddly(step);
                add(*step.node, here);
            }
            const Mat3 parent = isHelper(*step.node) ? step.parent : here.linear();
            for (unsigned i = step.node->mNumChildren; i-- > 0;)
                open.push_back({step.node->mChildren[i], here, parent});
        }
    }

    /// A rotation before or after that of a node whose "RotationActive" is off: FBX leaves it out.
    bool isIdle(const aiNode& node) const {
        const std::string_view name = node.mName.C_Str();
        if (!name.ends_with("_$AssimpFbx$_PreRotation") && !name.ends_with("_$AssimpFbx$_PostRotation"))
            return false;
        const aiNode* moved = &node;
        while (isHelper(*moved) && moved->mNumChildren > 0)
            moved = moved->mChildren[0];
        return !said<bool>(moved->mMetaData, "RotationActive").value_or(activeUnsaid_);
    }

    /// The scale above a node acts otherwise than by the product of the transforms.
    bool inheritsScaleOddly(const Step& step) const {
        constexpr int kProduct = 1, kWithoutParent = 2;
        const int kind = said<int>(step.node->mMetaData, "InheritType").value_or(kProduct);
        if (kind == kProduct) return false;
        const auto [least, most] = scalesOf(step.parent / unit());
        return most > 1.0001 * least || (kind == kWithoutParent && std::abs(most - 1) > 1e-4);
    }

    void add(const aiNode& node, const Eigen::Affine3d& toWorld) {
        WorldMesh mesh(source_, toWorld);
        std::vector<Surface> surfaces;
        std::map<unsigned, Index> surfaceOf;
        for (unsigned i = 0; i < node.mNumMeshes; ++i) {
            const aiMesh& part = *scene_->mMeshes[node.mMeshes[i]];
            const auto [place, isNew] = surfaceOf.try_emplace(part.mMaterialIndex, Index(surfaces.size()));
            if (isNew) surfaces.push_back(surfaceOfMaterial(part.mMaterialIndex));
            add(part, mesh, place->second);
            deformed_ += part.mNumBones > 0 || part.mNumAnimMeshes > 0;
        }
        mesh.addTo(loaded_, nameOf(node), std::move(surfaces), progress_);
    }

    std::string nameOf(const aiNode& node) const {
        // What has no node of its own in a 3DS file loses its name to Assimp.
        const std::string name = node.mName.C_Str();
        return name.empty() || name.starts_with("3DSMesh_") ? stemOf(source_) : name;
    }

    void add(const aiMesh& part, WorldMesh& mesh, Index surface) {
        std::vector<PolygonCorner> vertices(part.mNumVertices);
        for (unsigned i = 0; i < part.mNumVertices; ++i) {
            // One vertex for each corner is Assimp's way; here equal places are one.
            const aiVector3D& p = part.mVertices[i];
            vertices[i].position = mesh.position({p.x, p.y, p.z}, true);
            if (part.mNormals)
                vertices[i].normal =
                    mesh.normal({part.mNormals[i].x, part.mNormals[i].y, part.mNormals[i].z});
            if (part.mTextureCoords[0])
                vertices[i].uv = mesh.uv({part.mTextureCoords[0][i].x, part.mTextureCoords[0][i].y});
        }
        for (unsigned f = 0; f < part.mNumFaces; ++f) {
            if (progress_.isCancelled()) throw ReadFault{cancelledError().value()};
            const aiFace& face = part.mFaces[f];
            std::vector<PolygonCorner> corners(face.mNumIndices);
            for (unsigned i = 0; i < face.mNumIndices; ++i) {
                if (face.mIndices[i] >= part.mNumVertices)
                    source_.fail("a face refers to a vertex that is not there; export the file again");
                corners[i] = vertices[face.mIndices[i]];
            }
            mesh.polygon(std::move(corners), surface);
        }
    }

    Surface surfaceOfMaterial(unsigned index) {
        if (index >= scene_->mNumMaterials) return namedSurface("surface");
        const aiMaterial& material = *scene_->mMaterials[index];
        aiString name, picture;
        aiColor3D colour;
        Surface surface = namedSurface("surface");
        if (material.Get(AI_MATKEY_NAME, name) == AI_SUCCESS && name.length > 0) surface.name = name.C_Str();
        if (material.Get(AI_MATKEY_COLOR_DIFFUSE, colour) == AI_SUCCESS)
            for (unsigned i = 0; i < 3; ++i)
                if (std::isfinite(colour[i])) surface.colour[int(i)] = float(std::clamp(colour[i], 0.f, 1.f));
        if (material.GetTexture(aiTextureType_HEIGHT, 0, &picture) == AI_SUCCESS) {
            MtlBump bump;
            bump.file = picture.C_Str();
            if (auto layer = bumps_.layerOf(bump, loaded_.findings)) surface.layers.push_back(*layer);
        }
        return surface;
    }

    void sayWhatIsLeftOut() {
        const auto say = [&](Severity severity, std::size_t count, std::string_view noun,
                             const char* sentence, const char* remedy) {
            if (count > 0)
                loaded_.findings.push_back({severity, "", counted(count, noun) + sentence, remedy});
        };
        say(Severity::Warning, scene_->mNumAnimations, "animation", " left out",
            "everything stands where the file puts it; export it as glTF to let it move");
        say(Severity::Warning, deformed_, "mesh part", " deformed by a skin or by morph targets",
            "felt in the shape that it has at rest");
        say(Severity::Warning, oddlyScaled_, "mesh", " under a scaled parent whose scale it does not share",
            "size and place may be wrong; apply the scales before you export");
        say(Severity::Note, scene_->mNumCameras, "camera", " left out", "the view shows everything");
        say(Severity::Note, scene_->mNumLights, "light", " left out", "not felt");
        say(Severity::Note, scene_->mNumTextures, "picture", " inside the file left out",
            "put it beside the file to use it as a haptic texture");
    }

    const Source& source_;
    const Progress& progress_;
    std::string ending_;
    BumpLayers bumps_;
    Assimp::Importer importer_;
    const aiScene* scene_ = nullptr;
    LoadedScene loaded_;
    std::size_t deformed_ = 0, oddlyScaled_ = 0;
    /// Where no node of the file speaks of it.
    const bool activeUnsaid_ = source_.bytes().find("RotationActive") == std::string_view::npos;
};

} // namespace

LoadedScene readAssimp(const Source& source, const Progress& progress) {
    return AssimpReader(source, progress).read();
}

} // namespace tactum
