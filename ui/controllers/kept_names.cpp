#include "ui/controllers/kept_names.h"

#include <utility>

#include <QInputDialog>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>

#include "core/base/text.h"
#include "ui/base/words.h"

namespace tactum {

namespace {

/// Stays open over a name that cannot be: what was typed is not lost.
class NameDialog final : public QInputDialog {
public:
    NameDialog(QWidget* parent, const QString& label, std::function<QString(const QString&)> whyNot)
        : QInputDialog(parent), label_(label), whyNot_(std::move(whyNot)) {
        setLabelText(label);
        auto* words = findChild<QLabel*>();
        words->setTextFormat(Qt::PlainText); // a name may be in it
        words->setWordWrap(true);
        words->setMinimumWidth(kNameWidth);
    }
    QString name() const { return asIs(printable(textValue().trimmed().toStdString(), kLongestName)); }
    void done(int result) override {
        const QString why = result == Accepted && !name().isEmpty() ? whyNot_(name()) : QString();
        if (why.isEmpty()) return QInputDialog::done(result);
        setLabelText(label_ + u'\n' + why);
        findChild<QLineEdit*>()->setFocus();
    }

private:
    static constexpr int kNameWidth = 320;

    QString label_;
    std::function<QString(const QString&)> whyNot_;
};

} // namespace

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

QString askForName(QWidget* parent, const QString& title, const QString& label, const QString& now,
                   const std::function<QString(const QString&)>& whyNot) {
    NameDialog dialog(parent, label, whyNot);
    dialog.setWindowTitle(title);
    dialog.setTextValue(now);
    return dialog.exec() == QDialog::Accepted ? dialog.name() : QString();
}

} // namespace tactum
