#include "ui/panels/self_test_dialog.h"

#include <QDesktopServices>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QStackedWidget>
#include <QStandardPaths>
#include <QUrl>
#include <QVBoxLayout>

#include "ui/base/style.h"
#include "ui/base/words.h"
#include "ui/panels/self_test_page.h"
#include "ui/panels/self_test_result.h"

namespace tactum {
namespace {

constexpr int kFrame = 16;                // ms
constexpr double kSilent = 1;             // s without a reading: the device is not there any more
constexpr int kWidth = 104, kHeight = 72; // of kRhythm

QLabel* paragraph(const QString& text) {
    auto* made = new QLabel(text);
    made->setWordWrap(true);
    return made;
}

QPushButton* button(const QString& text, const char* name) {
    auto* made = new QPushButton(text);
    made->setObjectName(QLatin1String(name));
    return made;
}

} // namespace

SelfTestDialog::SelfTestDialog(const QString& name, QWidget* parent)
    : QDialog(parent), pages_(new QStackedWidget), page_(new SelfTestPage), result_(new SelfTestResult) {
    setObjectName(QStringLiteral("self-test-dialog"));
    setWindowTitle(tr("Self-test of %1").arg(name));
    pages_->addWidget(makeIntroduction(name));
    pages_->addWidget(page_);
    pages_->addWidget(result_);
    pages_->addWidget(makeEnd());
    auto* column = new QVBoxLayout(this);
    column->addWidget(pages_);
    connect(page_, &SelfTestPage::done, this, [this] { run_->answer(true); });
    connect(page_, &SelfTestPage::skipped, this, [this] { run_->answer(false); });
    connect(page_, &SelfTestPage::massGiven, this, [this](double mass) { run_->answerMass(mass); });
    connect(page_, &SelfTestPage::cancelled, this, &SelfTestDialog::reject);
    connect(result_, &SelfTestResult::closePressed, this, &SelfTestDialog::accept);
    connect(result_, &SelfTestResult::keepPressed, this, [this] { emit keep(*report_); });
    connect(result_, &SelfTestResult::showPressed, this, &SelfTestDialog::showReport);
    connect(result_, &SelfTestResult::savePressed, this, &SelfTestDialog::save);
    connect(&frames_, &QTimer::timeout, this, &SelfTestDialog::look);
    frames_.setInterval(kFrame);
    start_->setFocus(); // and not what comes first, which ends it
    resize(kWidth * kRhythm, kHeight * kRhythm);
}

QWidget* SelfTestDialog::makeIntroduction(const QString& name) {
    auto* page = new QWidget;
    auto* column = new QVBoxLayout(page);
    column->setSpacing(2 * kRhythm);
    auto* heading = paragraph(tr("What %1 really is, in about ten minutes").arg(name));
    QFont large = heading->font();
    large.setPointSizeF(1.5 * large.pointSizeF());
    heading->setFont(large);
    column->addWidget(heading);
    for (const QString& text :
         {tr("You are led through these parts, and the test finds how the device reads, which way its motors "
             "push, what they move and how late they are."),
          tr("You need a ruler, and some coins of known mass on a thread, better 50 g than 10. What you "
             "cannot "
             "do may be skipped."),
          tr("Never more than four tenths of the device's force is used, and a handle that is too fast gets "
             "none. Cancel or Esc ends the test at any time: the force is gone at once."),
          tr("The scene is not touched. Afterwards the window has the device again, with the forces off.")})
        column->addWidget(paragraph(text));
    QString parts;
    for (const char* part : kTrialParts)
        parts += QStringLiteral("<li>%1</li>").arg(wordsOf(std::string_view(part)).toHtmlEscaped());
    column->insertWidget(2, paragraph(QStringLiteral("<ol>%1</ol>").arg(parts)));
    column->addStretch();
    auto* cancel = button(tr("Cancel"), "self-test-leave");
    start_ = button(tr("&Start"), "self-test-start");
    start_->setProperty("primary", true);
    start_->setDefault(true);
    connect(cancel, &QPushButton::clicked, this, &SelfTestDialog::reject);
    connect(start_, &QPushButton::clicked, this, &SelfTestDialog::start);
    auto* row = new QHBoxLayout;
    row->addWidget(cancel);
    row->addStretch();
    row->addWidget(start_);
    column->addLayout(row);
    return page;
}

QWidget* SelfTestDialog::makeEnd() {
    auto* page = new QWidget;
    auto* column = new QVBoxLayout(page);
    auto* heading = paragraph(tr("The self-test has ended without a result. The forces are off."));
    heading->setProperty("heading", true);
    failure_ = paragraph({});
    failure_->setObjectName(QStringLiteral("self-test-failure"));
    failure_->setProperty("limit", true);
    auto* close = button(tr("Close"), "self-test-end");
    connect(close, &QPushButton::clicked, this, &SelfTestDialog::reject);
    column->addWidget(heading);
    column->addWidget(failure_);
    column->addStretch();
    column->addWidget(close, 0, Qt::AlignRight);
    return page;
}

void SelfTestDialog::start() {
    pages_->setCurrentWidget(page_);
    page_->showPreparing({}, {});
    waits_ = true;
    emit started();
}

void SelfTestDialog::begin(std::unique_ptr<HapticDevice> device, const SelfTestPace& pace) {
    waits_ = false;
    if (leaves_) return QDialog::reject();
    run_ = std::make_unique<SelfTestRun>(std::move(device), pace);
    connect(run_.get(), &SelfTestRun::prepares, page_, &SelfTestPage::showPreparing);
    connect(run_.get(), &SelfTestRun::begun, page_, &SelfTestPage::showPart);
    connect(run_.get(), &SelfTestRun::asked, page_, &SelfTestPage::ask);
    connect(run_.get(), &SelfTestRun::told, page_, &SelfTestPage::tell);
    connect(run_.get(), &SelfTestRun::finished, this, &SelfTestDialog::finishRun, Qt::QueuedConnection);
    run_->start();
    frames_.start();
}

void SelfTestDialog::fail(const QString& sentence) {
    waits_ = false;
    if (leaves_) return QDialog::reject();
    failure_->setText(sentence);
    pages_->setCurrentIndex(3);
}

/// Once a frame.
void SelfTestDialog::look() {
    const auto look = run_ ? run_->look() : std::nullopt;
    if (!look) return;
    page_->show(*look, run_->device());
    // Between two experiments nobody else would notice before the person goes on.
    if (look->silent >= kSilent && look->readings > 0)
        run_->end(
            tr("%1 gives no readings any more: look at its cable and its supply. It is made ready again "
               "by itself when it is there.")
                .arg(asIs(run_->device().name)));
}

void SelfTestDialog::finishRun() {
    frames_.stop();
    const QString failure = run_->failure();
    if (run_->finishedWhole()) report_ = std::make_unique<SelfTestReport>(run_->report());
    run_.reset();
    if (leaves_) return QDialog::reject();
    if (!report_) return fail(failure);
    result_->show(*report_);
    pages_->setCurrentWidget(result_);
}

/// At once while nothing runs; else when the device is closed.
void SelfTestDialog::reject() {
    if (!run_ && !waits_) return QDialog::reject();
    leaves_ = true;
    if (run_) run_->end();
    page_->showEnding();
}

void SelfTestDialog::tellKept(const QString& words, bool wrong) {
    result_->tell(words, wrong);
}

void SelfTestDialog::showReport() {
    const QString folder =
        QStandardPaths::writableLocation(QStandardPaths::CacheLocation) + QStringLiteral("/self-test");
    if (const auto written = writeSelfTest(*report_, selfTestDate(), folder.toStdU16String()); !written)
        return result_->tell(QString::fromStdString(written.error().text), true);
    const QString page = folder + QStringLiteral("/report.html");
    if (!QDesktopServices::openUrl(QUrl::fromLocalFile(page)))
        result_->tell(tr("No program shows pages here; the report is %1.").arg(page), true);
}

void SelfTestDialog::save() {
    const QString place = QFileDialog::getExistingDirectory(this, tr("Save the self-test into a folder"));
    if (place.isEmpty()) return;
    const QString folder = place + QStringLiteral("/self-test-") + QString::fromStdString(selfTestDate());
    const auto written = writeSelfTest(*report_, selfTestDate(), folder.toStdU16String());
    result_->tell(written ? tr("The profile, the report and every tick are in %1.").arg(folder)
                          : QString::fromStdString(written.error().text),
                  !written);
}

} // namespace tactum
