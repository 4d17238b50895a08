#include "ui/widgets/force_plot.h"

#include <algorithm>
#include <numbers>

#include <QBuffer>
#include <QEvent>
#include <QFileInfo>
#include <QLabel>
#include <QPainter>
#include <QSettings>
#include <QSvgGenerator>
#include <QToolBar>
#include <QToolButton>
#include <QVBoxLayout>

#include "core/base/atomic_file.h"
#include "ui/base/numbers.h"
#include "ui/base/style.h"

namespace tactum {

namespace {

constexpr int kTimeAxis = 16;    // pixels more for the strip that writes the times
constexpr double kMinSpan = 0.2; // s
constexpr int kStripHeight = 160, kPictureWidth = 960;
constexpr double kPictureScale = 2; // device pixels to a logical one, of a PNG

std::vector<StripKind> kinds() {
    using Style = StripLine::Style;
    using S = TouchSample;
    const auto tr = [](const char* text) { return QObject::tr(text); };
    return {
        {"force",
         tr("Force"),
         "N",
         1,
         2,
         {{tr("force"), &S::magnitude, &Theme::proxy, Style::Filled},
          {tr("normal"), &S::normal, &Theme::contact, Style::Plain, true},
          {tr("along the surface"), &S::tangential, &Theme::stick, Style::Friction, true}},
         0.5,
         true},
        {"ratio",
         tr("Friction ratio"),
         "",
         1,
         3,
         {{tr("static"), &S::staticFriction, &Theme::stick, Style::Limit, true},
          {tr("dynamic"), &S::dynamicFriction, &Theme::slip, Style::Limit, true},
          {tr("tangential by normal"), &S::ratio, &Theme::stick, Style::Friction, true}},
         0.1},
        {"lag",
         tr("Proxy lag"),
         "mm",
         1e3,
         3,
         {{tr("finger to proxy"), &S::lag, &Theme::finger, Style::Filled}},
         0.5},
        {"energy",
         tr("Energy"),
         "mJ",
         1e3,
         3,
         {{tr("made by the surface, 0 or less is passive"), &S::energy, &Theme::accent, Style::Filled}},
         0.1},
        {"rate",
         tr("Rates"),
         "Hz",
         1,
         0,
         {{tr("servo"), &S::servoRate, &Theme::finger}, {tr("proxy"), &S::proxyRate, &Theme::proxy}},
         1000},
        {"joint-angle",
         tr("Joint angle"),
         "\u00b0",
         180 / std::numbers::pi,
         2,
         {{tr("of the selected body"), &S::jointAngle, &Theme::accent}},
         1,
         false,
         StripKind::Of::Turning},
        {"joint-turning",
         tr("Turning"),
         "rad/s",
         1,
         2,
         {{tr("of the selected body's joint"), &S::jointTurning, &Theme::accent}},
         0.1,
         false,
         StripKind::Of::Turning},
        {"joint-torque",
         tr("Joint torque"),
         "N mm",
         1e3,
         3,
         {{tr("of its springs, motor, friction and stops"), &S::jointTorque, &Theme::proxy}},
         0.1,
         false,
         StripKind::Of::Turning},
        {"joint-way",
         tr("Joint way"),
         "mm",
         1e3,
         3,
         {{tr("of the selected body"), &S::jointWay, &Theme::accent}},
         0.1,
         false,
         StripKind::Of::Sliding},
        {"joint-speed",
         tr("Sliding"),
         "m/s",
         1,
         3,
         {{tr("of the selected body's joint"), &S::jointSpeed, &Theme::accent}},
         0.01,
         false,
         StripKind::Of::Sliding},
        {"joint-force",
         tr("Joint force"),
         "N",
         1,
         3,
         {{tr("of its springs, motor, friction and stops"), &S::jointForce, &Theme::proxy}},
         0.01,
         false,
         StripKind::Of::Sliding},
        {"body-energy",
         tr("Body energy"),
         "mJ",
         1e3,
         3,
         {{tr("kinetic"), &S::kinetic, &Theme::proxy}, {tr("potential"), &S::potential, &Theme::finger}},
         0.1,
         false,
         StripKind::Of::Body},
    };
}

QString keyOf(const StripChart& chart) {
    return QStringLiteral("plot/") + QString::fromLatin1(chart.kind().id);
}

} // namespace

ForcePlot::ForcePlot(QWidget* parent)
    : QWidget(parent), caption_(new QLabel), export_(new QToolButton), pause_(new QToolButton) {
    setObjectName(QStringLiteral("force-plot"));
    setAccessibleName(tr("Force over time"));
    for (StripKind& kind : kinds())
        charts_.push_back(new StripChart(std::move(kind), history_));
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addLayout(makeBar());
    for (StripChart* chart : charts_) {
        column->addWidget(chart, 1);
        connect(chart, &StripChart::zoomed, this, [this](double factor) { setSpan(factor * time_.span); });
        connect(chart, &StripChart::pointed, this, [this](std::optional<double> t) {
            time_.cursor = t;
            refresh();
        });
    }
    time_.span = std::clamp(QSettings().value(QStringLiteral("plot/span"), time_.span).toDouble(), kMinSpan,
                            TouchHistory::kSpan);
    refreshIcons();
    refresh();
}

QLayout* ForcePlot::makeBar() {
    auto* bar = new QHBoxLayout;
    bar->setContentsMargins(kRhythm, kRhythm / 2, kRhythm, 0);
    bar->setSpacing(kRhythm / 2);
    auto* switches = new QToolBar;
    switches->setObjectName(QStringLiteral("plot-switches"));
    switches->layout()->setContentsMargins(0, 0, 0, 0);
    switches->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    for (StripChart* chart : charts_)
        switches_.push_back(addSwitch(*switches, *chart));
    bar->addWidget(switches, 1);
    caption_->setObjectName(QStringLiteral("plot-caption"));
    caption_->setProperty("dimmed", true);
    caption_->setFont(figureFont(-1));
    bar->addWidget(caption_);
    export_->setObjectName(QStringLiteral("plot-export"));
    export_->setToolTip(tr("Write what is seen as CSV, PNG or SVG"));
    export_->setAccessibleName(tr("Export the plot"));
    connect(export_, &QToolButton::clicked, this, &ForcePlot::exportRequested);
    pause_->setObjectName(QStringLiteral("plot-pause"));
    pause_->setCheckable(true);
    pause_->setToolTip(tr("Hold the chart still"));
    pause_->setAccessibleName(tr("Pause the force plot"));
    connect(pause_, &QToolButton::toggled, this, &ForcePlot::setPaused);
    for (QToolButton* button : {export_, pause_}) {
        button->setIconSize({16, 16});
        bar->addWidget(button);
    }
    return bar;
}

QAction* ForcePlot::addSwitch(QToolBar& bar, StripChart& chart) {
    QAction* action = bar.addAction(chart.kind().title);
    action->setToolTip(tr("Shows or hides this strip; the wheel over it changes the span of time"));
    action->setCheckable(true);
    QWidget* button = bar.widgetForAction(action);
    button->setObjectName(QStringLiteral("plot-") + QString::fromLatin1(chart.kind().id));
    button->setAccessibleName(tr("Show the plot: %1").arg(chart.kind().title));
    const bool first = charts_.front() == &chart;
    action->setChecked(QSettings().value(keyOf(chart), first).toBool());
    const bool has = offered_[std::size_t(chart.kind().of)];
    action->setVisible(has);
    chart.setVisible(has && action->isChecked());
    connect(action, &QAction::toggled, this, [this, &chart](bool on) {
        QSettings().setValue(keyOf(chart), on);
        chart.setVisible(on && offered_[std::size_t(chart.kind().of)]);
        refresh();
    });
    return action;
}

void ForcePlot::refreshIcons() {
    pause_->setIcon(icon(paused_ ? QStringLiteral("play") : QStringLiteral("pause"), theme().text));
    export_->setIcon(icon(QStringLiteral("export"), theme().text));
    if (auto* more = findChild<QToolButton*>(QStringLiteral("qt_toolbar_ext_button")))
        more->setIcon(icon(QStringLiteral("chevron-down"), theme().text));
}

void ForcePlot::changeEvent(QEvent* event) {
    if (event->type() == QEvent::PaletteChange) refreshIcons();
    QWidget::changeEvent(event);
}

void ForcePlot::take(const std::vector<TracePoint>& points, const HapticOutput& touch, double limit,
                     double proxyRate, const std::optional<BodyReading>& body, const QString& touched) {
    limit_ = std::max(limit, 0.1);
    if (paused_) return;
    offer(body);
    // The mouse rests on the glass, not on the curve.
    const double before = history_.end();
    history_.add(points, {&touch, proxyRate, body.value_or(BodyReading{}), touched.toStdString()});
    if (time_.cursor) *time_.cursor += history_.end() - before;
    if (!visibleRegion().isEmpty()) refresh(); // folded it would have the whole window drawn, frame by frame
}

/// Strips of a body only while one is selected that has them.
void ForcePlot::offer(const std::optional<BodyReading>& body) {
    const std::array<bool, 4> offered{true, body && body->turns, body && body->slides, body.has_value()};
    if (offered == offered_) return;
    offered_ = offered;
    for (std::size_t i = 0; i < charts_.size(); ++i) {
        const bool has = offered[std::size_t(charts_[i]->kind().of)];
        switches_[i]->setVisible(has);
        charts_[i]->setVisible(has && switches_[i]->isChecked());
    }
}

void ForcePlot::clear() {
    history_.clear();
    refresh();
}

void ForcePlot::setPaused(bool paused) {
    paused_ = paused;
    pause_->setChecked(paused);
    refreshIcons();
    refresh();
}

void ForcePlot::setSpan(double seconds) {
    time_.span = std::clamp(seconds, kMinSpan, TouchHistory::kSpan);
    QSettings().setValue(QStringLiteral("plot/span"), time_.span);
    refresh();
}

bool ForcePlot::isShown(const QString& id) const {
    return std::ranges::any_of(shown(), [&](StripChart* c) { return id == QLatin1String(c->kind().id); });
}

void ForcePlot::setShown(const QString& id, bool on) {
    for (std::size_t i = 0; i < charts_.size(); ++i)
        if (id == QLatin1String(charts_[i]->kind().id)) switches_[i]->setChecked(on);
}

std::vector<StripChart*> ForcePlot::shown() const {
    std::vector<StripChart*> list;
    for (std::size_t i = 0; i < charts_.size(); ++i)
        if (switches_[i]->isChecked()) list.push_back(charts_[i]);
    return list;
}

void ForcePlot::refresh() {
    const std::vector<StripChart*> seen = shown();
    for (StripChart* chart : seen) {
        StripTime time = time_;
        time.axis = chart == seen.back();
        chart->setMinimumHeight(chart->minimumSizeHint().height() + (time.axis ? kTimeAxis : 0));
        chart->show(time, limit_);
    }
    const int decimals = time_.span < 3 ? 1 : 0;
    QString text =
        seen.empty() ? tr("choose what to plot") : tr("last %1 s").arg(numberText(time_.span, decimals));
    if (time_.cursor)
        text = tr("at \u2212%1 s").arg(numberText(std::max(0.0, history_.end() - *time_.cursor), 3));
    // What is touched there: at the cursor, or at the newest end.
    const TouchSample* sample = history_.at(time_.cursor.value_or(history_.end()));
    if (sample && sample->touching && !history_.nameOf(*sample).empty())
        text = QStringLiteral("%1  %2").arg(QString::fromStdString(history_.nameOf(*sample)), text);
    if (paused_) text = tr("paused") + QStringLiteral("  ") + text;
    caption_->setText(text);
}

void ForcePlot::paintShown(QPainter& painter, const QSize& size) const {
    const std::vector<StripChart*> seen = shown();
    painter.setFont(figureFont(-1));
    const double each = double(size.height()) / double(std::max<std::size_t>(seen.size(), 1));
    for (std::size_t i = 0; i < seen.size(); ++i) {
        StripTime time = time_;
        time.cursor.reset();
        time.axis = i + 1 == seen.size();
        paintStrip(painter, QRectF(0, double(i) * each, size.width(), each), seen[i]->kind(), history_, time,
                   limit_);
    }
}

QImage ForcePlot::picture(QSize pixels, double scale) const {
    QImage image(pixels, QImage::Format_RGB32);
    image.fill(theme().panel);
    QPainter painter(&image);
    painter.scale(scale, scale); // a ratio of device pixels below 1 is none to Qt
    paintShown(painter, pixels / scale);
    return image;
}

Result<void> ForcePlot::exportTo(const QString& file) const {
    const std::filesystem::path path = file.toStdU16String();
    const QString ending = QFileInfo(file).suffix().toLower();
    if (ending == QLatin1String("csv"))
        return writeFileAtomically(path, csvOf(history_, history_.end() - time_.span), 0);
    const QSize size(kPictureWidth, kStripHeight * std::max(1, int(shown().size())));
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    if (ending == QLatin1String("svg")) {
        QSvgGenerator svg;
        svg.setOutputDevice(&buffer);
        svg.setSize(size);
        svg.setViewBox(QRect({0, 0}, size));
        svg.setTitle(tr("Touch over time"));
        QPainter painter(&svg);
        paintShown(painter, size);
    } else if (ending == QLatin1String("png")) {
        picture(size * kPictureScale, kPictureScale).save(&buffer, "PNG");
    } else {
        return inputError(file.toStdString() +
                          ": a plot is written as .csv, .png or .svg; choose one of them");
    }
    return writeFileAtomically(path, {bytes.constData(), std::size_t(bytes.size())}, 0);
}

} // namespace tactum
