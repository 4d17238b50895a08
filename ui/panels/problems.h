// What is the matter with the scene, and what to do about it.
#pragma once

#include <vector>

#include "ui/background_job.h"
#include "ui/document.h"
#include "ui/panels/hinted_tree.h"

namespace tactum {

/// The reader's findings and those of validate(), checked on a worker whenever shapes change. Activating one
/// selects its object.
class Problems : public HintedTree {
    Q_OBJECT
public:
    explicit Problems(Document& document, QWidget* parent = nullptr);

signals:
    void counted(int problems);

private:
    void check();
    void fill(const std::vector<Finding>& health);
    void add(const Finding& finding);
    bool has(const Finding& finding) const;
    void selectObjectOf(const QTreeWidgetItem* item);

    Document& document_;
    BackgroundJob job_;
};

} // namespace tactum
