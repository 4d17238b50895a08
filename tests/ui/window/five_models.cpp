#include "tests/ui/window/five_models.h"

#include <array>

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include "core/base/vec.h"
#include "core/geometry/triangle_soup.h"
#include "tests/ui/window/obj_box.h"
#include "tests/ui/window/window_fixture.h"

namespace tactum::test {

namespace {

Vec3 cornerOf(const Bounds& box, unsigned i) {
    return {(i & 1 ? box.high : box.low).x(), (i & 2 ? box.high : box.low).y(),
            (i & 4 ? box.high : box.low).z()};
}

/// The corners of each side, counter-clockwise from outside, and where it faces.
struct Side {
    std::array<unsigned, 4> corners;
    Vec3 normal;
};
const std::array<Side, 6> kSides{{{{0, 4, 6, 2}, {-1, 0, 0}},
                                  {{1, 3, 7, 5}, {1, 0, 0}},
                                  {{0, 1, 5, 4}, {0, -1, 0}},
                                  {{2, 6, 7, 3}, {0, 1, 0}},
                                  {{0, 2, 3, 1}, {0, 0, -1}},
                                  {{4, 5, 7, 6}, {0, 0, 1}}}};

/// Lower and upper half of a box that stands on the origin.
std::array<Bounds, 2> halvesOf(const Vec3& size) {
    const double middle = size.y() / 2;
    return {{{{0, 0, 0}, {size.x(), middle, size.z()}}, {{0, middle, 0}, size}}};
}

QByteArray numbersOf(const Vec3& v, double unit = 1) {
    return QStringLiteral("%1 %2 %3").arg(v.x() / unit).arg(v.y() / unit).arg(v.z() / unit).toLatin1();
}

QString writeObj(const QTemporaryDir& folder) {
    writeFile(folder, QStringLiteral("cup.mtl"),
              "newmtl cup low\nKd 0.8 0.1 0.05\nnewmtl cup high\nKd 0.9 0.75 0.4\n");
    const auto halves = halvesOf({0.05, 0.04, 0.03});
    int next = 1;
    QByteArray text = "mtllib cup.mtl\no cup\nusemtl cup low\n";
    text += objBox(nullptr, halves[0].low, halves[0].high, next) + "usemtl cup high\n";
    text += objBox(nullptr, halves[1].low, halves[1].high, next);
    return writeFile(folder, QStringLiteral("cup.obj"), text);
}

QString writeStl(const QTemporaryDir& folder) {
    constexpr double kMillimetre = 1e-3; // as STL usually has it
    QByteArray text = "solid pot\n";
    const Bounds box{{0, 0, 0}, {0.03, 0.06, 0.045}};
    for (const Side& side : kSides)
        for (const auto& [b, c] : {std::pair(1, 2), std::pair(2, 3)}) {
            text += "facet normal " + numbersOf(side.normal) + "\nouter loop\n";
            for (const int corner : {0, b, c})
                text += "vertex " + numbersOf(cornerOf(box, side.corners[std::size_t(corner)]), kMillimetre) +
                        "\n";
            text += "endloop\nendfacet\n";
        }
    return writeFile(folder, QStringLiteral("pot.stl"), text + "endsolid pot\n");
}

QString writePly(const QTemporaryDir& folder) {
    const Bounds box{{0, 0, 0}, {0.06, 0.025, 0.04}};
    QByteArray text =
        "ply\nformat ascii 1.0\nelement vertex 8\nproperty float x\nproperty float y\nproperty float "
        "z\nelement face 6\nproperty list uchar int vertex_indices\nend_header\n";
    for (unsigned i = 0; i < 8; ++i)
        text += numbersOf(cornerOf(box, i)) + "\n";
    for (const Side& side : kSides)
        text += QStringLiteral("4 %1 %2 %3 %4\n")
                    .arg(side.corners[0])
                    .arg(side.corners[1])
                    .arg(side.corners[2])
                    .arg(side.corners[3])
                    .toLatin1();
    return writeFile(folder, QStringLiteral("jar.ply"), text);
}

QString writeDae(const QTemporaryDir& folder) {
    QByteArray effects, materials, bound, sides, places;
    const auto halves = halvesOf({0.045, 0.05, 0.035});
    const char* colours[] = {"0.1 0.5 0.2 1", "0.15 0.2 0.7 1"};
    for (unsigned half = 0; half < 2; ++half) {
        const QByteArray name = half ? "bowl_high" : "bowl_low";
        effects += "<effect id='" + name +
                   "-fx'><profile_COMMON><technique sid='c'><lambert><diffuse><color>" + colours[half] +
                   "</color></diffuse></lambert></technique></profile_COMMON></effect>";
        materials += "<material id='" + name + "' name='" + name + "'><instance_effect url='#" + name +
                     "-fx'/></material>";
        bound += "<instance_material symbol='" + name + "' target='#" + name + "'/>";
        sides +=
            "<polylist material='" + name +
            "' count='6'><input semantic='VERTEX' source='#v' offset='0'/><vcount>4 4 4 4 4 4</vcount><p>";
        for (const Side& side : kSides)
            for (const unsigned corner : side.corners)
                sides += QByteArray::number(8 * half + corner) + " ";
        sides += "</p></polylist>";
        for (unsigned i = 0; i < 8; ++i)
            places += numbersOf(cornerOf(halves[half], i)) + " ";
    }
    return writeFile(
        folder, QStringLiteral("bowl.dae"),
        "<?xml version='1.0'?><COLLADA xmlns='http://www.collada.org/2005/11/COLLADASchema' version='1.4.1'>"
        "<asset><unit name='meter' meter='1'/><up_axis>Y_UP</up_axis></asset><library_effects>" +
            effects + "</library_effects><library_materials>" + materials +
            "</library_materials><library_geometries><geometry id='g' name='g'><mesh><source id='p'>"
            "<float_array id='pa' count='48'>" +
            places +
            "</float_array><technique_common><accessor source='#pa' count='16' stride='3'><param name='X' "
            "type='float'/><param name='Y' type='float'/><param name='Z' "
            "type='float'/></accessor></technique_common>"
            "</source><vertices id='v'><input semantic='POSITION' source='#p'/></vertices>" +
            sides +
            "</mesh></geometry></library_geometries><library_visual_scenes><visual_scene id='s'><node "
            "id='bowl' "
            "name='bowl'><instance_geometry url='#g'><bind_material><technique_common>" +
            bound +
            "</technique_common></bind_material></instance_geometry></node></visual_scene></"
            "library_visual_scenes>"
            "<scene><instance_visual_scene url='#s'/></scene></COLLADA>");
}

QJsonObject jugMaterial(const char* name, const QJsonArray& colour, const double (&look)[2]) {
    return {{"name", name},
            {"pbrMetallicRoughness", QJsonObject{{"baseColorFactor", colour},
                                                 {"roughnessFactor", look[0]},
                                                 {"metallicFactor", look[1]}}}};
}

/// Of each side its four corners, with normals and texture coordinates.
QString writeGltf(const QTemporaryDir& folder) {
    QByteArray floats, indices;
    QJsonArray primitives, accessors;
    const auto append = [](QByteArray& to, auto value) {
        to.append(reinterpret_cast<const char*>(&value), sizeof value);
    };
    const Vec3 size(0.035, 0.055, 0.045);
    const auto halves = halvesOf(size);
    constexpr int kCorners = 24, kAttributes = 2 * 6 * 4 * 8 * 4; // bytes of both halves
    for (int half = 0; half < 2; ++half) {
        const Bounds& box = halves[std::size_t(half)];
        for (std::uint16_t side = 0; side < 6; ++side) {
            const auto& [corners, normal] = kSides[side];
            for (std::size_t i = 0; i < 4; ++i) {
                const Vec3 p = cornerOf(box, corners[i]);
                // Each side has a place of its own in the pictures.
                const double u = (side % 3 + (i == 1 || i == 2 ? 0.9 : 0.0)) / 3,
                             v = (side / 3 + (i > 1 ? 0.9 : 0.0)) / 2;
                for (const double x : {p.x(), p.y(), p.z(), normal.x(), normal.y(), normal.z(), u, v})
                    append(floats, float(x));
            }
            for (const int i : {0, 1, 2, 0, 2, 3})
                append(indices, std::uint16_t(4 * side + i));
        }
        const auto vectors = [&](int floatsBefore, const char* type) {
            return QJsonObject{{"bufferView", 0},
                               {"byteOffset", half * kAttributes / 2 + 4 * floatsBefore},
                               {"componentType", 5126},
                               {"count", kCorners},
                               {"type", type}};
        };
        QJsonObject places = vectors(0, "VEC3");
        places["min"] = QJsonArray{box.low.x(), box.low.y(), box.low.z()};
        places["max"] = QJsonArray{box.high.x(), box.high.y(), box.high.z()};
        accessors << places << vectors(3, "VEC3") << vectors(6, "VEC2")
                  << QJsonObject{{"bufferView", 1},
                                 {"byteOffset", half * 72},
                                 {"componentType", 5123},
                                 {"count", 36},
                                 {"type", "SCALAR"}};
        primitives << QJsonObject{
            {"attributes",
             QJsonObject{{"POSITION", 4 * half}, {"NORMAL", 4 * half + 1}, {"TEXCOORD_0", 4 * half + 2}}},
            {"indices", 4 * half + 3},
            {"material", half}};
    }
    const QByteArray data = (floats + indices).toBase64();
    const QJsonObject root{
        {"asset", QJsonObject{{"version", "2.0"}}},
        {"scene", 0},
        {"scenes", QJsonArray{QJsonObject{{"nodes", QJsonArray{0}}}}},
        {"nodes",
         QJsonArray{QJsonObject{{"name", "jug"}, {"mesh", 0}, {"translation", QJsonArray{0.1, 0, 0}}}}},
        {"meshes", QJsonArray{QJsonObject{{"name", "jug"}, {"primitives", primitives}}}},
        {"materials", QJsonArray{jugMaterial("jug low", {0.2, 0.3, 0.4, 1}, kJugLow),
                                 jugMaterial("jug high", {0.6, 0.5, 0.05, 1}, kJugHigh)}},
        {"accessors", accessors},
        {"bufferViews",
         QJsonArray{
             QJsonObject{{"buffer", 0}, {"byteLength", kAttributes}, {"byteStride", 32}},
             QJsonObject{{"buffer", 0}, {"byteOffset", kAttributes}, {"byteLength", int(indices.size())}}}},
        {"buffers",
         QJsonArray{QJsonObject{{"byteLength", int(floats.size() + indices.size())},
                                {"uri", QString("data:application/octet-stream;base64," + data)}}}}};
    return writeFile(folder, QStringLiteral("jug.gltf"), QJsonDocument(root).toJson());
}

} // namespace

void writeFiveModels(const QTemporaryDir& folder) {
    for (const auto write : {writeObj, writeGltf, writeDae, writeStl, writePly})
        if (write(folder).isEmpty()) qFatal("a model cannot be written");
}

} // namespace tactum::test
