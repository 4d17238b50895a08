#include "core/import/scene_transfer.h"

#include "core/base/text.h"
#include "core/scene/scene_bytes.h"

namespace tactum {
namespace {

constexpr std::size_t kLongestSentence = 4000;

/// Text for a person: it may be shown in a window and on a terminal.
template <class Io> void shownText(Io& io, std::string& text, std::size_t limit) {
    io(text);
    if constexpr (Io::kReads) text = printable(text, limit);
}

template <class Io> void findingBytes(Io& io, Finding& finding) {
    auto& [severity, object, sentence, remedy] = finding;
    choose(io, severity, 3);
    shownText(io, object, kLongestName);
    shownText(io, sentence, kLongestSentence), shownText(io, remedy, kLongestSentence);
}

template <class Io> void loadedBytes(Io& io, LoadedScene& loaded, SceneTables& tables) {
    auto& [scene, findings, ours, unitGuessed, upGuessed] = loaded; // all: another one does not compile
    io(ours), io(unitGuessed), io(upGuessed);
    sceneBytes(io, scene, tables);
    io.count(findings, 25);
    for (Finding& finding : findings)
        findingBytes(io, finding);
}

} // namespace

void writeTransfer(ByteOut& out, const LoadedScene& loaded) {
    SceneTables tables;
    StringOut values;
    loadedBytes(values, const_cast<LoadedScene&>(loaded), tables); // writing does not touch it
    writeTables(out, tables);
    out.append(values.bytes.data(), values.bytes.size());
}

LoadedScene readTransfer(std::string_view bytes) {
    ByteIn in(bytes, "the scene from the import process", 0,
              "the reader was broken by the file; do not trust it");
    SceneTables tables;
    readTables(in, tables);
    LoadedScene loaded;
    loadedBytes(in, loaded, tables);
    in.demand(in.left() == 0, "it is followed by something else");
    return loaded;
}

} // namespace tactum
