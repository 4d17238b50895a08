#include "tests/core/files/mesh_files.h"

#include <algorithm>
#include <bit>
#include <charconv>
#include <cstring>

#include <QByteArray>

namespace tactum {
namespace {

std::string text(double value) {
    char buffer[40];
    return {buffer, std::to_chars(buffer, buffer + sizeof buffer, value).ptr};
}

std::string text(const Vec3& p) {
    return text(p.x()) + " " + text(p.y()) + " " + text(p.z());
}

template <class T> std::string bytesOf(T value, bool bigEndian = false) {
    std::string bytes(reinterpret_cast<const char*>(&value), sizeof value);
    if (bigEndian) std::reverse(bytes.begin(), bytes.end());
    return bytes;
}

std::string floats(const std::vector<Vec3>& points, bool bigEndian = false) {
    std::string bytes;
    for (const Vec3& p : points)
        for (int i = 0; i < 3; ++i)
            bytes += bytesOf(float(p[i]), bigEndian);
    return bytes;
}

std::string indices(const TriangleSoup& soup) {
    std::string bytes;
    for (const auto& t : soup.triangles)
        for (Index corner : t)
            bytes += bytesOf(corner);
    return bytes;
}

std::string gltfJson(const TriangleSoup& soup, const std::string& nodes, const std::string& uri) {
    const std::string vertices = std::to_string(soup.positions.size()),
                      v = std::to_string(12 * soup.positions.size());
    const std::string corners = std::to_string(3 * soup.triangles.size()),
                      c = std::to_string(12 * soup.triangles.size());
    const std::string total = std::to_string(12 * (soup.positions.size() + soup.triangles.size()));
    const std::string tree = nodes.empty() ? R"("scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}])" : nodes;
    return R"({"asset":{"version":"2.0"},)" + tree +
           R"(,"meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1}]}],"accessors":[)"
           R"({"bufferView":0,"componentType":5126,"count":)" +
           vertices +
           R"(,"type":"VEC3"},)"
           R"({"bufferView":1,"componentType":5125,"count":)" +
           corners +
           R"(,"type":"SCALAR"}],"bufferViews":[)"
           R"({"buffer":0,"byteOffset":0,"byteLength":)" +
           v + R"(},{"buffer":0,"byteOffset":)" + v + R"(,"byteLength":)" + c +
           R"(}],"buffers":[{"byteLength":)" + total + uri + "}]}";
}

std::string glbOf(std::string json, const std::string& binary) {
    json.resize((json.size() + 3) / 4 * 4, ' ');
    return "glTF" + bytesOf(std::uint32_t(2)) + bytesOf(std::uint32_t(28 + json.size() + binary.size())) +
           bytesOf(std::uint32_t(json.size())) + "JSON" + json + bytesOf(std::uint32_t(binary.size())) +
           std::string("BIN\0", 4) + binary;
}

/// The channels as members to be added to the lists of a glTF file that has two accessors and one buffer.
struct AnimationParts {
    std::string accessors, views, channels, samplers, bytes;
    int accessorCount = 2;

    int add(const std::vector<double>& numbers, std::size_t elements) {
        const std::string types[] = {"SCALAR", "", "VEC3", "VEC4"};
        const std::size_t components = numbers.size() / std::max<std::size_t>(elements, 1);
        views += R"(,{"buffer":1,"byteOffset":)" + std::to_string(bytes.size()) + R"(,"byteLength":)" +
                 std::to_string(4 * numbers.size()) + "}";
        accessors += R"(,{"bufferView":)" + std::to_string(accessorCount) +
                     R"(,"componentType":5126,"count":)" + std::to_string(elements) + R"(,"type":")" +
                     types[components - 1] + "\"}";
        for (double number : numbers)
            bytes += bytesOf(float(number));
        return accessorCount++;
    }

    void add(const WrittenChannel& channel) {
        std::vector<double> values;
        for (const auto& row : channel.values)
            values.insert(values.end(), row.begin(), row.end());
        const std::string comma = channels.empty() ? "" : ",";
        const std::size_t sampler = std::size_t(accessorCount - 2) / 2;
        const int input = add(channel.times, channel.times.size()),
                  output = add(values, channel.values.size());
        samplers += comma + R"({"input":)" + std::to_string(input) + R"(,"output":)" +
                    std::to_string(output) + R"(,"interpolation":")" + channel.interpolation + "\"}";
        channels += comma + R"({"sampler":)" + std::to_string(sampler) + R"(,"target":{"node":)" +
                    std::to_string(channel.node) + R"(,"path":")" + channel.path + "\"}}";
    }
};

} // namespace

std::string said(const LoadedScene& loaded) {
    std::string all;
    for (const Finding& finding : loaded.findings)
        all += finding.sentence + '\n';
    return all;
}

std::string asObj(const TriangleSoup& soup) {
    std::string out = "# a mesh\n";
    for (const Vec3& p : soup.positions)
        out += "v " + text(p) + "\n";
    for (const auto& t : soup.triangles) {
        out += "f";
        for (Index corner : t)
            out += " " + std::to_string(corner + 1);
        out += "\n";
    }
    return out;
}

std::string asPly(const TriangleSoup& soup, PlyForm form) {
    const char* names[] = {"ascii", "binary_little_endian", "binary_big_endian"};
    std::string out = "ply\nformat " + std::string(names[int(form)]) +
                      " 1.0\ncomment a mesh\nelement vertex " + std::to_string(soup.positions.size()) +
                      "\nproperty float x\nproperty float y\nproperty float z\nelement face " +
                      std::to_string(soup.triangles.size()) +
                      "\nproperty list uchar int vertex_indices\nend_header\n";
    const bool big = form == PlyForm::BigEndian;
    if (form != PlyForm::Text)
        out += floats(soup.positions, big);
    else
        for (const Vec3& p : soup.positions)
            out += text(p) + "\n";
    for (const auto& t : soup.triangles) {
        out += form == PlyForm::Text ? "3" : "\3";
        for (Index corner : t)
            out += form == PlyForm::Text ? " " + std::to_string(corner) : bytesOf(int(corner), big);
        if (form == PlyForm::Text) out += "\n";
    }
    return out;
}

std::string asStlText(const TriangleSoup& soup) {
    std::string out = "solid thing\n";
    for (const auto& t : soup.triangles) {
        out += "facet normal 0 0 0\n outer loop\n";
        for (Index corner : t)
            out += "  vertex " + text(soup.positions[corner]) + "\n";
        out += " endloop\nendfacet\n";
    }
    return out + "endsolid thing\n";
}

std::string asStlBinary(const TriangleSoup& soup) {
    std::string out(80, ' ');
    out += bytesOf(std::uint32_t(soup.triangles.size()));
    for (const auto& t : soup.triangles)
        out += floats({Vec3::Zero(), soup.positions[t[0]], soup.positions[t[1]], soup.positions[t[2]]}) +
               std::string(2, '\0');
    return out;
}

std::string asOff(const TriangleSoup& soup) {
    std::string out = "OFF\n" + std::to_string(soup.positions.size()) + " " +
                      std::to_string(soup.triangles.size()) + " 0\n";
    for (const Vec3& p : soup.positions)
        out += text(p) + "\n";
    for (const auto& t : soup.triangles) {
        out += "3";
        for (Index corner : t)
            out += " " + std::to_string(corner);
        out += "\n";
    }
    return out;
}

std::string asGltf(const TriangleSoup& soup, const std::string& nodes) {
    const QByteArray bytes = QByteArray::fromStdString(floats(soup.positions) + indices(soup));
    return gltfJson(soup, nodes,
                    R"(,"uri":"data:application/octet-stream;base64,)" + bytes.toBase64().toStdString() +
                        "\"");
}

std::string asGlb(const TriangleSoup& soup, const std::string& nodes) {
    return glbOf(gltfJson(soup, nodes, ""), floats(soup.positions) + indices(soup));
}

std::string asAnimatedGlb(const TriangleSoup& soup, const std::string& nodes,
                          const std::vector<WrittenChannel>& channels) {
    if (channels.empty()) return asGlb(soup, nodes);
    AnimationParts parts;
    for (const WrittenChannel& channel : channels)
        parts.add(channel);
    std::string json = gltfJson(soup, nodes, "");
    const auto insertBefore = [&json](const std::string& place, const std::string& more) {
        json.insert(json.rfind(place), more);
    };
    insertBefore("],\"bufferViews\"", parts.accessors);
    insertBefore("],\"buffers\"", parts.views);
    insertBefore("]}", R"(,{"byteLength":)" + std::to_string(parts.bytes.size()) +
                           R"(,"uri":"data:application/octet-stream;base64,)" +
                           QByteArray::fromStdString(parts.bytes).toBase64().toStdString() + "\"}");
    insertBefore("}", R"(,"animations":[{"channels":[)" + parts.channels + R"(],"samplers":[)" +
                          parts.samplers + "]}]");
    return glbOf(json, floats(soup.positions) + indices(soup));
}

std::vector<WrittenMesh> inEveryFormat(const TriangleSoup& soup) {
    return {{"mesh.obj", asObj(soup)},
            {"text.ply", asPly(soup, PlyForm::Text)},
            {"little.ply", asPly(soup, PlyForm::LittleEndian)},
            {"big.ply", asPly(soup, PlyForm::BigEndian)},
            {"text.stl", asStlText(soup)},
            {"binary.stl", asStlBinary(soup)},
            {"mesh.off", asOff(soup)},
            {"mesh.gltf", asGltf(soup)},
            {"mesh.glb", asGlb(soup)}};
}

} // namespace tactum
