// How much is selected, in words.
#pragma once

#include <QLabel>

#include "ui/base/background_job.h"

namespace tactum {

class Document;

/// "2 surfaces, 1204 triangles, 52 cm²", or of selected triangles "12 triangles, 0.40 mm²"; empty for
/// nothing. Counted on a worker: for large models it follows the selection a moment later. Thread: ui.
class SelectionCount : public QLabel {
    Q_OBJECT
public:
    /// The document outlives it.
    explicit SelectionCount(Document& document, QWidget* parent = nullptr);

private:
    void count();

    Document& document_;
    BackgroundJob job_;
    bool again_ = false; ///< another selection came while it was counted
};

} // namespace tactum
