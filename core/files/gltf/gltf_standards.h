// What other programs understand of a scene's feel: MPEG_haptic_material, KHR_physics_rigid_bodies and the
// normalTexture of a material in glTF.
//
// All are degraded copies beside our own extension, which alone is exact. A file that came with one of them
// from another program keeps that one as it is. Sources: the schema of MPEG_haptic_material (ISO/IEC DIS
// 23090-14, second edition) and of KHR_physics_rigid_bodies as they are proposed to the glTF registry.
#pragma once

#include <string>
#include <vector>

#include "core/files/gltf/gltf_data.h"
#include "core/files/gltf/gltf_maps.h"
#include "core/files/gltf/gltf_surface.h"
#include "core/scene/scene.h"

namespace tactum {

inline constexpr const char* kMpegExtension = "MPEG_haptic_material";
inline constexpr const char* kPhysicsExtension = "KHR_physics_rigid_bodies";
inline constexpr const char* kShapesExtension = "KHR_implicit_shapes";
inline constexpr const char* kOlderShapes = "KHR_collision_shapes"; ///< as a draft before called it
inline constexpr const char* kTransformExtension = "KHR_texture_transform";

/// Writes the copies of objects whose nodes and meshes are in the root already.
class StandardCopies {
public:
    /// `physics`: whether colliders may stand for what is felt; in a scene with bodies they touch each other.
    StandardCopies(Json& root, GltfData& data, SurfaceMaps& maps, bool physics);
    /// The look of a surface's height, where its object can show bumps and nobody has given the material
    /// another one.
    void addLook(const SceneObject& object, Index surface, Json& material);
    /// MPEG knows one material for a mesh: that of the surface with the most triangles. `mesh`: -1 for none.
    void add(const SceneObject& object, int node, int mesh);
    /// The names of the extensions that were written, for the reader to take away again.
    const std::vector<std::string>& wrote() const { return wrote_; }

private:
    int mpegMaterial(const SceneObject& object, Index surface);
    Json mpegTexture(Json info, double low, double high, std::string_view unit);
    Json mpegValue(const SceneObject& object, Index surface, double Material::*value,
                   const Parameter& parameter);
    int physicsMaterial(const Surface& surface);
    int valueTexture(double value, double most);
    Json textureInfo(const std::string& png, const UvCanvas& canvas);
    bool mayWrite(const char* extension) const;
    void use(const char* extension);

    Json& root_;
    GltfData& data_;
    SurfaceMaps& maps_;
    bool mpeg_, physics_, transform_;
    std::vector<std::string> wrote_;
};

/// The copies that our own writer made in the file of this root; empty for a file of another program.
std::vector<std::string> copiesIn(const Json& root);

/// Takes the copies away that our own writer made, from a root or one of its elements. What another program
/// has put beside them stays.
void eraseCopies(Json& element, const std::vector<std::string>& wrote);

/// Takes the look away that our own writer gave a material.
void eraseLook(Json& material);

/// What the copies of other programs say of a surface of this mesh and node; our own extension comes after
/// it. `said`: a sentence for each value that was taken, and how.
void readStandards(const Json& root, const Json& node, const Json& mesh, const ReadImageAt& imageAt,
                   Surface& surface, std::vector<std::string>& said);

} // namespace tactum
