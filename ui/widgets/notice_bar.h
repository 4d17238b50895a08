// One line over the top of the view for what just happened or is under way. Never modal.
#pragma once

#include <functional>
#include <optional>

#include <QTimer>
#include <QWidget>

class QBoxLayout;
class QLabel;
class QProgressBar;
class QPushButton;
class QToolButton;

namespace tactum {

/// Shows either a message, until it is closed or replaced, or the progress of work with a cancel button,
/// behind which a message waits for its end.
class NoticeBar : public QWidget {
    Q_OBJECT
public:
    explicit NoticeBar(QWidget* parent = nullptr);

    void showError(const QString& sentence) { showMessage({sentence, QStringLiteral("error")}); }
    void showNote(const QString& sentence) { showMessage({sentence, QStringLiteral("note")}); }
    /// With a button that does something about it; pressing it closes the message first.
    void offer(const QString& sentence, const QString& severity, const QString& button,
               std::function<void()> action);
    /// One more thing to do about the message that is shown, beside its button.
    void alsoOffer(const QString& button, std::function<void()> action);
    /// The message of that sentence is no longer true, or only what was also offered about it.
    void takeBack(const QString& sentence);
    void takeBackAlso(const QString& sentence);
    /// Takes back what was offered with that button, if it is still shown.
    void withdraw(const QString& button);
    /// secondsLeft < 0: not known yet.
    void showProgress(const QString& what, double fraction, double secondsLeft, bool cancellable);
    /// Ends the progress, if that is what is shown; a message stays.
    void endProgress();
    QString text() const;

signals:
    void cancelled();

protected:
    void changeEvent(QEvent* event) override; ///< another theme
    void hideEvent(QHideEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    struct Message {
        QString sentence, severity;
        QString button{}; ///< empty: it offers nothing
        std::function<void()> action{};
        QString also{};
        std::function<void()> alsoAction{};
    };

    void showMessage(Message message);
    void fit();
    void press(std::function<void()> Message::*action);
    void setSeverity(const QString& severity);

    QLabel* icon_;
    QLabel* text_;
    QBoxLayout *inside_, *buttons_; ///< the words, and beside or below them the buttons
    QProgressBar* bar_;
    QPushButton* cancel_;
    QPushButton* act_;
    QPushButton* also_;
    std::optional<Message> message_; ///< shown, or waiting behind progress
    QTimer fading_;
    QToolButton* close_;
};

} // namespace tactum
