// Everything that can be set on one texture layer.
#pragma once

#include <functional>

#include <QWidget>

#include "ui/document/document.h"

class QCheckBox;
class QComboBox;
class QToolButton;

namespace tactum {

class ParameterField;
class PatternFields;

/// Shows only what makes a difference for the layer as it is. Thread: ui.
class LayerFields : public QWidget {
    Q_OBJECT
public:
    using Change = std::function<void(TextureLayer&)>;
    /// Does what a person asked for as one step; `what` is its name.
    using Edit = std::function<void(const QString& what, const Change& change, Gesture gesture)>;
    explicit LayerFields(Edit edit, QWidget* parent = nullptr);

    /// Shows a layer; `hasUvs`: whether the mesh has texture coordinates.
    void display(const TextureLayer& layer, bool hasUvs);
    /// Whether the person has chosen to paint the mask where both could be painted.
    bool paintsMask() const;

signals:
    /// A picture for the layer or its mask is to be chosen.
    void imageAsked(bool ofMask);
    void paintsMaskChanged();

private:
    void addChanges(QLayout& rows);
    void addPattern(QLayout& rows);
    void addMask(QLayout& rows);
    void chooseSource(int source);
    void chooseMask(int choice);
    void displayMask(const TextureLayer& layer, bool hasUvs);

    Edit edit_;
    QComboBox *source_, *target_, *blend_, *maskSource_;
    QWidget* blendRow_;
    ParameterField *height_, *ratio_, *opacity_;
    QCheckBox* ownPlane_;
    PatternFields *pattern_, *mask_;
    QToolButton* paintMask_;
};

} // namespace tactum
