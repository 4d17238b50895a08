// How panels stack what they hold.
#pragma once

#include <QVBoxLayout>

namespace tactum {

/// A column without margins of its own.
inline QVBoxLayout* columnIn(QWidget* of, int spacing) {
    auto* layout = new QVBoxLayout(of);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(spacing);
    return layout;
}

} // namespace tactum
