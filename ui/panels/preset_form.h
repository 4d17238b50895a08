// What is asked when a surface's feel is saved as a preset: its name, and who says so.
#pragma once

#include <QDialog>

#include "core/presets/preset.h"

class QCheckBox;
class QLineEdit;

namespace tactum {

/// Not modal: the values are those of the surface when it was opened. Thread: ui.
class PresetForm : public QDialog {
    Q_OBJECT
public:
    explicit PresetForm(const Surface& surface, QWidget* parent = nullptr);

    /// With what the person has said so far.
    LoadedPreset made() const;

private:
    Surface surface_;
    QLineEdit *name_, *category_, *source_, *link_;
    QCheckBox *values_, *shading_, *layers_;
};

} // namespace tactum
