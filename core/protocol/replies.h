// What the server knows as the messages that tell it.
#pragma once

#include "core/protocol/messages.h"
#include "core/session/stage.h"

namespace tactum {

/// `bodies`: with the places of those that forces move.
void write(v1::State& to, const StageState& state, bool bodies);
void write(v1::Event& to, const StageEvent& event);
void write(v1::Device& to, const DeviceInfo& device);
void write(v1::SceneDescription& to, const Stage::Scenery& scenery);

/// For a client: its kind as gRPC says it, and the sentence.
grpc::Status statusOf(const Error& error);

} // namespace tactum
