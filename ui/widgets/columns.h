// How panels stack what they hold.
#pragma once

#include <QLabel>
#include <QScrollArea>
#include <QVBoxLayout>

#include "ui/base/style.h"

namespace tactum {

/// A column without margins of its own.
inline QVBoxLayout* columnIn(QWidget* of, int spacing) {
    auto* layout = new QVBoxLayout(of);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(spacing);
    return layout;
}

/// Words that are no heading and no value.
inline QLabel* dimmedLine(const QString& text) {
    auto* label = new QLabel(text);
    label->setProperty("dimmed", true);
    label->setWordWrap(true);
    return label;
}

/// A page of a dock that is scrolled up and down, and wide enough for a field with its unit.
inline QScrollArea* scrolled(QWidget* page) {
    auto* scroll = new QScrollArea;
    scroll->setWidget(page);
    scroll->setWidgetResizable(true);
    scroll->setFocusPolicy(Qt::NoFocus); // it follows the field that has the keys
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    scroll->setMinimumWidth(31 * kRhythm);
    return scroll;
}

} // namespace tactum
