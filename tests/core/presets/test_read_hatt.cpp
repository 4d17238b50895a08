// Texture models of the Penn toolkit: files of their structure with numbers of our own, against closed forms.
#include <QTest>

#include <cmath>
#include <complex>
#include <numbers>

#include "core/presets/preset_file.h"
#include "core/presets/read_hatt.h"
#include "core/presets/vibration_model.h"
#include "core/surface/texture_feel.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"

namespace test_read_hatt {

using namespace tactum;

namespace {

constexpr double kPi = std::numbers::pi, kRate = 10000;

/// Of 1 + a1 / z + a2 / z^2.
std::vector<double> lsfOf(double a1, double a2) {
    return {std::acos((1 - a1 - a2) / 2), std::acos((a2 - a1 - 1) / 2)};
}

/// Of the polynomial that is 1: white noise.
std::vector<double> flat(int order) {
    std::vector<double> lsf;
    for (int i = 1; i <= order; ++i)
        lsf.push_back(kPi * i / (order + 1));
    return lsf;
}

std::string modelXml(const VibrationModel& model) {
    std::string text = "<model><ARlsf>";
    for (const double value : model.lsf)
        text += "<value>" + QByteArray::number(value, 'g', 17).toStdString() + "</value>";
    const auto element = [](const char* name, double value) {
        return std::string("<") + name + ">" + QByteArray::number(value, 'g', 17).toStdString() + "</" +
               name + ">";
    };
    return text + "</ARlsf>" + element("gain", 1) + element("var", model.variance) +
           element("speedMod", 1e3 * model.speed) + element("forceMod", model.force) + "</model>\n";
}

std::string setXml(const std::vector<VibrationModel>& models, const std::string& mu = "0.35",
                   const std::string& more = {}) {
    std::string text =
        "<?xml version=\"1.0\"?>\n<modelSet>\n<material>felt &amp; fur</material>\n"
        "<AccelUnits>m/s^2</AccelUnits><SpeedUnits>mm/s</SpeedUnits><ForceUnits>N</ForceUnits>\n"
        "<SampleRate>10000</SampleRate>\n<mu>" +
        mu + "</mu>\n<numMod>1</numMod><maxSpeed>200</maxSpeed>\n" + more;
    for (const VibrationModel& model : models)
        text += modelXml(model);
    return text + "</modelSet>\n";
}

Result<LoadedPreset> parsed(const std::string& text) {
    return parseHatt(text, "a.xml");
}

} // namespace

class TestReadHatt : public QObject {
    Q_OBJECT

private slots:
    void spectrumIsThatOfThePolynomial_data();
    void spectrumIsThatOfThePolynomial();
    void whiteNoiseHasAClosedForm_data();
    void whiteNoiseHasAClosedForm();
    void aResonanceAgreesWithAnotherSum_data() { spectrumIsThatOfThePolynomial_data(); }
    void aResonanceAgreesWithAnotherSum();
    void theLayerHasTheRelief();
    void aFileBecomesAPreset();
    void theMiddleModelIsTaken();
    void whatIsNotReadIsSaid();
    void badFilesAreOneLine_data();
    void badFilesAreOneLine();
};

void TestReadHatt::spectrumIsThatOfThePolynomial_data() {
    QTest::addColumn<double>("a1");
    QTest::addColumn<double>("a2");
    QTest::newRow("low") << -1.9 << 0.95;
    QTest::newRow("middle") << -0.3 << 0.8;
    QTest::newRow("high") << 1.2 << 0.5;
    QTest::newRow("real poles") << -0.9 << 0.2;
}

void TestReadHatt::spectrumIsThatOfThePolynomial() {
    QFETCH(double, a1);
    QFETCH(double, a2);
    const VibrationModel model{lsfOf(a1, a2), 0.4, 0.1, 1};
    for (double f = 1; f < kRate / 2; f += 37) {
        const std::complex<double> z = std::polar(1.0, -2 * kPi * f / kRate);
        const double power = 2 * 0.4 / kRate / std::norm(1.0 + a1 * z + a2 * z * z);
        COMPARE_NEAR(accelerationSpectrum(model, kRate, f), power, 1e-9 * power, "");
    }
}

void TestReadHatt::whiteNoiseHasAClosedForm_data() {
    QTest::addColumn<int>("order");
    for (const int order : {0, 1, 2, 7, 20, 41})
        QTest::addRow("%d", order) << order;
}

// Of the spectrum s it is s / (2 pi)^4 times the integral of f^-4, and for the slope s / (2 pi)^2 of f^-2.
void TestReadHatt::whiteNoiseHasAClosedForm() {
    QFETCH(int, order);
    const double s = 2 * 0.7 / kRate, low = kSlowestVibration, high = kRate / 2, speed = 0.12;
    const ReliefFigures relief = reliefOf({flat(order), 0.7, speed, 1}, kRate);
    const double turn = 2 * kPi;
    const double height = std::sqrt(s / std::pow(turn, 4) * (std::pow(low, -3) - std::pow(high, -3)) / 3);
    const double slope = std::sqrt(s / (turn * turn) * (1 / low - 1 / high)) / speed;
    COMPARE_NEAR(relief.height, height, 1e-5 * height, "m");
    COMPARE_NEAR(relief.slope, slope, 1e-5 * slope, "");
}

// Another sum, of the polynomial itself over steps that grow with the frequency.
void TestReadHatt::aResonanceAgreesWithAnotherSum() {
    QFETCH(double, a1);
    QFETCH(double, a2);
    const double speed = 0.1, grow = 1.0001;
    double height = 0, velocity = 0;
    for (double f = kSlowestVibration; f < kRate / 2; f *= grow) {
        const double at = f * std::sqrt(grow), turn = 2 * kPi * at, width = f * (grow - 1);
        const std::complex<double> z = std::polar(1.0, -turn / kRate);
        const double power = 2 * 0.4 / kRate / std::norm(1.0 + a1 * z + a2 * z * z);
        height += width * power / std::pow(turn, 4);
        velocity += width * power / std::pow(turn, 2);
    }
    const ReliefFigures relief = reliefOf({lsfOf(a1, a2), 0.4, speed, 1}, kRate);
    COMPARE_NEAR(relief.height, std::sqrt(height), 1e-3 * std::sqrt(height), "m");
    COMPARE_NEAR(relief.slope, std::sqrt(velocity) / speed, 1e-3 * std::sqrt(velocity) / speed, "");
    COMPARE_NEAR(relief.wavelength(), 2 * kPi * relief.height / relief.slope,
                 1e-12 * 2 * kPi * relief.height / relief.slope, "m");
}

// Felt through the haptic step's own sampling, along many lines.
void TestReadHatt::theLayerHasTheRelief() {
    const ReliefFigures wanted{30e-6, 0.12};
    TriangleSoup soup;
    soup.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    soup.triangles = {{0, 1, 2}};
    soup.surfaceOf = {0};
    const auto stack = compileTextures({noiseLike(wanted)}, std::make_shared<const TriangleSoup>(soup), 0);
    QVERIFY(stack);
    double sum = 0, squares = 0, slopes = 0;
    constexpr int kCount = 200000;
    for (int i = 0; i < kCount; ++i) {
        TexturePoint point;
        point.position = {1e-3 * std::fmod(i * 0.618033988749895, 997.0),
                          1e-3 * std::fmod(i * 0.414213562373095, 991.0), 0};
        const TextureFeel felt = feel(*stack, point, 0);
        sum += felt.height;
        squares += felt.height * felt.height;
        slopes += felt.slope.x() * felt.slope.x();
    }
    const double mean = sum / kCount;
    COMPARE_NEAR(std::sqrt(squares / kCount - mean * mean), wanted.height, 0.03 * wanted.height, "");
    COMPARE_NEAR(std::sqrt(slopes / kCount), wanted.slope, 0.03 * wanted.slope, "");
}

void TestReadHatt::aFileBecomesAPreset() {
    const VibrationModel model{flat(10), 0.5, 0.1, 1};
    const auto read = parsed(setXml({model}));
    VERIFY_RESULT(read);
    const Preset& preset = read->preset;
    QCOMPARE(preset.name, std::string("felt & fur"));
    const Surface surface = applied({}, preset);
    QCOMPARE(surface.material.dynamicFriction, 0.35);
    QCOMPARE(surface.material.staticFriction, 0.35);
    QCOMPARE(surface.layers.size(), std::size_t(1));
    const TextureLayer expected = noiseLike(reliefOf(model, kRate));
    COMPARE_NEAR(surface.layers[0].strength, expected.strength, 1e-9 * expected.strength, "");
    COMPARE_NEAR(surface.layers[0].pattern.size, expected.pattern.size, 1e-9 * expected.pattern.size, "");
    for (const char* part : {"dynamicFriction", "staticFriction", kLayersPart})
        QVERIFY2(!sourceOf(preset, part).words.empty(), part);
    COMPARE_CONTAINS(sourceOf(preset, kLayersPart).words, "100 mm/s and 1 N");
    COMPARE_CONTAINS(read->notes.back(), "licence");
    VERIFY_RESULT(parsePreset(presetText(preset), "a"));
}

void TestReadHatt::theMiddleModelIsTaken() {
    std::vector<VibrationModel> models;
    for (const double speed : {0.0, 0.05, 0.1, 0.2})
        for (const double force : {0.5, 1.5, 3.0})
            models.push_back({flat(4), 0.1, speed, force});
    const auto read = parsed(setXml(models));
    VERIFY_RESULT(read);
    const std::string& words = sourceOf(read->preset, kLayersPart).words;
    COMPARE_CONTAINS(words, "100 mm/s and 1.5 N");
}

void TestReadHatt::whatIsNotReadIsSaid() {
    const VibrationModel model{flat(4), 0.5, 0.1, 1};
    const auto moving = parsed(setXml({model}, "0.35", "<numMACoeff>8</numMACoeff>")),
               none = parsed(setXml({}));
    for (const auto& read : {moving, none}) {
        VERIFY_RESULT(read);
        QVERIFY(!read->preset.layers);
        QCOMPARE(applied({}, read->preset).material.dynamicFriction, 0.35);
        COMPARE_CONTAINS(read->notes.front(), "friction came over");
    }
    const auto still = parsed(setXml({{flat(4), 0, 0.1, 1}, {flat(4), 0.5, 0, 1}}));
    VERIFY_RESULT(still);
    QVERIFY(!still->preset.layers);
}

void TestReadHatt::badFilesAreOneLine_data() {
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<QByteArray>("says");
    const VibrationModel model{flat(4), 0.5, 0.1, 1};
    const auto add = [](const char* name, const std::string& text, const char* says) {
        QTest::newRow(name) << QByteArray::fromStdString(text) << QByteArray(says);
    };
    const auto changed = [&](const char* what, const char* to) {
        return QByteArray::fromStdString(setXml({model})).replace(what, to).toStdString();
    };
    add("nothing", "", "XML");
    add("no XML", "hello <", "XML");
    add("another file", "<X3D><Scene/></X3D>", "modelSet");
    add("cut", setXml({model}).substr(0, 300), "XML");
    add("no friction", changed("mu>", "nu>"), "<mu>");
    add("friction of words", setXml({model}, "high"), "<mu>");
    add("friction is no number", setXml({model}, "nan"), "<mu>");
    add("friction out of range", setXml({model}, "17"), "<mu>");
    add("inches", changed("mm/s<", "in/s<"), "SpeedUnits");
    add("variance is negative", changed("<var>0.5", "<var>-1"), "<var>");
    add("no variance", changed("var>", "vary>"), "<var>");
    add("rate", changed("<SampleRate>10000", "<SampleRate>0"), "SampleRate");
    VibrationModel falling = model;
    std::swap(falling.lsf[1], falling.lsf[2]);
    add("frequencies that fall", setXml({falling}), "<value>");
    falling.lsf = {0.5, 4};
    add("a frequency beyond pi", setXml({falling}), "<value>");
    falling.lsf = flat(300);
    add("a high order", setXml({falling}), "256");
    add("too many models", setXml(std::vector<VibrationModel>(10001, {{}, 0, 0.1, 1})), "10000");
}

void TestReadHatt::badFilesAreOneLine() {
    QFETCH(QByteArray, text);
    QFETCH(QByteArray, says);
    const auto read = parsed(text.toStdString());
    QVERIFY(!read);
    const QString line = QString::fromStdString(read.error().text);
    COMPARE_BEGINS(line, QStringLiteral("a.xml:"));
    COMPARE_CONTAINS(line, QString::fromUtf8(says));
    QVERIFY2(!line.contains(u'\n') && line.size() < 400, qPrintable(line));
}

TACTUM_TEST(TestReadHatt)

} // namespace test_read_hatt

#include "test_read_hatt.moc"
