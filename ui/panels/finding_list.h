// Findings as rows with their severity, and a dialog that lists some.
#pragma once

#include <vector>

#include "core/scene/findings.h"
#include "ui/widgets/hinted_tree.h"

class QDialog;

namespace tactum {

/// A row with icon, object and sentence; the tooltip has the remedy.
QTreeWidgetItem* addFindingRow(QTreeWidget& tree, const Finding& finding);
/// "lid: 2 holes"
QString findingLine(const Finding& finding);

/// Not modal; deletes itself. Thread: ui.
QDialog* showFindings(const QString& title, const QString& sentence, const std::vector<Finding>& findings,
                      QWidget* parent);

} // namespace tactum
