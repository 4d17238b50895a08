// How everything looks: one theme at a time, one style sheet made from it, icons in its colours.
#pragma once

#include <QIcon>
#include <QString>

#include "ui/base/theme.h"

class QWidget;

namespace tactum {

/// The unit of the layout, in pixels; half of it inside controls.
inline constexpr int kRhythm = 8;

enum class ThemeChoice { Dark, Light, System };

/// What the person chose last; dark at first.
ThemeChoice rememberedTheme();
/// Palette, font, style sheet and dialogs of the whole application. Call it before the first widget is made,
/// and whenever the person chooses. Thread: ui.
void applyTheme(ThemeChoice choice);
/// While there is one, widgets are made without the style sheet: where there is one, whatever is put into
/// something else has it looked up anew for all that is in it, once for each level that it is put into. Its
/// end gives it to all. Thread: ui.
class WithoutStyleSheet {
public:
    WithoutStyleSheet();
    ~WithoutStyleSheet();
    WithoutStyleSheet(const WithoutStyleSheet&) = delete;
    WithoutStyleSheet& operator=(const WithoutStyleSheet&) = delete;

private:
    QString kept_;
};
/// The theme that is on.
const Theme& theme();

/// An icon of resources/icons in the colours of the theme: dimmed when disabled, accented when checked.
QIcon icon(const QString& name);
/// The same stroke in a colour of its own.
QIcon icon(const QString& name, const QColor& colour);

/// The program's own picture, `size` pixels square.
QPixmap logo(int size);

/// Looks the style sheet up anew for a widget and all in it: one of its properties has changed.
void repolish(QWidget& widget);

/// A font whose figures all have one width, `points` larger than the application's.
QFont figureFont(int points = 0);

} // namespace tactum
