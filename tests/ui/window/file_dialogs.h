// Answers to dialogs that ask for a file or a text.
#pragma once

#include <QApplication>
#include <QDir>
#include <QFileDialog>
#include <QInputDialog>
#include <QLineEdit>
#include <QTimer>

namespace tactum {

/// Answers the next one as a person does, by typing; `offered`: the folder in which it began.
/// `QFileDialog::selectFile()` leaves alone a name that has the keyboard.
inline void answerFileDialog(const QString& file, QString* offered = nullptr) {
    auto* timer = new QTimer;
    QObject::connect(timer, &QTimer::timeout, timer, [timer, file, offered] {
        auto* dialog = qobject_cast<QFileDialog*>(QApplication::activeModalWidget());
        if (!dialog) return;
        if (offered) *offered = dialog->directory().path();
        dialog->findChild<QLineEdit*>(QStringLiteral("fileNameEdit"))->setText(file);
        QMetaObject::invokeMethod(dialog, "accept");
        timer->deleteLater();
    });
    timer->start(20);
}

/// Types into the next dialog that asks for a text.
inline void answerTextDialog(const QString& text) {
    auto* timer = new QTimer;
    QObject::connect(timer, &QTimer::timeout, timer, [timer, text] {
        auto* dialog = qobject_cast<QInputDialog*>(QApplication::activeModalWidget());
        if (!dialog) return;
        dialog->setTextValue(text);
        dialog->accept();
        timer->deleteLater();
    });
    timer->start(20);
}

/// Types a name that another one has into the next such dialog, waits until it says `sentence` with the name
/// still there, and then types `other`; or gives up where that is empty.
inline void answerTakenName(const QString& taken, const QString& sentence, const QString& other) {
    auto* timer = new QTimer;
    QObject::connect(timer, &QTimer::timeout, timer, [=] {
        auto* dialog = qobject_cast<QInputDialog*>(QApplication::activeModalWidget());
        if (!dialog) return;
        if (!dialog->labelText().contains(sentence)) {
            dialog->setTextValue(taken);
            return dialog->accept();
        }
        if (dialog->textValue() != taken) qFatal("what was typed is lost");
        dialog->setTextValue(other);
        other.isEmpty() ? dialog->reject() : dialog->accept();
        timer->deleteLater();
    });
    timer->start(20);
}

} // namespace tactum
