// glTF files as other programs read them: three.js and Blender, where they are there.
#pragma once

#include <array>
#include <string>
#include <vector>

#include <QString>
#include <QStringList>
#include <QTemporaryDir>

#include "core/base/vec.h"
#include "core/geometry/triangle_soup.h"

namespace tactum::test {

struct ReadMaterial {
    std::string name;
    Vec3 colour; ///< linear RGB, 0 to 1
    double roughness = 0, metallic = 0;
    bool bumps = false; ///< a picture of normals

    bool operator==(const ReadMaterial&) const = default;
};

struct ReadObject {
    std::string name;
    std::array<double, 16> matrix{};     ///< from the object to the world, y up, row by row
    Bounds box;                          ///< in the world; m
    std::vector<ReadMaterial> materials; ///< of its parts, in their order
};

/// What a program found in one file.
struct Reading {
    QString reader; ///< its name and version
    std::vector<ReadObject> objects;
};

struct Readings {
    QString missing; ///< one line that says what is not there and how it comes; then nothing was read
    QString fault;   ///< what the program said where it failed
    std::vector<Reading> files;
};

/// By three.js under Node. npm brings the one version of tests/app/three/package-lock.json into the folder of
/// the build, once. Thread: ui.
Readings readByThree(const QStringList& files);
/// By Blender, if it is among the programs of this machine. Thread: ui.
Readings readByBlender(const QStringList& files);

} // namespace tactum::test
