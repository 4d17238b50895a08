#include "ui/widgets/number_box.h"

#include <utility>

#include <QKeyEvent>
#include <QLineEdit>
#include <QTimer>

#include "ui/base/numbers.h"
#include "ui/base/style.h"

namespace tactum {

NumberBox::NumberBox(const QString& unit, QWidget* parent) : QDoubleSpinBox(parent), unit_(unit) {
    setLocale(QLocale::c());
    setButtonSymbols(NoButtons);
    setAlignment(Qt::AlignRight);
    setKeyboardTracking(false);
    setCorrectionMode(CorrectToNearestValue);
    setFont(figureFont());
    connect(this, &QDoubleSpinBox::valueChanged, this, [this](double value) {
        if (stepping_)
            emit stepped(value);
        else
            emit typed(value);
    });
    connect(lineEdit(), &QLineEdit::textEdited, this,
            [this](const QString& text) { entry_ = readNumber(text, unit_); });
    connect(this, &QDoubleSpinBox::editingFinished, this, &NumberBox::noteEntry);
}

void NumberBox::noteEntry() {
    if (!wrong_.isEmpty()) emit notUnderstood(std::exchange(wrong_, {}));
    const auto entry = std::exchange(entry_, std::nullopt);
    if (entry && mixed_) emit typed(std::clamp(*entry, minimum(), maximum())); // the very value shown by one
    if (entry && (*entry < minimum() || *entry > maximum())) emit outOfRange(*entry);
}

void NumberBox::stepBy(int steps) {
    stepping_ = true;
    QDoubleSpinBox::stepBy(steps);
    stepping_ = false;
}

void NumberBox::setMixed(bool mixed) {
    if (mixed == mixed_) return;
    mixed_ = mixed;
    lineEdit()->setText(textFromValue(value()));
}

QString NumberBox::textFromValue(double value) const {
    if (mixed_) return tr("mixed");
    return numberText(value, decimalsFor(value, decimals()));
}

double NumberBox::valueFromText(const QString& text) const {
    const double number = readNumber(text, unit_).value_or(value());
    return std::clamp(number, minimum(), maximum());
}

QValidator::State NumberBox::validate(QString& text, int&) const {
    if (readNumber(text, unit_) || (mixed_ && text == textFromValue(value()))) return QValidator::Acceptable;
    // On the way to a number: digits, a sign, a point, an exponent, a unit.
    for (QChar c : text)
        if (!c.isLetterOrNumber() && !QStringLiteral("+-.,^/*%\u00b0\u00b7 ").contains(c))
            return QValidator::Invalid;
    return QValidator::Intermediate;
}

void NumberBox::fixup(QString& text) const {
    if (!readNumber(text, unit_) && !text.trimmed().isEmpty() && text != textFromValue(value()))
        wrong_ = text;
    text = textFromValue(value());
}

bool NumberBox::event(QEvent* event) {
    if (event->type() == QEvent::ShortcutOverride && isOfTheProgram(*static_cast<QKeyEvent*>(event)))
        return false;
    return QDoubleSpinBox::event(event);
}

/// A line wants many of the keys with Ctrl for itself, the end of the line for one.
bool NumberBox::isOfTheProgram(const QKeyEvent& key) const {
    const auto is = [&](QKeySequence::StandardKey what) { return key.matches(what); };
    // Nothing typed that the line could take back: undo and redo are the document's.
    if (is(QKeySequence::Undo) || is(QKeySequence::Redo)) return !lineEdit()->isModified();
    const bool isOfText = is(QKeySequence::Copy) || is(QKeySequence::Cut) || is(QKeySequence::Paste) ||
                          is(QKeySequence::SelectAll);
    return key.modifiers().testFlag(Qt::ControlModifier) && !isOfText;
}

void NumberBox::focusInEvent(QFocusEvent* event) {
    QDoubleSpinBox::focusInEvent(event);
    // After the click that gave the focus has placed its cursor.
    QTimer::singleShot(0, this, &QAbstractSpinBox::selectAll);
}

} // namespace tactum
