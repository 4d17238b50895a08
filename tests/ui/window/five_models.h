// Five models of five formats, each a box of two halves or of one piece, for a scene that is built of them.
#pragma once

#include <QTemporaryDir>

namespace tactum::test {

/// cup.obj, jug.gltf and bowl.dae have two surfaces with colours of their own, an upper half and a lower one;
/// those of the jug are rough and metallic to another degree than usual and have texture coordinates. pot.stl
/// and jar.ply are one surface without a colour. No two sides of any box are of one length, so that no axis
/// is taken for another.
void writeFiveModels(const QTemporaryDir& folder);

/// What jug.gltf says of its two materials: how rough, how metallic.
inline constexpr double kJugLow[] = {0.35, 0.75}, kJugHigh[] = {0.9, 0.125};
/// Of what comes from files that say neither.
inline constexpr double kUsualLook[] = {0.7, 0};

} // namespace tactum::test
