// The numbers of a texture pattern that make a difference, and how it comes onto the surface.
#pragma once

#include <functional>
#include <vector>

#include <QWidget>

#include "ui/document/document.h"

class QComboBox;
class QLabel;
class QToolButton;

namespace tactum {

class ParameterField;

/// Of a layer or of its mask. Thread: ui.
class PatternFields : public QWidget {
    Q_OBJECT
public:
    using Change = std::function<void(TexturePattern&)>;
    /// `edit` does what a person asked for as one step; `what` is its name. `prefix` is in front of the
    /// object names: a mask has the same fields as its layer.
    using Edit = std::function<void(const QString& what, const Change& change, Gesture gesture)>;
    PatternFields(const QString& prefix, Edit edit, QWidget* parent = nullptr);

    /// Shows a pattern; `hasUvs`: whether the mesh has texture coordinates.
    void display(const TexturePattern& pattern, bool hasUvs);
    /// Whether what was shown last is a picture that is missing.
    bool asksForImage() const { return asksForImage_; }

signals:
    void imageAsked();

private:
    QWidget* makeImageRow();
    QWidget* makeMappingRow();
    void addFields();
    void describe(const TexturePattern& pattern, bool hasUvs);

    QString prefix_;
    Edit edit_;
    QWidget *imageRow_, *mappingRow_;
    QLabel *imageName_, *hint_;
    QComboBox* mapping_;
    bool asksForImage_ = false;
    std::vector<ParameterField*> fields_; ///< in the order of kPatternFields
};

} // namespace tactum
