// Files that lie, exaggerate, go in circles or break off, in every format that is read.
#pragma once

#include <string>
#include <vector>

#include "tests/core/files/mesh_files.h"

namespace tactum::test {

/// A sound file of each format.
std::vector<WrittenMesh> soundFiles();
/// Every sound file, cut off at each fortieth of its length.
std::vector<WrittenMesh> cutFiles();
/// Counts and sizes that are not there, numbers that are none, circles, depth, bombs.
std::vector<WrittenMesh> lyingFiles();
/// Sound files of shapes on which geometry divides by zero.
std::vector<WrittenMesh> degenerateFiles();
/// Our own files with haptic values that no device could bear.
std::vector<WrittenMesh> unbearableFiles();

} // namespace tactum::test
