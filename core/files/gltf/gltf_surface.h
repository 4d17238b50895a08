// The feel of a surface as JSON and back: our extension of a glTF material. docs/format.md says it in words.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/files/gltf/gltf_file.h"
#include "core/scene/scene.h"

namespace tactum {

/// The one name under which everything of ours is found in a glTF file.
inline constexpr const char* kExtension = "TACTUM_haptics";
/// Of the format. Another major number is another format, a higher minor one has keys that we do not know.
inline constexpr int kFormatMajor = 1, kFormatMinor = 0;

/// What is painted on a mesh is an attribute of its vertices, whose name is this and a number.
inline constexpr std::string_view kPaintAttribute = "_TACTUM_PAINT_";
inline constexpr int kMaxPaints = 1 << 16; ///< of one mesh
/// Values of all meshes together: a small file can name one list of them very often.
inline constexpr std::size_t kMaxPaintedValues = std::size_t(1) << 25;
/// The number in the name of an attribute; -1 for any other attribute.
int paintNumber(std::string_view attribute);

/// The extension object of an element, or null.
const Json* extensionOf(const Json& element, const char* name = kExtension);
/// Takes an extension away from an element, and its name from those that a root uses.
void eraseExtension(Json& element, const std::string& name);
void eraseUse(Json& root, const std::string& name);
/// A member, or null.
const Json* member(const Json& object, const char* key);
/// A member that is an index below `end`, or -1.
int indexIn(const Json& object, const char* key, std::size_t end);
/// A member that is a whole number from zero on, or zero: as tinygltf reads an offset.
std::size_t sizeIn(const Json& object, const char* key);

/// The version in the extension of a root, when it is of a greater major number than ours: the file is not
/// ours to read or to replace.
std::optional<std::string> laterFormat(const Json& root);
/// The version, for a sentence, when it is no text of two numbers from 1.0 on, and not a later one either.
std::optional<std::string> strangeVersion(const Json& root);

/// "static-friction" as "staticFriction": how a parameter's key is spelled in JSON.
std::string jsonKey(std::string_view key);

/// The texture index of an image.
using WriteImage = std::function<int(const std::shared_ptr<const TextureImage>&)>;
/// The image of a texture index; null when there is none, which it says itself.
using ReadImageAt = std::function<std::shared_ptr<const TextureImage>(int texture)>;

/// What stands for painted values in a pattern, and these again; null when it is damaged, which it says
/// itself.
using WritePaint = std::function<Json(const std::shared_ptr<const PaintedValues>&)>;
using ReadPaint = std::function<std::shared_ptr<const PaintedValues>(const Json& painted)>;

/// Where the large things are that a surface shares with others.
struct WriteShared {
    WriteImage textureOf;
    WritePaint paintOf;
};
struct ReadShared {
    ReadImageAt imageAt;
    ReadPaint paintAt;
};

Json surfaceJson(const Surface& surface, const WriteShared& shared);

/// Fills material, sides, shading and layers; what is missing stays initial. `where`: what the JSON is called
/// where it was found. `complaints`: a sentence for each member that has a wrong type or an unknown word,
/// which stays initial too. Numbers out of range are
/// kept as they are: validation speaks of them.
void readSurfaceJson(const Json& json, const char* where, const ReadShared& shared, Surface& surface,
                     std::vector<std::string>& complaints);

/// Translation and rotation under the keys of a glTF node; nothing for what is not there.
Json poseJson(const Pose& pose);
/// The same as the standard bounds it: no number of a rotation is above 1, not by the last bit.
Json nodePoseJson(const Pose& pose);
/// The member "pose" of an extension of ours, which says exactly what the product of transforms comes near;
/// nothing where it is missing, or not that of the nodes any more.
std::optional<Pose> exactPose(const Json& ours, const Pose& near);
Json vectorJson(const Vec3& v);
Json quaternionJson(const Quat& q); ///< x, y, z, w

} // namespace tactum
