// Small files of rarer formats.
#pragma once

#include <string>
#include <vector>

#include "core/archive/zip_archive.h"
#include "core/geometry/triangle_soup.h"

namespace tactum {

/// One object with one material.
std::string as3ds(const TriangleSoup& soup, const std::string& object, const std::string& material);
/// A unit square and a triangle, with two materials, under a node that scales and mirrors. `unit`: an
/// element.
std::string asDae(const std::string& unit);
/// What a file in the text form of FBX says of its axes, as numbers of axes and signs, and of the node of the
/// square.
struct FbxWords {
    int up = 1, upSign = 1, front = 2, frontSign = 1, side = 0, sideSign = 1;
    std::string node;  ///< further properties of the node "plate"
    std::string child; ///< those of a second square below it, "lid"; empty: there is none
};
/// A unit square, its corners counter-clockwise seen from +z, 5 units along z in the text form of FBX.
std::string asFbx(double centimetres, const FbxWords& words = {});

/// The model part of a 3MF package: its resources, what is built of them, and attributes of its head.
std::string threeMfModel(const std::string& resources, const std::string& build,
                         const std::string& head = "");
/// The package around it, with more parts if there are.
std::string as3mf(const std::string& model, std::vector<ZipEntry> more = {});

} // namespace tactum
