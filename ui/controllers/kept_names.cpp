#include "ui/controllers/kept_names.h"

#include <QInputDialog>
#include <QMenu>

#include "core/base/text.h"
#include "ui/base/words.h"

namespace tactum {

QString inMenu(const QString& name) {
    constexpr int kMost = 60; // letters: a menu is no wider than a screen
    QString shown = name.size() > kMost ? name.left(kMost - 1) + u'\u2026' : name;
    return shown.replace(u'&', QStringLiteral("&&"));
}

void addNamesMenu(QMenu& menu, const QString& verb, const char* id, const QStringList& names, bool possible,
                  const std::function<void(const QString&)>& does) {
    auto* which = new QMenu(verb, &menu);
    which->setObjectName(QString::fromLatin1(id));
    for (const QString& name : names)
        which->addAction(inMenu(name), which, [does, name] { does(name); });
    menu.addMenu(which)->setEnabled(possible && !names.isEmpty());
}

QString nextName(const QString& pattern, const QStringList& taken) {
    int number = 1;
    while (taken.contains(pattern.arg(number)))
        ++number;
    return pattern.arg(number);
}

QString askForName(QWidget* parent, const QString& title, const QString& label, const QString& now) {
    bool agreed = false;
    const QString name = QInputDialog::getText(parent, title, label, QLineEdit::Normal, now, &agreed);
    return agreed ? asIs(printable(name.trimmed().toStdString(), kLongestName)) : QString();
}

} // namespace tactum
