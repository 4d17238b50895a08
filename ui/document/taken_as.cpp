#include "ui/document/taken_as.h"
#include "ui/base/words.h"

#include <algorithm>
#include <cmath>

#include <QSettings>

#include "core/base/text.h"

namespace tactum {

namespace {

/// "import/stl/unit"
QString keyOf(const std::filesystem::path& file, const char* what) {
    return QStringLiteral("import%1/%2")
        .arg(QString::fromStdString(lowerCase(file.extension().string())), QLatin1String(what))
        .replace(u'.', u'/');
}

void remember(const QString& key, const QVariant& value, bool isGuess) {
    if (isGuess)
        QSettings().remove(key);
    else
        QSettings().setValue(key, value);
}

} // namespace

std::optional<TakenAs> takeAs(LoadedScene& loaded, const AxesChoice& choice) {
    if (!loaded.unitGuessed && !loaded.upGuessed) return std::nullopt;
    TakenAs taken;
    taken.unitOpen = loaded.unitGuessed;
    taken.upOpen = loaded.upGuessed;
    if (taken.unitOpen) {
        taken.guess = guessAxes(loaded.scene);
        taken.axes.unit = choice.unit.value_or(taken.guess.unit);
    }
    if (taken.upOpen) taken.axes.zUp = choice.zUp.value_or(taken.guess.zUp);
    taken.by = taken.axes == taken.guess ? TakenAs::By::Guess : TakenAs::By::Choice;
    placeAs(loaded.scene, taken.axes);
    taken.across = boundsOf(loaded.scene).diagonal();
    std::erase_if(loaded.findings, saysUnit); // the window shows as what it was taken
    return taken;
}

std::optional<double> unitBySize(double units, double unitBefore, double before) {
    constexpr double kJump = 20; // an inch is 25 mm, and nobody makes a part 20 times as large
    constexpr double kAlike = 3; // units are at least 2.5 times as long as the next
    if (!(units > 0 && before > 0)) return std::nullopt;
    const auto farOff = [&](double unit) { return std::abs(std::log(units * unit / before)); };
    if (farOff(unitBefore) < std::log(kJump)) return std::nullopt;
    const double best = std::ranges::min(kLengthUnits, {}, [&](const LengthUnit& unit) {
                            return farOff(unit.metres);
                        }).metres;
    return farOff(best) < std::log(kAlike) ? std::optional(best) : std::nullopt;
}

AxesChoice rememberedAxes(const std::filesystem::path& file) {
    const QSettings settings;
    AxesChoice choice;
    const QString unit = settings.value(keyOf(file, "unit")).toString();
    choice.unit = metresOf(unit.toStdString());
    const QString up = settings.value(keyOf(file, "up")).toString();
    if (up == QLatin1String("y") || up == QLatin1String("z")) choice.zUp = up == QLatin1String("z");
    return choice;
}

void rememberUnit(const std::filesystem::path& file, double unit, double guess) {
    const auto known = std::ranges::find(kLengthUnits, unit, &LengthUnit::metres);
    if (known == std::end(kLengthUnits)) return;
    remember(keyOf(file, "unit"), asIs(known->name), unit == guess);
}

void rememberUp(const std::filesystem::path& file, bool zUp, bool guess) {
    remember(keyOf(file, "up"), zUp ? QStringLiteral("z") : QStringLiteral("y"), zUp == guess);
}

} // namespace tactum
