#include "ui/base/mnemonics.h"

#include <functional>
#include <vector>

#include <QAbstractButton>
#include <QApplication>
#include <QDialog>
#include <QEvent>
#include <QLabel>
#include <QMenu>

namespace tactum {

namespace {

/// Where the letter is that a text marks, behind its '&'; -1 where it marks none. "&&" is a '&' to be read.
qsizetype marked(const QString& text) {
    for (qsizetype i = text.indexOf(u'&'); i >= 0 && i + 1 < text.size(); i = text.indexOf(u'&', i + 2))
        if (text[i + 1] != u'&') return i + 1;
    return -1;
}

QString without(QString text) {
    const qsizetype at = marked(text);
    return at < 0 ? text : text.remove(at - 1, 1);
}

/// Something with a text that can have a letter.
struct Lettered {
    QString text;
    std::function<void(const QString&)> set;
};

/// Those first that have one: they keep it.
void share(std::vector<Lettered> all) {
    QString used;
    for (const bool first : {true, false})
        for (Lettered& each : all) {
            if ((marked(each.text) >= 0) != first) continue;
            const QString next = withMnemonic(each.text, used);
            if (next != each.text) each.set(next);
        }
}

class DialogFilter : public QObject {
public:
    using QObject::QObject;
    bool eventFilter(QObject* watched, QEvent* event) override {
        auto* dialog = event->type() == QEvent::Show ? qobject_cast<QDialog*>(watched) : nullptr;
        // When it is complete: some of Qt's own get a button only now.
        if (dialog)
            QMetaObject::invokeMethod(
                dialog, [dialog] { giveMnemonics(*dialog); }, Qt::QueuedConnection);
        return false;
    }
};

} // namespace

QString withMnemonic(const QString& text, QString& used) {
    const auto take = [&](qsizetype at) {
        const QChar letter = at >= 0 && at < text.size() ? text[at].toLower() : QChar();
        if (!letter.isLetterOrNumber() || used.contains(letter)) return false;
        used += letter;
        return true;
    };
    if (take(marked(text))) return text;
    const QString bare = without(text);
    for (qsizetype i = 0; i < bare.size(); ++i) {
        const QChar letter = bare[i].toLower();
        if (!letter.isLetterOrNumber() || used.contains(letter)) continue;
        used += letter;
        return QString(bare).insert(i, u'&');
    }
    return bare;
}

void giveMnemonics(QWidget& dialog) {
    std::vector<Lettered> all;
    for (auto* button : dialog.findChildren<QAbstractButton*>())
        if (button->window() == &dialog && !button->text().isEmpty())
            all.push_back({button->text(), [button](const QString& text) { button->setText(text); }});
    for (auto* label : dialog.findChildren<QLabel*>())
        if (label->window() == &dialog && label->buddy() && !label->text().isEmpty())
            all.push_back({label->text(), [label](const QString& text) { label->setText(text); }});
    share(std::move(all));
}

void giveMnemonics(QMenu& menu) {
    std::vector<Lettered> all;
    for (QAction* action : menu.actions())
        if (!action->isSeparator() && !action->text().isEmpty())
            all.push_back({action->text(), [action](const QString& text) { action->setText(text); }});
    share(std::move(all));
}

void giveMnemonicsToDialogs() {
    static QObject* filter = nullptr;
    if (filter) return;
    filter = new DialogFilter(qApp);
    qApp->installEventFilter(filter);
}

} // namespace tactum
