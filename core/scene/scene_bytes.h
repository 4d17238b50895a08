// A scene as bytes, the one form of it for the import process, recordings and the network.
#pragma once

#include <functional>

#include "core/base/byte_stream.h"
#include "core/scene/known_parts.h"
#include "core/scene/layer_bytes.h"

namespace tactum {

/// What objects share, each once: it comes before what names it, and is known only after that was written.
struct SceneTables {
    LayerTables shared;
    SharedTable<TriangleSoup> soups;
    SharedTable<Motion> motions;
};

// They write to a StringOut and read from a ByteIn, which throws ByteFault at everything that a scene cannot
// be. Names are safe to print then. Thread of all: any but real time.

/// Without its group and its selection sets, which recordings have no use for: their form stays what it was.
template <class Io> void objectBytes(Io& io, SceneObject& object, SceneTables& tables);
/// What of an object that is there already is its author's alone: its group, its selection sets.
template <class Io> void authorBytes(Io& io, SceneObject& object);
template <class Io> void sceneBytes(Io& io, Scene& scene, SceneTables& tables);

/// What is in `elsewhere` is only named.
void writeTables(ByteOut& out, const SceneTables& tables, const KnownParts& elsewhere = {});
/// For what is only named: where to look, asked once, and what to say when it is not there.
struct Elsewhere {
    std::function<KnownParts()> parts = [] { return KnownParts(); };
    Error missing{Error::Kind::Input, "it names a part that is not there"};
};
void readTables(ByteIn& in, SceneTables& tables, const Elsewhere& elsewhere = {});

/// A scene and all that it names.
std::string bytesOf(const Scene& scene, const KnownParts& elsewhere = {});
Scene readScene(ByteIn& in, const Elsewhere& elsewhere = {});

/// Without what nobody wants but who writes its file again.
SceneObject withoutKept(SceneObject object);
Scene withoutKept(Scene scene);

} // namespace tactum
