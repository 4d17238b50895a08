// The window beside a folder: what is done there, and what it changes in window and folder.
#pragma once

#include "tests/ui/window/told_window.h"

namespace tactum {

class WindowWithFiles {
public:
    explicit WindowWithFiles(const QString& theFolder) : folder(theFolder) {
        testing::adopt(told.document, testing::knownScene());
        told.catchUp();
    }
    virtual ~WindowWithFiles() = default;
    WindowWithFiles(const WindowWithFiles&) = delete;
    WindowWithFiles& operator=(const WindowWithFiles&) = delete;

    QString file(const char* name) const { return folder + u'/' + QLatin1String(name); }

    /// Until nothing is read or written any more; a question is answered when the dialog is there.
    void note(const QString& words, const std::function<void()>& act,
              std::function<void(QDialog&)> answer = {}) {
        if (answer) effects.answerNext(std::move(answer));
        effects.note(words, [&] {
            act();
            if (!test::waitFor([this] { return !QApplication::activeModalWidget() && rests(); }))
                qFatal("it does not end");
            told.frames(3);
            files_ += QStringLiteral("%1: %2\n").arg(words, files()); // before an edit is undone
        });
    }
    void command(const char* id, std::function<void(QDialog&)> answer = {}) {
        const auto act = [&] { told.command(id).trigger(); };
        note(QLatin1String(id), act, std::move(answer));
    }
    QString said() const {
        QString text = effects.text() + files_;
        return text.replace(folder, QStringLiteral("FOLDER"));
    }

    QString folder;
    ToldWindow told;
    WindowEffects effects{told.effects()};

protected:
    virtual bool rests() const = 0;
    /// What is to be known of the files.
    virtual QString files() const = 0;

private:
    QString files_;
};

} // namespace tactum
