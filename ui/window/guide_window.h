// Help > Guide: the pages of docs/guide inside the program.
#pragma once

class QString;
class QWidget;

namespace tactum {

/// The first page of the guide, of an installed program or of the tree that it was built from; empty where
/// there is none.
QString guidePage();
/// Opens it in a window of its own; Esc closes it.
void showGuide(QWidget* parent);

} // namespace tactum
