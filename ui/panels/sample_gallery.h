// Sample scenes as pictures: a click opens one.
#pragma once

#include <QStringList>
#include <QWidget>

namespace tactum {

/// The scenes of a folder that have a picture beside them (NAME.glb and NAME.png), by name.
QStringList samplesIn(const QString& folder);

class SampleGallery : public QWidget {
    Q_OBJECT
public:
    /// `files`: scenes with their pictures beside them.
    explicit SampleGallery(const QStringList& files, QWidget* parent = nullptr);

signals:
    void fileChosen(const QString& file);
};

} // namespace tactum
