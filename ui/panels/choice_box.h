// A list of choices in a panel that scrolls.
#pragma once

#include <span>

#include <QComboBox>
#include <QWheelEvent>

#include "ui/document/layer_edits.h"

namespace tactum {

/// The wheel scrolls the panel: it never changes what is chosen. Thread: ui.
class ChoiceBox : public QComboBox {
public:
    /// `name`: for its object name and for those who hear it.
    ChoiceBox(const char* objectName, const QString& name, std::span<const NamedChoice> choices) {
        setObjectName(QLatin1String(objectName));
        setAccessibleName(name);
        for (const NamedChoice& choice : choices)
            addItem(labelOf(choice));
        setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
        setMinimumContentsLength(8);
        setSizeAdjustPolicy(AdjustToMinimumContentsLengthWithIcon);
    }

protected:
    void wheelEvent(QWheelEvent* event) override { event->ignore(); }
};

} // namespace tactum
