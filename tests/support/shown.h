// What a person finds in a widget, as text: words, states and figures, and what it paints by itself.
#pragma once

#include <functional>

#include <QSize>
#include <QString>

#include "tests/support/as_shown.h"

class QPainter;
class QWidget;

namespace tactum::test {

/// A line for the widget and each one in it, two spaces deeper for each level: kind, name, and whatever is
/// set differently than such a widget has it by itself; with rows of lists, actions and the room that layouts
/// give. Sizes that a layout found are no part of it.
QString shownIn(const QWidget& widget);

/// A line for each stroke, area and word that the widget paints itself, without its children. Colours have
/// the names of the theme; pixels have one digit behind the point.
QString drawnBy(QWidget& widget);
/// The same of a function that paints.
QString drawnBy(QSize size, const std::function<void(QPainter&)>& paint);

} // namespace tactum::test
