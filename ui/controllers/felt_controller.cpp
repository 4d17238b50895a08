#include "ui/controllers/felt_controller.h"

#include <algorithm>

#include <QActionGroup>
#include <QSettings>

#include "ui/view/scene_view.h"

namespace tactum {

namespace {

/// Commands that are remembered, and the switch that each of them is.
struct Switch {
    const char* id;
    bool FeltOptions::*on;
};
constexpr Switch kSwitches[] = {{"contact-normals", &FeltOptions::normals},
                                {"contact-planes", &FeltOptions::planes},
                                {"stylus", &FeltOptions::stylus},
                                {"loupe", &FeltOptions::loupe},
                                {"friction-cone", &FeltOptions::cone},
                                {"trail", &FeltOptions::trail},
                                {"felt-normals", &FeltOptions::feltNormals},
                                {"spheres", &FeltOptions::spheres},
                                {"relief", &FeltOptions::relief},
                                {"ground", &FeltOptions::ground},
                                {"boundaries", &FeltOptions::boundaries},
                                {"wireframe", &FeltOptions::wireframe}};
constexpr std::pair<const char*, FeltValue> kMaps[] = {{"map-stiffness", FeltValue::Stiffness},
                                                       {"map-damping", FeltValue::Damping},
                                                       {"map-static-friction", FeltValue::StaticFriction},
                                                       {"map-dynamic-friction", FeltValue::DynamicFriction},
                                                       {"map-viscosity", FeltValue::Viscosity},
                                                       {"map-height", FeltValue::Height}};
constexpr std::pair<const char*, double> kBumps[] = {{"bumps-1", 1}, {"bumps-10", 10}, {"bumps-100", 100}};

QString settingOf(const char* id) {
    return QStringLiteral("view/") + QString::fromLatin1(id);
}

} // namespace

FeltController::FeltController(const Workbench& bench) : QObject(&bench.window), bench_(bench) {
    const QSettings settings;
    const auto remembered = [&](const char* id, bool initial) {
        bench_.actions[id].setChecked(settings.value(settingOf(id), initial).toBool());
        connect(&bench_.actions[id], &QAction::toggled, this, &FeltController::show);
    };
    // One of each list at most: a click on the one that is on switches it off.
    const auto group = [&](const auto& rows) {
        auto* one = new QActionGroup(this);
        one->setExclusionPolicy(QActionGroup::ExclusionPolicy::ExclusiveOptional);
        for (const auto& [id, value] : rows) {
            one->addAction(&bench_.actions[id]);
            remembered(id, false);
        }
    };
    for (const auto& [id, on] : kSwitches)
        remembered(id, FeltOptions{}.*on);
    group(kMaps);
    group(kBumps);
    FeltOptions options;
    options.sphereLevel = settings.value(QStringLiteral("view/sphere-level"), options.sphereLevel).toInt();
    bench_.view.setFelt(options);
    const auto step = [this](int levels) {
        FeltOptions next = bench_.view.felt();
        next.sphereLevel = std::clamp(next.sphereLevel + levels, 0, kDeepestLevel);
        QSettings().setValue(QStringLiteral("view/sphere-level"), next.sphereLevel);
        bench_.view.setFelt(next);
    };
    connect(&bench_.actions["spheres-finer"], &QAction::triggered, this, [step] { step(1); });
    connect(&bench_.actions["spheres-coarser"], &QAction::triggered, this, [step] { step(-1); });
    show();
}

void FeltController::show() {
    QSettings settings;
    const auto on = [&](const char* id) {
        const bool checked = bench_.actions[id].isChecked();
        settings.setValue(settingOf(id), checked);
        return checked;
    };
    FeltOptions options;
    options.sphereLevel = bench_.view.felt().sphereLevel;
    for (const auto& [id, value] : kSwitches)
        options.*value = on(id);
    for (const auto& [id, value] : kMaps)
        if (on(id)) options.map = value;
    for (const auto& [id, value] : kBumps)
        if (on(id)) options.bumps = value;
    for (const char* id : {"spheres-finer", "spheres-coarser"})
        bench_.actions[id].setEnabled(options.spheres);
    bench_.view.setFelt(options);
}

} // namespace tactum
