// Edits as clients send them, made to a scene: every number judged, nothing trusted.
#pragma once

#include <functional>
#include <memory>

#include "core/files/load_scene.h"
#include "core/port/workspace.h"
#include "core/protocol/messages.h"
#include "core/protocol/scene_parts.h"

namespace tactum {

/// What a client has uploaded, by its number; null when there is no such thing.
using UploadOf = std::function<std::shared_ptr<const LoadedScene>(std::uint64_t)>;

/// Makes all edits, in their order; at the first that cannot be made the scene is worth nothing any more.
/// Errors name the edit by its place, from 1. Thread: any but real time.
Result<void> makeEdits(Scene& scene, const google::protobuf::RepeatedPtrField<v1::Edit>& edits,
                       const UploadOf& uploadOf, SceneParts& parts);

/// Errors: a number that is not finite or not within reach; a rotation of no length. No message: zero.
Result<Vec3> vectorOf(const v1::Vector& vector);
Result<Pose> poseOf(const v1::Pose& pose);
Result<Workspace> workspaceOf(const v1::Workspace& workspace);

} // namespace tactum
