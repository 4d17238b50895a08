#include "tests/system/hostile_files.h"

#include <QByteArray>

#include "core/archive/bundle_files.h"
#include "core/archive/zip_archive.h"
#include "core/files/gltf/gltf_file.h"
#include "core/files/gltf/gltf_surface.h"
#include "core/files/gltf/write_gltf.h"
#include "core/files/x3d/write_x3d.h"
#include "tests/core/archive/raw_zip.h"
#include "tests/core/files/rare_files.h"
#include "tests/support/random_scene.h"

using namespace std::string_literals;

namespace tactum::test {
namespace {

using Files = std::vector<WrittenMesh>;

TriangleSoup sheet() {
    TriangleSoup soup;
    soup.positions = {{0, 0, 0}, {0.125, 0, 0}, {0, 0.125, 0}, {0.125, 0.125, 0.0625}};
    soup.triangles = {{0, 1, 2}, {1, 3, 2}};
    soup.surfaceOf = {0, 0};
    return soup;
}

std::string replaced(std::string text, const std::string& part, const std::string& with) {
    return text.replace(text.find(part), part.size(), with);
}

std::string repeated(const std::string& part, int times) {
    std::string text;
    for (int i = 0; i < times; ++i)
        text += part;
    return text;
}

std::string x3d(const std::string& inside) {
    return "<X3D><Scene>" + inside + "</Scene></X3D>";
}

std::string plateOfPrinter() {
    return threeMfModel(
        "<object id='1'><mesh><vertices><vertex x='0' y='0' z='0'/><vertex x='1' y='0' z='0'/>"
        "<vertex x='0' y='1' z='0'/></vertices><triangles><triangle v1='0' v2='1' v3='2'/>"
        "</triangles></mesh></object>",
        "<item objectid='1'/>");
}

std::string bundle(const std::string& glb) {
    return packBundle(std::vector<ZipEntry>{{bundle_name::kScene, glb}});
}

void addText(Files& files) {
    const std::string points = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
    for (const char* number :
         {"nan", "inf", "-inf", "1e38", "1e308", "1e999", "-1e7", "0x10", "1e-320", ""}) {
        files.push_back({"number.obj", "v 0 0 0\nv 1 0 0\nv 0 "s + number + " 0\nf 1 2 3\n"});
        files.push_back({"number.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 "s + number + " 0\n3 0 1 2\n"});
        files.push_back({"number.stl", replaced(asStlText(sheet()), "0.0625", number)});
        files.push_back({"number.ply", replaced(asPly(sheet(), PlyForm::Text), "0.0625", number)});
        files.push_back(
            {"number.x3d", x3d("<Shape><IndexedTriangleSet index='0 1 2'><Coordinate point='0 0 0 1 0 0 0 "s +
                               number + " 0'/></IndexedTriangleSet></Shape>")});
        files.push_back(
            {"matrix.x3d", x3d("<Transform scale='1 "s + number + " 1'><Shape><Box/></Shape></Transform>")});
        files.push_back({"number.dae", replaced(asDae(""), "1 1 0", "1 "s + number + " 0")});
    }
    for (const char* index : {"0", "-4", "4", "4294967297", "99999999999999999999", "1/9", "1//9", "x"})
        files.push_back({"index.obj", points + "f 1 2 " + index + "\n"});
    files.push_back({"corners.obj", points + "f" + repeated(" 1 2 3", 30'000) + "\n"});
    files.push_back({"line.obj", points + "f 1 2 3\n" + std::string(1'000'000, 'x') + "\n"});
    files.push_back({"materials.obj", points + repeated("usemtl m\nf 1 2 3\nusemtl n\nf 1 2 3\n", 20'000)});
    files.push_back(
        {"library.obj",
         "mtllib ../../../../etc/passwd\nmtllib /etc/passwd\nmtllib library.obj\n" + points + "f 1 2 3\n"});
    for (const char* count : {"-1", "4294967295", "99999999999", "18446744073709551615", "1e9"}) {
        files.push_back({"count.off", "OFF\n"s + count + " 1 0\n0 0 0\n"});
        files.push_back({"faces.off", "OFF\n3 "s + count + " 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"});
        files.push_back({"corners.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n"s + count + " 0 1 2\n"});
        for (const PlyForm form : {PlyForm::Text, PlyForm::LittleEndian, PlyForm::BigEndian}) {
            files.push_back({"count.ply", replaced(asPly(sheet(), form), "vertex 4", "vertex "s + count)});
            files.push_back({"faces.ply", replaced(asPly(sheet(), form), "face 2", "face "s + count)});
        }
    }
    files.push_back(
        {"properties.ply", replaced(asPly(sheet(), PlyForm::LittleEndian), "property float z",
                                    "property float z\n" + repeated("property double w\n", 9'999))});
}

void addBinary(Files& files) {
    std::string stl = asStlBinary(sheet());
    for (const char* count : {"\xff\xff\xff\xff", "\x03\0\0\0", "\0\0\0\0"})
        files.push_back({"count.stl", std::string(stl).replace(80, 4, count, 4)});
    for (const char* number : {"\0\0\xc0\x7f", "\0\0\x80\x7f", "\xff\xff\x7f\x7f"})
        files.push_back({"number.stl", std::string(stl).replace(96, 4, number, 4)});
    const std::string glb = asGlb(sheet());
    for (const std::size_t at : {4, 8, 12, 16})
        for (const char* length : {"\xff\xff\xff\xff", "\0\0\0\0", "\xfc\xff\xff\x7f"})
            files.push_back({"length.glb", std::string(glb).replace(at, 4, length, 4)});
    const std::string old = as3ds(sheet(), "lid", "red");
    for (std::size_t at = 2; at + 4 < old.size(); at += 11)
        files.push_back({"length.3ds", std::string(old).replace(at, 4, "\xff\xff\xff\x7f", 4)});
}

void addGltf(Files& files) {
    const std::string gltf = asGltf(sheet());
    const auto instead = [&](const std::string& part, const std::string& with) {
        files.push_back({"lie.gltf", replaced(gltf, part, with)});
    };
    for (const std::string number :
         {"-1", "5", "4294967295", "1e308", "18446744073709551615", "null", "\"4\""}) {
        instead("\"count\":4", "\"count\":" + number);
        instead("\"byteLength\":48}", "\"byteLength\":" + number + "}");
        instead("\"byteOffset\":48", "\"byteOffset\":" + number);
        instead("\"bufferView\":1", "\"bufferView\":" + number);
        instead("\"mesh\":0", "\"mesh\":" + number);
        instead("\"POSITION\":0", "\"POSITION\":" + number);
        instead("\"nodes\":[0]", "\"nodes\":[" + number + "]");
        instead("\"componentType\":5126", "\"componentType\":" + number);
    }
    const std::string mesh = R"("scenes":[{"nodes":[0]}],"nodes":[)";
    files.push_back({"ring.gltf", asGltf(sheet(), mesh + R"({"mesh":0,"children":[1]},{"children":[0]}])")});
    files.push_back({"own-child.glb", asGlb(sheet(), mesh + R"({"mesh":0,"children":[0]}])")});
    std::string chain = mesh, twice = mesh;
    for (int i = 0; i < 1000; ++i)
        chain += "{\"mesh\":0,\"children\":[" + std::to_string(i + 1) + "]},";
    for (int i = 0; i < 40; ++i) { // each has the next one twice: 2^40 meshes
        const std::string next = std::to_string(i + 1);
        twice += "{\"mesh\":0,\"children\":[" + next + "," + next + "]},";
    }
    files.push_back({"deep.gltf", asGltf(sheet(), chain + "{\"mesh\":0}]")});
    files.push_back({"twice.gltf", asGltf(sheet(), twice + "{\"mesh\":0}]")});
    files.push_back({"nested.gltf", repeated("[", 100'000)});
    files.push_back({"nested.glb", asGlb(sheet(), R"("extras":)" + repeated("[", 5000) + repeated("]", 5000) +
                                                      "," + mesh + "{\"mesh\":0}]")});
    for (const std::string pose :
         {R"("scale":[0,0,0])", R"("scale":[1e38,1,1])", R"("rotation":[0,0,0,0])",
          R"("translation":[1e308,0,0])", R"("matrix":[0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0])",
          R"("matrix":[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,0])", R"("scale":[1e-30,1e-30,1e-30])"})
        files.push_back({"pose.gltf", asGltf(sheet(), mesh + "{\"mesh\":0," + pose + "}]")});
    for (const std::string uri :
         {"file:///etc/passwd", "/etc/passwd", "../../../../etc/passwd", "http://localhost/x",
          "%2e%2e/%2e%2e/etc/passwd", "data:;base64,", "lie.gltf"})
        files.push_back(
            {"uri.gltf",
             replaced(gltf, gltf.substr(gltf.find("data:"), gltf.rfind('"') - gltf.find("data:")), uri)});
}

void addXml(Files& files) {
    const std::string box = "<Shape><Box/></Shape>";
    files.push_back({"deep.x3d", x3d(repeated("<Group>", 20'000) + box + repeated("</Group>", 20'000))});
    files.push_back({"ring.x3d", x3d("<Group DEF='a'><Group USE='a'/>" + box + "</Group>")});
    std::string doubled = "<Group DEF='g0'>" + box + "</Group>";
    for (int i = 1; i < 40; ++i) {
        const std::string before = "<Group USE='g" + std::to_string(i - 1) + "'/>";
        doubled += "<Group DEF='g" + std::to_string(i) + "'>" + before + before + "</Group>";
    }
    files.push_back({"doubled.x3d", x3d(doubled)});
    files.push_back({"entities.x3d", "<!DOCTYPE X3D [<!ENTITY a 'aaaaaaaaaa'><!ENTITY b '&a;&a;&a;&a;'>"
                                     "<!ENTITY x SYSTEM 'file:///etc/passwd'>]>" +
                                         x3d("&b;&x;" + box)});
    files.push_back({"index.x3d", x3d("<Shape><IndexedFaceSet coordIndex='0 1 99999999 -1 -7 2'><Coordinate "
                                      "point='0 0 0 1 0 0 0 1 0'/>"
                                      "</IndexedFaceSet></Shape>")});
    files.push_back(
        {"grid.x3d",
         x3d("<Shape><ElevationGrid xDimension='100000' zDimension='100000' height='0'/></Shape>")});
    std::string copies = "<node id='n0'/>"; // each of the one before twice: 2^40 of the first
    for (int i = 1; i <= 40; ++i) {
        const std::string before = "<instance_node url='#n" + std::to_string(i - 1) + "'/>";
        copies += "<node id='n" + std::to_string(i) + "'>" + before + before + "</node>";
    }
    files.push_back({"copies.dae", replaced(asDae(""), "<node id=", copies + "<node id=")});
    files.push_back({"deep.dae", replaced(asDae(""), "<node id=", repeated("<node>", 5000) + "<node id=")});
    files.push_back({"count.dae", replaced(asDae(""), "count='15'", "count='4000000000'")});
    files.push_back({"count.fbx", replaced(asFbx(1), "*12", "*4000000000")});
    files.push_back({"ring.fbx", replaced(asFbx(1), "C: \"OO\",2000,0", "C: \"OO\",2000,2000")});
}

/// The model is packed as well as it can be; the rest as as3mf() has it.
std::string packed3mf(const std::string& model) {
    constexpr int kHead = 6, kTail = 4; // of what zlib and Qt put around
    const QByteArray packed =
        qCompress(reinterpret_cast<const uchar*>(model.data()), qsizetype(model.size()), 9);
    const std::string relations = fileInZip(as3mf(""), "_rels/.rels", 1 << 20).value();
    return rawZip({{.name = "_rels/.rels", .packed = relations},
                   {.name = "3D/3dmodel.model",
                    .packed = packed.mid(kHead, packed.size() - kHead - kTail).toStdString(),
                    .method = 8,
                    .size = std::uint32_t(model.size())}});
}

void addZips(Files& files) {
    const std::string glb = asGlb(sheet());
    for (const char* name : {"../scene.glb", "/scene.glb", "C:/scene.glb", "..\\scene.glb", "scene.glb"})
        files.push_back({"slip.zip", rawZip({{.name = name, .packed = glb}})}); // the last without a manifest
    files.push_back(
        {"link.zip", rawZip({{.name = "scene.glb", .packed = "/etc/passwd", .attributes = 0120777u << 16}})});
    files.push_back(
        {"twice.zip", rawZip({{.name = "scene.glb", .packed = glb}, {.name = "scene.glb", .packed = "x"}})});
    const std::uint32_t size = 258 * 1'000'000 + 1;
    for (const std::uint32_t said : {size, 1000u})
        files.push_back(
            {"bomb.zip",
             rawZip({{.name = "scene.glb", .packed = deflatedZeros(size), .method = 8, .size = said}})});
    files.push_back(
        {"bomb.3mf",
         rawZip({{.name = "_rels/.rels", .packed = deflatedZeros(size), .method = 8, .size = size}})});
    for (const std::string& much : {std::string(200'000'000, ' '), repeated("<a/>", 5'000'000)})
        files.push_back({"much.3mf", packed3mf(replaced(plateOfPrinter(), "<build>", much + "<build>"))});
    const std::string itself = "<components><component objectid='1'/></components>";
    files.push_back(
        {"ring.3mf", as3mf(threeMfModel("<object id='1'>" + itself + "</object>", "<item objectid='1'/>"))});
    files.push_back({"number.3mf", as3mf(replaced(plateOfPrinter(), "x='1'", "x='1e999'"))});
    files.push_back({"index.3mf", as3mf(replaced(plateOfPrinter(), "v3='2'", "v3='18446744073709551615'"))});
    files.push_back({"other.zip", bundle("no glb at all")});
    files.push_back({"nested.zip", bundle(bundle(glb))});
}

std::string ownFile(const Material& material, double radius, const std::vector<TextureLayer>& layers) {
    Scene scene;
    scene.proxyRadius = radius;
    SceneObject object;
    object.geometry = std::make_shared<const TriangleSoup>(sheet());
    object.surfaces.resize(1);
    object.surfaces[0].material = material;
    object.surfaces[0].layers = layers;
    scene.add(std::move(object));
    return glbOf(scene).value();
}

} // namespace

Files soundFiles() {
    Files files = inEveryFormat(sheet());
    const Scene scene = SceneDice(5).scene();
    const std::string own = glbOf(scene).value();
    files.insert(files.end(), {{"own.glb", own},
                               {"own.x3d", x3dOf(scene).scene},
                               {"own.zip", bundle(own)},
                               {"a.3ds", as3ds(sheet(), "lid", "red")},
                               {"a.dae", asDae("")},
                               {"a.3mf", as3mf(plateOfPrinter())},
                               {"a.fbx", asFbx(1)}});
    return files;
}

Files cutFiles() {
    Files files;
    for (const WrittenMesh& sound : soundFiles())
        for (std::size_t part = 1; part < 40; ++part)
            files.push_back({sound.name, sound.content.substr(0, sound.content.size() * part / 40)});
    return files;
}

Files lyingFiles() {
    Files files;
    addText(files);
    addBinary(files);
    addGltf(files);
    addXml(files);
    addZips(files);
    return files;
}

Files degenerateFiles() {
    Files files;
    const auto add = [&](std::vector<Vec3> positions, std::vector<std::array<Index, 3>> triangles) {
        TriangleSoup soup;
        soup.positions = std::move(positions);
        soup.triangles = std::move(triangles);
        soup.surfaceOf.assign(soup.triangles.size(), 0);
        const Files written = inEveryFormat(soup);
        files.insert(files.end(), written.begin(), written.end());
    };
    const std::vector<std::array<Index, 3>> one{{0, 1, 2}};
    add({{0, 0, 0}, {0, 0, 0}, {0, 0, 0}}, one);
    add({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, one);
    add({{0, 0, 0}, {1, 0, 0}, {0.5, 1e-30, 0}}, one);
    add({{-1e6, -1e6, 0}, {1e6, -1e6, 0}, {0, 1e6, 0}}, one);
    add({{1e6, 1e6, 1e6}, {1e6 - 1, 1e6, 1e6}, {1e6, 1e6 - 1, 1e6}}, one);
    add({{0, 0, 0}, {1e-38, 0, 0}, {0, 1e-38, 0}}, one);
    add({{0, 0, 0}, {1e6, 0, 0}, {0, 1e-20, 0}, {0, 0, 1e-20}}, {{0, 1, 2}, {0, 1, 3}, {1, 1, 1}, {0, 3, 3}});
    add({{0, 0, 0}, {0.1, 0, 0}, {0, 0.1, 0}}, std::vector<std::array<Index, 3>>(5000, {0, 1, 2}));
    add({{0, 0, 0}, {0.1, 0, 0}, {0, 0.1, 0}, {0, 0, 0.1}},
        {{0, 1, 2}, {0, 2, 1}, {0, 1, 3}, {0, 1, 2}, {1, 0, 3}});
    return files;
}

Files unbearableFiles() {
    Files files;
    const double values[] = {-1,     0,      1e9, 1e300,
                             -1e300, 1e-300, NAN, INFINITY}; // the last two are null in JSON
    for (const double value : values) {
        for (const MaterialField& field : kMaterialFields) {
            Material material;
            material.*field.value = value;
            files.push_back({"material.glb", ownFile(material, 1e-3, {})});
        }
        files.push_back({"radius.glb", ownFile({}, value, {})});
        for (std::size_t target = 0; target < kTextureTargets.size(); ++target) {
            TextureLayer layer;
            layer.target = TextureTarget(target);
            layer.strength = value;
            files.push_back({"strength.glb", ownFile({}, 1e-3, {layer})});
            layer.strength = 1; // a metre, where it is a height
            layer.opacity = value;
            for (const PatternField& field : kPatternFields) {
                layer.pattern = {};
                layer.pattern.*field.value = value;
                files.push_back({"pattern.glb", ownFile({}, 1e-3, {layer})});
            }
        }
    }
    const Source source = Source::ofBytes("own.glb", ownFile({}, 1e-3, {}));
    GltfFile own = openGltf(source);
    own.json["materials"][0]["extensions"][kExtension]["layers"] = Json(100'000, Json::object());
    files.push_back({"layers.glb", packGlb(own.json, own.binary)});
    return files;
}

} // namespace tactum::test
