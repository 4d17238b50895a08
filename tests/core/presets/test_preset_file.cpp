// Presets: the same bytes again, what they do to a surface, what comes with the program, and hostile files.
#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include <algorithm>

#include "core/files/gltf/gltf_surface.h"
#include "core/presets/base64.h"
#include "core/presets/preset_file.h"
#include "core/scene/surface_colours.h"
#include "tests/core/files/json_text.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"

namespace test_preset_file {

using namespace tactum;

namespace {

constexpr std::size_t kStatic = 2, kDynamic = 3; // of kMaterialFields

std::string contentOf(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll().toStdString() : std::string();
}

Result<LoadedPreset> parsed(const std::string& text) {
    return parsePreset(text, "a.tactum-preset");
}

std::string with(const std::string& feel, const std::string& more = {}) {
    return R"({"tactumPreset":"1.0","name":"n","feel":)" + feel + more + "}";
}

/// A picture of 8 bits, and one of 16.
std::shared_ptr<const TextureImage> picture(int width, int height, std::uint16_t step) {
    std::vector<std::uint16_t> texels;
    for (int i = 0; i < width * height; ++i)
        texels.push_back(std::uint16_t(i * step));
    return std::make_shared<const TextureImage>(width, height, texels, "bark");
}

/// Every kind of layer that can travel.
Surface richSurface() {
    Surface surface;
    surface.name = "bark";
    surface.material = {650, 0.5, 0.625, 0.375, 2.5};
    surface.shading = {true, NormalSource::Computed, 0.5};
    surface.layers.resize(3);
    surface.layers[0].name = "picture";
    surface.layers[0].pattern.source = TextureSource::Image;
    surface.layers[0].pattern.image = picture(3, 2, 257);
    surface.layers[0].mask.emplace().source = TextureSource::Image;
    surface.layers[0].mask->image = picture(5, 4, 1001);
    surface.layers[1].name = "grain \"fine\"";
    surface.layers[1].pattern.frame.translation = {0.1, -0.2, 1e-7};
    surface.layers[1].target = TextureTarget::Viscosity;
    surface.layers[1].strength = -0.5;
    surface.layers[2].ownPlane = true;
    surface.layers[2].pattern.source = TextureSource::Weave;
    return surface;
}

} // namespace

class TestPresetFile : public QObject {
    Q_OBJECT

private slots:
    void everythingComesBack();
    void whatBelongsToAMeshStaysBehind();
    void unknownMembersStay();
    void onlyWhatIsSetIsChanged();
    void aMaterialBringsItsColour();
    void frictionStaysInOrder();
    void bytesAreTextAndBack();
    void namesBecomeFileNames();
    void shippedPresetsAreWhole_data();
    void shippedPresetsAreWhole();
    void badFilesAreOneLine_data();
    void badFilesAreOneLine();
    void cutFilesAreOneLine();
    void hugeClaimsAreRefused();
};

void TestPresetFile::everythingComesBack() {
    const Surface surface = richSurface();
    const PresetSource source{"measured by <us> & \"others\"", "https://example.org/a?b=c", true};
    LoadedPreset made = presetOf(surface, "Bark, wet", source);
    QVERIFY(made.notes.empty());
    made.preset.tags = {"tree", "rough"};
    made.preset.category = "Wood";
    const std::string text = presetText(made.preset);
    const auto read = parsed(text);
    VERIFY_RESULT(read);
    QCOMPARE(presetText(read->preset), text);
    QVERIFY(sourceOf(read->preset, "staticFriction") == source);
    Surface given = applied({}, read->preset);
    QVERIFY(given.material == surface.material);
    QVERIFY(given.shading == surface.shading);
    QCOMPARE(given.layers.size(), surface.layers.size());
    for (std::size_t i = 0; i < given.layers.size(); ++i) {
        TextureLayer &now = given.layers[i], before = surface.layers[i];
        const auto sameTexels = [](const auto& a, const auto& b) {
            if (!a || !b) return a == b;
            for (int y = 0; y < a->height(); ++y)
                if (!std::equal(a->row(y), a->row(y) + a->width(), b->row(y))) return false;
            return a->width() == b->width() && a->height() == b->height() && a->name() == b->name();
        };
        QVERIFY(sameTexels(now.pattern.image, before.pattern.image));
        if (now.mask) QVERIFY(sameTexels(now.mask->image, before.mask->image));
        now.pattern.image = before.pattern.image; // they are compared by their address
        if (now.mask) now.mask->image = before.mask->image;
        QVERIFY(now == before);
    }
}

void TestPresetFile::whatBelongsToAMeshStaysBehind() {
    Surface surface = richSurface();
    surface.layers[0].mask->source = TextureSource::Painted;
    surface.layers[1].pattern.source = TextureSource::Painted;
    surface.layers[2].pattern.source = TextureSource::Image;
    surface.layers[2].pattern.image = picture(kLargestPresetPicture + 1, 1, 1);
    const LoadedPreset made = presetOf(surface, "n", {"us", {}, false});
    QCOMPARE(made.notes.size(), std::size_t(3));
    QCOMPARE(made.preset.layers->size(), std::size_t(1));
    QVERIFY(!made.preset.layers->front().mask);
    VERIFY_RESULT(parsed(presetText(made.preset)));
}

void TestPresetFile::unknownMembersStay() {
    const auto read =
        parsed(with(R"({"staticFriction":0.5,"smell":"sweet",
        "layers":[{"name":"a","later":[1,2]}]})",
                    R"(,"sources":{"staticFriction":{"words":"w","page":7}},"author":{"is":"x"})"));
    VERIFY_RESULT(read);
    Preset renamed = read->preset;
    renamed.name = "other";
    Json json = Json::parse(presetText(renamed));
    QCOMPARE_EQ(json["name"], "other");
    QVERIFY(json.contains("author"));
    QCOMPARE_EQ(json["author"], (Json{{"is", "x"}}));
    QVERIFY(json["feel"].contains("smell"));
    QCOMPARE_EQ(json["feel"]["smell"], "sweet");
    QVERIFY(json["feel"]["layers"][0].contains("later"));
    QVERIFY(json["sources"]["staticFriction"].contains("page"));
}

void TestPresetFile::onlyWhatIsSetIsChanged() {
    const auto read = parsed(with(R"({"staticFriction":0.5,"dynamicFriction":0.25})"));
    VERIFY_RESULT(read);
    const Surface before = richSurface();
    Surface after = applied(before, read->preset);
    QCOMPARE(after.material.staticFriction, 0.5);
    QCOMPARE(after.material.dynamicFriction, 0.25);
    after.material.staticFriction = before.material.staticFriction;
    after.material.dynamicFriction = before.material.dynamicFriction;
    QVERIFY(after == before);
    QVERIFY(!read->preset.layers);
    QVERIFY(!read->preset.shading);
}

void TestPresetFile::aMaterialBringsItsColour() {
    const auto colourAfter = [](const char* feel, Surface surface) {
        const auto read = parsed(with(feel, R"(,"colour":[0.4,0.12,0.06])"));
        return applied(std::move(surface), read.value().preset).colour;
    };
    constexpr const char *kBrick = R"({"staticFriction":0.6})", *kStiff = R"({"stiffness":900})";
    const Eigen::Vector3f brick(0.4F, 0.12F, 0.06F);
    Surface other, chosen;
    other.colour = colourApartFrom(std::vector<Surface>(1)); // as the import gives it
    chosen.colour = {0.1F, 0.2F, 0.3F};
    QVERIFY(colourAfter(kBrick, {}) == brick);
    QVERIFY(colourAfter(kBrick, other) == brick);
    QVERIFY(colourAfter(kBrick, chosen) == brick); // a body of brick looks like brick
    QVERIFY(colourAfter(kStiff, chosen) == chosen.colour);
    QVERIFY(colourAfter(kStiff, {}) == Surface{}.colour); // of no material
    const auto plain = parsed(with(kBrick));
    VERIFY_RESULT(plain);
    QVERIFY(!plain->preset.colour);
    QVERIFY(applied({}, plain->preset).colour == Surface{}.colour);
    COMPARE_LACKS(presetText(plain->preset), "colour");
}

void TestPresetFile::frictionStaysInOrder() {
    Surface surface;
    surface.material.staticFriction = surface.material.dynamicFriction = 0.5;
    const auto low = parsed(with(R"({"staticFriction":0.1})")),
               high = parsed(with(R"({"dynamicFriction":0.9})"));
    VERIFY_RESULT(low);
    VERIFY_RESULT(high);
    QCOMPARE(applied(surface, low->preset).material.dynamicFriction, 0.1);
    QCOMPARE(applied(surface, high->preset).material.staticFriction, 0.9);
}

void TestPresetFile::bytesAreTextAndBack() {
    // The examples of RFC 4648, section 10.
    const std::pair<const char*, const char*> known[] = {{"", ""},
                                                         {"f", "Zg=="},
                                                         {"fo", "Zm8="},
                                                         {"foo", "Zm9v"},
                                                         {"foob", "Zm9vYg=="},
                                                         {"fooba", "Zm9vYmE="},
                                                         {"foobar", "Zm9vYmFy"}};
    for (const auto& [bytes, text] : known) {
        QCOMPARE(base64Of(bytes), std::string(text));
        QCOMPARE(fromBase64(text).value_or("?"), std::string(bytes));
    }
    for (const char* wrong : {"Z", "Zg=", "Zg", "Z===", "====", "Zm9v ", "Zm=v", "Zh=="})
        QVERIFY2(!fromBase64(wrong), wrong);
    std::string all;
    for (int i = 0; i < 1000; ++i)
        all += char(i * 37);
    QCOMPARE(fromBase64(base64Of(all)).value_or("?"), all);
}

void TestPresetFile::namesBecomeFileNames() {
    QCOMPARE(presetFileName("Steel on steel, dry"), std::string("steel-on-steel-dry"));
    QCOMPARE(presetFileName("../../etc/passwd"), std::string("etc-passwd"));
    QCOMPARE(presetFileName("\xE6\x9C\xA8"), std::string("preset"));
    QCOMPARE_LT(presetFileName(std::string(500, 'a')).size(), 100);
}

void TestPresetFile::shippedPresetsAreWhole_data() {
    QTest::addColumn<QString>("file");
    const QDir folder(QStringLiteral(TACTUM_PRESETS));
    const QStringList files = folder.entryList({QStringLiteral("*.tactum-preset")}, QDir::Files);
    QCOMPARE_GE(files.size(), 20);
    for (const QString& file : files)
        QTest::newRow(qPrintable(file)) << folder.filePath(file);
}

void TestPresetFile::shippedPresetsAreWhole() {
    QFETCH(QString, file);
    const std::string text = contentOf(file);
    const auto read = parsePreset(text, file.toStdString());
    VERIFY_RESULT(read);
    QVERIFY(read->notes.empty());
    const Preset& preset = read->preset;
    QCOMPARE(QString::fromStdString(presetFileName(preset.name) + ".tactum-preset"),
             QFileInfo(file).fileName());
    QVERIFY(!preset.category.empty());
    QVERIFY(preset.colour);
    // Written again, it is the same: nothing in it is unknown or out of its order.
    Preset known = preset;
    known.kept = nullptr;
    QCOMPARE(presetText(known), text);
    const auto hasSource = [&](std::string_view key) {
        const PresetSource& source = sourceOf(preset, key);
        const bool ours = QString::fromStdString(source.words).startsWith(QStringLiteral("Set by us"));
        return !source.words.empty() && (ours || source.link.starts_with("http"));
    };
    int set = 0;
    for (std::size_t i = 0; i < kMaterialFields.size(); ++i) {
        if (!preset.values[i]) continue;
        ++set;
        const Parameter& parameter = *kMaterialFields[i].parameter;
        QVERIFY2(parameter.allows(*preset.values[i]), parameter.label.data());
        QVERIFY2(hasSource(jsonKey(parameter.key)), parameter.label.data());
    }
    if (preset.values[kStatic] || preset.values[kDynamic]) {
        QVERIFY(preset.values[kStatic]);
        QVERIFY(preset.values[kDynamic]);
        QCOMPARE_GE(*preset.values[kStatic], *preset.values[kDynamic]);
    }
    if (preset.layers) {
        QVERIFY(!preset.layers->empty());
        QVERIFY(hasSource(kLayersPart));
    }
    if (preset.shading) QVERIFY(hasSource(kShadingPart));
    QVERIFY(set > 0 || preset.layers || preset.shading);
    QCOMPARE_EQ(preset.sources.size(),
                std::size_t(set) + preset.layers.has_value() + preset.shading.has_value());
}

void TestPresetFile::badFilesAreOneLine_data() {
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<QByteArray>("says");
    const auto add = [](const char* name, const std::string& text, const char* says) {
        QTest::newRow(name) << QByteArray::fromStdString(text) << QByteArray(says);
    };
    add("nothing", "", "JSON");
    add("no JSON", "hello", "JSON");
    add("a list", "[]", "JSON");
    add("a comma too many", "{\n  \"name\": \"x\",\n  \"feel\": {,}\n}\n", ":3: its JSON");
    add("no preset", "{}", "tactumPreset");
    add("later", R"({"tactumPreset":"2.0"})", "later");
    add("version of words", R"({"tactumPreset":"new"})", "tactumPreset");
    add("version is a number", R"({"tactumPreset":1.0})", "tactumPreset");
    add("no name", R"({"tactumPreset":"1.0","feel":{}})", "name");
    add("name is a number", R"({"tactumPreset":"1.0","name":7,"feel":{}})", "name");
    add("no feel", R"({"tactumPreset":"1.0","name":"n"})", "feel");
    add("feel is a list", with("[]"), "feel");
    add("text for a number", with(R"({"staticFriction":"high"})"), "feel staticFriction");
    add("not a number", with(R"({"staticFriction":NaN})"), "JSON");
    add("null", with(R"({"staticFriction":null})"), "staticFriction");
    add("infinite", with(R"({"stiffness":1e999})"), "JSON");
    add("too large", with(R"({"stiffness":1e300})"),
        "feel.stiffness is 1e+300; set it inside 1 to 10000 N/m");
    add("negative", with(R"({"dynamicFriction":-0.1})"), "feel.dynamicFriction");
    add("slips always", with(R"({"staticFriction":0.1,"dynamicFriction":0.2})"), "feel.dynamicFriction");
    add("layers are a number", with(R"({"layers":7})"), "layers");
    add("a layer is a number", with(R"({"layers":[7]})"), "layers[0]");
    add("many layers", with(R"({"layers":[{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}]})"),
        "feel.layers has 17");
    add("high layer", with(R"({"layers":[{"strength":1.0}]})"), "feel.layers[0].strength");
    add("wide layer", with(R"({"layers":[{"pattern":{"size":1e9}}]})"), "feel.layers[0].pattern.size");
    add("mask", with(R"({"layers":[{"mask":{"octaves":-3}}]})"), "feel.layers[0].mask.octaves");
    add("far away", with(R"({"layers":[{"pattern":{"frame":{"translation":[1e400,0,0]}}}]})"), "JSON");
    add("painted", with(R"({"layers":[{"pattern":{"source":"painted","painted":{"attribute":0}}}]})"),
        "painted");
    add("no picture", with(R"({"layers":[{"pattern":{"source":"image"}}]})"), "names no picture");
    add("a picture that is not there",
        with(R"({"layers":[{"pattern":{"source":"image","texture":{"index":3}}}]})"), "images");
    add("no address",
        with(R"({"layers":[{"pattern":{"source":"image","texture":{"index":0}}}]})", R"(,"images":[7])"),
        "images[0]");
    add("an address elsewhere",
        with(R"({"layers":[{"pattern":{"source":"image","texture":{"index":0}}}]})",
             R"(,"images":[{"uri":"file:///etc/passwd"}])"),
        "images[0]");
    add("no base64",
        with(R"({"layers":[{"pattern":{"source":"image","texture":{"index":0}}}]})",
             R"(,"images":[{"uri":"data:image/png;base64,%%%%"}])"),
        "images[0]");
    add("tags are a text", with("{}", R"(,"tags":"soft")"), "tags");
    add("a tag is a number", with("{}", R"(,"tags":[1])"), "tags");
    add("colour out of range", with("{}", R"(,"colour":[0,0,2])"), "colour");
    add("colour of two", with("{}", R"(,"colour":[0,0])"), "colour");
    add("sources are a list", with("{}", R"(,"sources":[])"), "sources");
    add("a source is a text", with("{}", R"(,"sources":{"stiffness":"book"})"), "sources.stiffness");
    add("words are a number", with("{}", R"(,"sources":{"stiffness":{"words":1}})"),
        "sources.stiffness.words");
    add("typical is a text", with("{}", R"(,"sources":{"stiffness":{"typical":"yes"}})"), "typical");
    add("deep", with(std::string(100000, '['), std::string(100000, ']')), "128 levels");
    add("a bell in the name", R"({"tactumPreset":")" + std::string("\\u0007\\n") + R"("})", "tactumPreset");
}

void TestPresetFile::badFilesAreOneLine() {
    QFETCH(QByteArray, text);
    QFETCH(QByteArray, says);
    const auto read = parsed(text.toStdString());
    QVERIFY(!read);
    const QString line = QString::fromStdString(read.error().text);
    COMPARE_BEGINS(line, QStringLiteral("a.tactum-preset:"));
    COMPARE_CONTAINS(line, QString::fromUtf8(says));
    QVERIFY2(!line.contains(u'\n') && line.size() < 400, qPrintable(line));
    QCOMPARE_EQ(read.error().kind, Error::Kind::Input);
}

void TestPresetFile::cutFilesAreOneLine() {
    const std::string whole = presetText(presetOf(richSurface(), "n", {"us", {}, false}).preset);
    for (std::size_t length = 0; length + 2 < whole.size(); ++length) {
        const auto read = parsed(whole.substr(0, length));
        QVERIFY2(!read, qPrintable(QString::number(length)));
        QVERIFY(!read.error().text.empty());
        COMPARE_LACKS(read.error().text, "\n");
    }
    VERIFY_RESULT(parsed(whole));
}

/// A picture that says it has 4 billion texels, and a file that is larger than any preset.
void TestPresetFile::hugeClaimsAreRefused() {
    std::string png("\x89PNG\r\n\x1a\n\0\0\0\rIHDR\0\1\0\0\0\1\0\0\x10\0\0\0\0", 29);
    const auto lying = parsed(with(R"({"layers":[{"pattern":{"source":"image","texture":{"index":0}}}]})",
                                   R"(,"images":[{"uri":"data:image/png;base64,)" + base64Of(png) + "\"}]"));
    QVERIFY(!lying);
    COMPARE_CONTAINS(lying.error().text, "2048 texels");
    QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("large.tactum-preset"));
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly));
    QVERIFY(file.resize(qint64(1) << 30));
    const auto large = readPreset(path.toStdString());
    QVERIFY(!large);
    COMPARE_LACKS(large.error().text, "\n");
    QVERIFY(!readPreset(folder.path().toStdString()));
    QVERIFY(!readPreset(folder.filePath(QStringLiteral("none")).toStdString()));
}

TACTUM_TEST(TestPresetFile)

} // namespace test_preset_file

#include "test_preset_file.moc"
