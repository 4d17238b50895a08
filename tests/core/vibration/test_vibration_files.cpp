// Files of vibration as their formats say: RIFF by its chunks, .hjif by what MPEG's reference software asks
// of one (IOJson.cpp of HapticReferenceSoftware, 2024), .haptic by Lofelt's data model 1.0.0 and its rules of
// validation. The test itself would be wrong if those pages were read wrongly: both were read by hand.
#include <cmath>
#include <numbers>

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTest>
#include <QtEndian>

#include "core/vibration/vibration_files.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"

namespace test_vibration_files {

using namespace tactum;
using namespace tactum::test;

namespace {

/// A swelling tone of 150 Hz for half a second, up to 0.5 N.
Vibration tone() {
    Vibration vibration;
    for (int i = 0; i <= 4000; ++i)
        vibration.force.push_back(0.5 * i / 4000 * std::sin(2 * std::numbers::pi * 150 * i / 8000));
    return vibration;
}

QByteArray bytesOf(const char* name, const Vibration& vibration = tone()) {
    return QByteArray::fromStdString(*vibrationBytes(vibration, name, "wall.glb"));
}

QJsonObject jsonOf(const char* name) {
    QJsonParseError fault{};
    const QJsonObject json = QJsonDocument::fromJson(bytesOf(name), &fault).object();
    if (fault.error != QJsonParseError::NoError) qFatal("%s", qPrintable(fault.errorString()));
    return json;
}

QString keysOf(const QJsonObject& object) {
    return QStringList(object.keys()).join(' ');
}

template <typename T> T little(const QByteArray& bytes, qsizetype at) {
    return qFromLittleEndian<T>(bytes.constData() + at);
}

} // namespace

class TestVibrationFiles : public QObject {
    Q_OBJECT

private slots:
    void aWavIsOneChannelAtFullScale() {
        const QByteArray wav = bytesOf("a.wav");
        COMPARE_BEGINS(wav, "RIFF");
        QCOMPARE(qsizetype(little<quint32>(wav, 4)) + 8, wav.size());
        QCOMPARE(wav.mid(8, 8), QByteArray("WAVEfmt "));
        QCOMPARE(little<quint32>(wav, 16), 16u);
        QCOMPARE(little<quint16>(wav, 20), quint16(1)); // PCM
        QCOMPARE(little<quint16>(wav, 22), quint16(1)); // channels
        QCOMPARE(little<quint32>(wav, 24), 8000u);
        QCOMPARE(little<quint32>(wav, 28), 16000u); // bytes a second
        QCOMPARE(little<quint16>(wav, 34), quint16(16));
        COMPARE_CONTAINS(wav, "Vibration of a touch of wall.glb; full scale is 0.4");
        const qsizetype data = wav.indexOf("data");
        QCOMPARE(qsizetype(little<quint32>(wav, data + 4)), 2 * 4001);
        const Vibration written = tone();
        const double scale = 32767 / peakOf(written);
        double off = 0, loudest = 0;
        for (int i = 0; i <= 4000; ++i) {
            const double sample = little<qint16>(wav, data + 8 + 2 * i);
            off = std::max(off, std::abs(sample - written.force[std::size_t(i)] * scale));
            loudest = std::max(loudest, std::abs(sample));
        }
        COMPARE_NEAR(off, 0, 0.5001, "steps");
        QCOMPARE(loudest, 32767.0);
    }

    void anHjifIsACurveThroughTheSamples() {
        const QJsonObject json = jsonOf("a.hjif");
        QCOMPARE(keysOf(json),
                 QString("avatars date description level perceptions profile syncs timescale version"));
        QCOMPARE(json["version"].toString(), QString("2023"));
        QCOMPARE(json["profile"].toString(), QString("Main"));
        QCOMPARE(json["timescale"].toInt(), 8000);
        const QJsonObject perception = json["perceptions"][0].toObject();
        QCOMPARE(keysOf(perception), QString("avatar_id channels description effect_library id "
                                             "perception_modality reference_devices"));
        const QJsonObject channel = perception["channels"][0].toObject();
        QCOMPARE(keysOf(channel), QString("bands body_part_mask description gain id mixing_coefficient"));
        const QJsonObject band = channel["bands"][0].toObject();
        QCOMPARE(band["band_type"].toString(), QString("Curve"));
        QCOMPARE(band["curve_type"].toString(), QString("Linear"));
        const QJsonArray keyframes = band["effects"][0]["keyframes"].toArray();
        const Vibration written = tone();
        double off = 0;
        int next = 0;
        for (int i = 0; i <= 4000; ++i) {
            while (next + 1 < keyframes.size() - 1 && keyframes[next + 1]["relative_position"].toInt() <= i)
                ++next;
            const auto at = [&](int k) { return double(keyframes[k]["relative_position"].toInt()); };
            const auto value = [&](int k) { return keyframes[k]["amplitude_modulation"].toDouble(); };
            const double part = (i - at(next)) / (at(next + 1) - at(next));
            const double curve = value(next) + part * (value(next + 1) - value(next));
            off = std::max(off, std::abs(curve - written.force[std::size_t(i)] / peakOf(written)));
        }
        COMPARE_NEAR(off, 0, 1e-3, "of full scale");
        COMPARE_NEAR(double(keyframes.size()), 0, 3500, "keyframes of 4001 samples");
    }

    void aHapticIsAnEnvelope() {
        const QJsonObject json = jsonOf("a.haptic");
        QCOMPARE(keysOf(json), QString("metadata signals version"));
        QCOMPARE(keysOf(json["version"].toObject()), QString("major minor patch"));
        QCOMPARE(json["version"]["major"].toInt(), 1);
        const QJsonObject envelopes = json["signals"]["continuous"]["envelopes"].toObject();
        const QJsonArray amplitude = envelopes["amplitude"].toArray(),
                         frequency = envelopes["frequency"].toArray();
        QCOMPARE(amplitude.size(), 51);
        QCOMPARE(frequency.size(), 51);
        double before = 0;
        for (int i = 0; i < 51; ++i) {
            for (const double value :
                 {amplitude[i]["amplitude"].toDouble(), frequency[i]["frequency"].toDouble()})
                COMPARE_NEAR(value, 0.5, 0.5, "of the range 0 to 1");
            QVERIFY2(amplitude[i]["time"].toDouble() >= before, "breakpoints go on in time");
            before = amplitude[i]["time"].toDouble();
        }
        COMPARE_NEAR(before, 0.5, 1e-6, "s");
        COMPARE_NEAR(amplitude[25]["amplitude"].toDouble(), 0.5, 0.01, "of full scale");
        // log2(150 / 60) of log2(300 / 60) octaves
        COMPARE_NEAR(frequency[25]["frequency"].toDouble(), 0.5693, 0.005, "of the range");
    }

    void ofNothingThereAreFilesAsWell() {
        const Vibration nothing{8000, std::vector<double>(100, 0.0)};
        for (const char* name : {"a.wav", "a.hjif", "a.haptic"})
            COMPARE_CONTAINS(bytesOf(name, nothing), "full scale is 1 N");
    }

    void anotherEndingIsRefused() {
        COMPARE_CONTAINS(vibrationBytes(tone(), "a.ogg", "x").error().text,
                         "a.ogg: a vibration cannot be written by its ending");
    }
};

TACTUM_TEST(TestVibrationFiles)

} // namespace test_vibration_files

#include "test_vibration_files.moc"
