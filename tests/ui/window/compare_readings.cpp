#include "tests/ui/window/compare_readings.h"

#include <algorithm>

#include <QTest>

#include "core/files/gltf/gltf_maps.h"
#include "core/scene/object_bounds.h"
#include "tests/support/compare.h"
#include "tests/ui/window/five_models.h"

namespace tactum::test {

bool hasBumps(const SceneObject& object, const Surface& surface) {
    return canShowBumps(object) && std::ranges::any_of(surface.layers, [](const TextureLayer& layer) {
               return layer.enabled && layer.target == TextureTarget::Height;
           });
}

namespace {

/// The farthest that a program was off.
struct Worst {
    double turn = 0, place = 0, colour = 0; ///< entries of matrices, m, linear RGB
};

/// Notes how far one is from the other, to be compared with what is allowed.
double far(const Vec3& a, const Vec3& b, double& worst) {
    const double distance = (a - b).norm();
    worst = std::max(worst, distance);
    return distance;
}

/// Within a millionth of a length of the scene's size, for Blender has single precision; colours within a
/// step of a screen.
void compareObject(const SceneObject& object, const Reading& reading, Worst& worst) {
    constexpr double kPart = 1e-6, kSize = 0.3, kStep = 1.0 / 255;
    const auto found = std::ranges::find(reading.objects, object.name, &ReadObject::name);
    QVERIFY2(found != reading.objects.end(), object.name.c_str());
    const Mat3 turn = object.pose.rotation.normalized().toRotationMatrix();
    const auto& its = found->matrix;
    for (int row = 0; row < 3; ++row)
        QCOMPARE_LT(far(Vec3(&its[std::size_t(4 * row)]), turn.row(row), worst.turn), kPart);
    QCOMPARE_LT(far({its[3], its[7], its[11]}, object.pose.translation, worst.place), kPart * kSize);
    QCOMPARE_LT(far({its[12], its[13], its[14]}, Vec3::Zero(), worst.turn), kPart);
    QCOMPARE_EQ(its[15], 1.0);
    QCOMPARE_LT(far(found->box.low, boundsOf(object).low, worst.place), kPart * kSize);
    QCOMPARE_LT(far(found->box.high, boundsOf(object).high, worst.place), kPart * kSize);
    QCOMPARE(found->materials.size(), object.surfaces.size());
    for (std::size_t i = 0; i < object.surfaces.size(); ++i) {
        const Surface& surface = object.surfaces[i];
        const ReadMaterial& read = found->materials[i];
        QCOMPARE(read.name, surface.name);
        QCOMPARE_LT(far(read.colour, surface.colour.cast<double>(), worst.colour), kStep);
        const auto& [rough, metallic] = surface.name == "jug low"    ? kJugLow
                                        : surface.name == "jug high" ? kJugHigh
                                                                     : kUsualLook;
        COMPARE_NEAR(read.roughness, rough, kPart, "");
        COMPARE_NEAR(read.metallic, metallic, kPart, "");
        QCOMPARE(read.bumps, hasBumps(object, surface));
    }
}

} // namespace

void compareWith(const Scene& scene, const Readings& readings) {
    QVERIFY2(readings.fault.isEmpty(), qPrintable(readings.fault));
    QCOMPARE(readings.files.size(), std::size_t(2));
    for (const Reading& reading : readings.files) {
        Worst worst;
        QCOMPARE(reading.objects.size(), std::size_t(5));
        for (const SceneObject& object : scene.objects)
            if (compareObject(object, reading, worst); QTest::currentTestFailed()) return;
        qInfo("%s: turns differ by at most %.1g, places by %.1g m, colours by %.1g",
              qPrintable(reading.reader), worst.turn, worst.place, worst.colour);
    }
}

} // namespace tactum::test
