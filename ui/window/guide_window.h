// Help > Guide: the pages of docs/guide inside the program, in groups, with a search through all of them.
#pragma once

#include <QDialog>

#include "ui/window/guide_pages.h"

class QLineEdit;
class QTreeWidgetItem;
class QUrl;

namespace tactum {

class GuideBrowser;
class HintedTree;

/// Ctrl+F searches; Esc ends the search, then closes the window. Thread: ui.
class GuideWindow : public QDialog {
    Q_OBJECT
public:
    GuideWindow(const QString& firstPage, QWidget* parent);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override; ///< from the search into the list
    void reject() override;

private:
    void build();
    void search();
    void listPages();
    void listPlaces(const QStringList& words);
    void open(const QTreeWidgetItem* item);
    void openFirst();
    void showWhere(const QUrl& page);

    QString first_;
    GuideIndex index_;
    GuideBrowser* page_;
    QLineEdit* field_;
    HintedTree* list_;
};

/// The first page of the guide, of an installed program or of the tree that it was built from; empty where
/// there is none.
QString guidePage();
/// Opens it in a window of its own.
void showGuide(QWidget* parent);

} // namespace tactum
