#include "ui/panels/self_test_page.h"

#include <iterator>

#include <QDoubleSpinBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QVBoxLayout>

#include "ui/base/numbers.h"
#include "ui/base/style.h"
#include "ui/base/words.h"
#include "ui/panels/workspace_picture.h"
#include "ui/widgets/force_meter.h"

namespace tactum {
namespace {

constexpr int kLarger = 6;      // points, of what the person does
constexpr int kCountFor = 500;  // ms, of readings
constexpr double kLightest = 5; // g
constexpr double kUsual = 50;   // g
constexpr double kGramsToKilo = 1e-3;

QLabel* label(const char* name) {
    auto* made = new QLabel;
    made->setObjectName(QLatin1String(name));
    made->setWordWrap(true);
    return made;
}

} // namespace

SelfTestPage::SelfTestPage(QWidget* parent)
    : QWidget(parent), heading_(label("self-test-part")), words_(label("self-test-words")),
      doing_(label("self-test-doing")), rate_(label("self-test-rate")), massRow_(new QWidget),
      mass_(new QDoubleSpinBox), picture_(new WorkspacePicture), force_(new ForceMeter),
      progress_(new QProgressBar) {
    heading_->setProperty("dimmed", true);
    QFont large = words_->font();
    large.setPointSizeF(large.pointSizeF() + kLarger);
    words_->setFont(large);
    words_->setMinimumHeight(3 * QFontMetrics(large).lineSpacing());
    words_->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    doing_->setMinimumHeight(doing_->fontMetrics().lineSpacing()); // it comes and goes
    picture_->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    mass_->setObjectName(QStringLiteral("self-test-mass"));
    mass_->setSuffix(QStringLiteral(" g"));
    mass_->setDecimals(1);
    progress_->setObjectName(QStringLiteral("self-test-progress"));
    progress_->setAccessibleName(tr("How much of this part is measured"));
    progress_->setTextVisible(false);
    auto* massName = new QLabel(tr("&Mass"));
    massName->setBuddy(mass_);
    auto* massLine = new QHBoxLayout(massRow_);
    massLine->setContentsMargins({});
    massLine->addWidget(massName);
    massLine->addWidget(mass_);
    massLine->addStretch();
    auto* live = new QHBoxLayout;
    live->addWidget(force_, 1);
    live->addSpacing(2 * kRhythm);
    live->addWidget(rate_);
    auto* column = new QVBoxLayout(this);
    column->setSpacing(kRhythm);
    column->addWidget(heading_);
    column->addWidget(words_);
    column->addWidget(massRow_);
    column->addWidget(picture_, 1);
    column->addLayout(live);
    column->addWidget(doing_);
    column->addWidget(progress_);
    column->addWidget(makeButtons());
    wait();
}

QWidget* SelfTestPage::makeButtons() {
    const auto button = [](const QString& text, const char* name) {
        auto* made = new QPushButton(text);
        made->setObjectName(QLatin1String(name));
        made->setAutoDefault(true);
        return made;
    };
    continue_ = button(tr("&Continue"), "self-test-continue");
    continue_->setProperty("primary", true);
    skip_ = button(tr("&Skip this"), "self-test-skip");
    cancel_ = button(tr("Cancel"), "self-test-cancel");
    connect(continue_, &QPushButton::clicked, this, &SelfTestPage::goOn);
    connect(skip_, &QPushButton::clicked, this, [this] {
        wait();
        emit skipped();
    });
    connect(cancel_, &QPushButton::clicked, this, &SelfTestPage::cancelled);
    auto* row = new QWidget;
    auto* line = new QHBoxLayout(row);
    line->setContentsMargins({});
    line->addWidget(cancel_);
    line->addStretch();
    line->addWidget(skip_);
    line->addWidget(continue_);
    return row;
}

void SelfTestPage::goOn() {
    if (ask_ == TrialAsk::Zero) zero_ = handle_;
    const bool mass = asksMass_;
    wait();
    if (mass)
        emit massGiven(kGramsToKilo * mass_->value());
    else
        emit done();
}

/// Nothing is asked for. The focus is left where Esc and Enter do no harm.
void SelfTestPage::wait() {
    cancel_->setFocus();
    continue_->setEnabled(false);
    skip_->setEnabled(false);
    massRow_->hide();
    asksMass_ = false;
}

void SelfTestPage::say(const QString& words) {
    words_->setText(words);
    continue_->setAccessibleDescription(words); // so that who hears the focus hears what is to be done
}

void SelfTestPage::showPreparing(const QString& step, const QString& request) {
    heading_->setText(tr("The device is being made ready"));
    say(wordsOf(std::string_view((request.isEmpty() ? step : request).toStdString())));
    doing_->clear();
}

void SelfTestPage::showPart(TrialPart part) {
    part_ = part;
    heading_->setText(tr("Part %1 of %2: %3")
                          .arg(int(part) + 1)
                          .arg(std::size(kTrialParts))
                          .arg(wordsOf(std::string_view(kTrialParts[std::size_t(part)]))));
    doing_->clear();
}

void SelfTestPage::ask(const TrialQuestion& question) {
    asksMass_ = question.kind == TrialQuestion::Kind::Mass;
    ask_ = question.ask;
    if (asksMass_) {
        const double heaviest = question.heaviest / kGramsToKilo;
        mass_->setRange(kLightest, std::max(kLightest, heaviest));
        mass_->setValue(kUsual);
        say(tr("What can you hang on the handle by a thread? Some coins, for instance, whose mass you know; "
               "better 50 g than 10, at most %1 g.")
                .arg(numberText(heaviest, 0)));
    } else {
        say(trialText(question.words));
    }
    aimFor(question.ask);
    massRow_->setVisible(asksMass_);
    doing_->clear();
    continue_->setEnabled(true);
    skip_->setEnabled(true);
    if (asksMass_)
        mass_->setFocus();
    else
        continue_->setFocus();
}

/// Where the handle is led, or where it will hold itself.
void SelfTestPage::aimFor(TrialAsk ask) {
    std::optional<Vec3> aim = Vec3(Vec3::Zero());
    if (ask == TrialAsk::Right) aim = zero_ + kRulerWay * Vec3::UnitX();
    if (ask == TrialAsk::Up) aim = zero_ + kRulerWay * Vec3::UnitY();
    if (ask == TrialAsk::Toward) aim = zero_ + kRulerWay * Vec3::UnitZ();
    if (part_ == TrialPart::Rest || part_ == TrialPart::Buttons || asksMass_) aim.reset();
    picture_->setAim(aim);
}

void SelfTestPage::tell(const QString& words) {
    doing_->setText(words);
}

void SelfTestPage::showEnding() {
    wait();
    say(tr("The forces are off. The device is being closed."));
    cancel_->setEnabled(false);
}

void SelfTestPage::show(const TrialLook& look, const DeviceInfo& device) {
    handle_ = look.position;
    picture_->setHandle(look.position, device.workspaceRadius);
    force_->setForce(look.force.norm(), device.maxForce);
    progress_->setValue(int(100 * look.part));
    if (look.runs && doing_->text().isEmpty()) doing_->setText(tr("It is being measured."));
    if (counted_.isValid() && counted_.elapsed() < kCountFor) return;
    if (counted_.isValid())
        rate_->setText(
            tr("%1 readings a second")
                .arg(numberText(1e3 * double(look.readings - readings_) / double(counted_.elapsed()), 0)));
    readings_ = look.readings;
    counted_.start();
}

} // namespace tactum
