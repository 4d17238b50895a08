#include "ui/controllers/preferences_dialog.h"

#include <QComboBox>
#include <QDialog>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <QTabWidget>

#include "ui/base/mnemonics.h"
#include "ui/base/numbers.h"
#include "ui/base/preferences.h"
#include "ui/base/style.h"
#include "ui/base/words.h"
#include "ui/widgets/number_box.h"

namespace tactum {

namespace {

Preferences& preferences() {
    return Preferences::instance();
}

QComboBox* choiceOf(const Preference& each, QWidget* parent) {
    auto* box = new QComboBox(parent);
    for (const char* choice : each.choices)
        box->addItem(wordsOf(choice));
    const auto show = [box, id = each.id] { box->setCurrentIndex(int(preferences().value(id))); };
    show();
    QObject::connect(box, &QComboBox::activated, box, [id = each.id](int i) { preferences().set(id, i); });
    QObject::connect(&preferences(), &Preferences::changed, box, show);
    return box;
}

NumberBox* numberOf(const Preference& each, QWidget* parent) {
    const Parameter& of = each.parameter;
    const QString unit = asIs(of.unit);
    auto* box = new NumberBox(unit, parent);
    box->setDecimals(of.decimals);
    box->setRange(of.minimum, of.maximum);
    box->setSingleStep(of.step);
    box->setSuffix(unit.isEmpty() ? QString() : u' ' + unit);
    const auto show = [box, id = each.id] { box->setValue(preferences().value(id)); };
    show();
    const auto keep = [id = each.id](double value) { preferences().set(id, value); };
    QObject::connect(box, &NumberBox::typed, box, keep);
    QObject::connect(box, &NumberBox::stepped, box, keep);
    QObject::connect(&preferences(), &Preferences::changed, box, show);
    return box;
}

void addRow(QFormLayout& form, const Preference& each) {
    QWidget* field = each.choices.empty() ? static_cast<QWidget*>(numberOf(each, form.parentWidget()))
                                          : choiceOf(each, form.parentWidget());
    const QString name = wordsOf(each.parameter.label);
    field->setObjectName(asIs(each.parameter.key));
    field->setAccessibleName(name);
    field->setMinimumWidth(30 * kRhythm);
    auto* label = new QLabel(name);
    label->setBuddy(field);
    form.addRow(label, field);
    QString meaning = wordsOf(each.parameter.sentence);
    if (each.atNextStart) meaning += u' ' + QObject::tr("Counts from the next start on.");
    auto* sentence = new QLabel(meaning);
    sentence->setProperty("dimmed", true);
    sentence->setWordWrap(true);
    form.addRow(QString(), sentence);
    field->setAccessibleDescription(meaning);
}

void forgetPage(const QString& page) {
    for (const Preference& each : preferenceTable())
        if (wordsOf(each.page) == page) preferences().set(each.id, each.parameter.initial);
}

} // namespace

void showPreferences(QWidget* parent) {
    const auto kName = QStringLiteral("preferences");
    if (auto* shown = parent->findChild<QDialog*>(kName)) {
        shown->raise();
        return shown->activateWindow();
    }
    auto* dialog = new QDialog(parent);
    dialog->setObjectName(kName);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setWindowTitle(QObject::tr("Preferences"));
    auto* pages = new QTabWidget;
    pages->setObjectName(QStringLiteral("preferences-pages"));
    pages->setAccessibleName(dialog->windowTitle());
    QFormLayout* form = nullptr;
    for (const Preference& each : preferenceTable()) {
        const QString title = wordsOf(each.page);
        if (!form || pages->tabText(pages->count() - 1) != title) {
            auto* page = new QWidget;
            form = new QFormLayout(page);
            form->setVerticalSpacing(kRhythm / 2);
            pages->addTab(page, title);
        }
        addRow(*form, each);
    }
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::RestoreDefaults | QDialogButtonBox::Close);
    auto* defaults = buttons->button(QDialogButtonBox::RestoreDefaults);
    defaults->setText(QObject::tr("&Defaults of this page"));
    QObject::connect(defaults, &QPushButton::clicked, pages,
                     [pages] { forgetPage(pages->tabText(pages->currentIndex())); });
    for (QAbstractButton* each : buttons->buttons())
        each->setIcon({});
    QObject::connect(buttons, &QDialogButtonBox::rejected, dialog, &QDialog::close);
    auto* all = new QVBoxLayout(dialog);
    all->addWidget(pages);
    all->addWidget(buttons);
    dialog->resize(70 * kRhythm, dialog->sizeHint().height());
    dialog->show();
}

} // namespace tactum
