#include "ui/engine/health_words.h"

#include <QObject>

#include "core/safety/inhibit_words.h"

namespace tactum {

namespace {

// Less than what the device promises by so much: the servo's measured period says so.
constexpr double kLateServo = 0.99;

QString wordsOf(CeilingReason reason) {
    switch (reason) {
    case CeilingReason::Damping:
        return QObject::tr("limited by the damping of device and hand");
    case CeilingReason::SurfaceDamping:
        return QObject::tr("limited by the damping of the surface");
    case CeilingReason::Resolution:
        return QObject::tr("limited by the resolution of the device");
    case CeilingReason::Hand:
        return QObject::tr("limited by what a hand bears");
    case CeilingReason::Maker:
        break;
    }
    return QObject::tr("limited by the maker's figure");
}

} // namespace

QString guardSentences(InhibitReason why) {
    const InhibitWords& words = inhibitWords(why);
    return QStringLiteral("%1 %2 %3")
        .arg(QObject::tr(words.what), QObject::tr(words.done), QObject::tr(words.remedy))
        .simplified();
}

CeilingNow ceilingNow(const ServoTelemetry& servo, const DeviceInfo& device) {
    StiffnessCeiling promised = safeStiffness(loopFigures(device));
    promised.value /= servo.frame.scale; // a spring of the scene is so much stiffer in the hand
    const StiffnessCeiling now = servo.ceiling.value > 0 ? servo.ceiling : promised;
    if (servo.stiffnessScale < 1)
        return {servo.stiffnessScale * now.value, QObject::tr("limited by an oscillation that was seen")};
    if (now.reason != CeilingReason::SurfaceDamping && now.value < kLateServo * promised.value)
        return {now.value, QObject::tr("limited by a servo that comes late"), true};
    if (servo.doubted)
        return {now.value, QObject::tr("the grip seems lighter than chosen under Device > Live")};
    return {now.value, wordsOf(now.reason)};
}

QString fidelityWords(Fidelity fidelity) {
    switch (fidelity) {
    case Fidelity::Full:
        return QObject::tr("Nothing is left out.");
    case Fidelity::NoTexture:
        return QObject::tr("Textures are left out: the scene is too heavy.");
    case Fidelity::NoShading:
        return QObject::tr("Textures and force shading are left out: the scene is too heavy.");
    case Fidelity::PlaneOnly:
        break;
    }
    return QObject::tr("Only the nearest planes are felt: the scene is too heavy.");
}

QString lateWords(const ServoTelemetry& servo, bool recorded) {
    if (recorded) return QObject::tr("%1 so far").arg(servo.misses);
    return QObject::tr("%1 of our own, %2 of the machine's")
        .arg(servo.misses - servo.machineMisses)
        .arg(servo.machineMisses);
}

Stiffest stiffestOf(const Scene& scene) {
    Stiffest most;
    for (const SceneObject& object : scene.objects)
        for (const Surface& surface : object.surfaces)
            if (object.visible && surface.material.stiffness > most.value)
                most = {surface.material.stiffness, QString::fromStdString(surface.name)};
    return most;
}

} // namespace tactum
