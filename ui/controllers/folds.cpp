#include "ui/controllers/folds.h"

#include <QDockWidget>
#include <QEvent>
#include <QMainWindow>
#include <QTabBar>
#include <QToolButton>

#include "ui/base/style.h"
#include "ui/controllers/docks.h"

namespace tactum {

namespace {

constexpr int kLeastHeight = 80; // pixels: lower is no panel that was wanted so
const QString kButton = QStringLiteral("fold");

} // namespace

Folds::Folds(QMainWindow& window)
    : QObject(&window),
      window_(window), heights_{{Qt::BottomDockWidgetArea, 216}, {Qt::LeftDockWidgetArea, 360}} {
    window.installEventFilter(this); // Qt makes rows of tabs as it needs them
    for (auto* bar : window.findChildren<QTabBar*>(QString(), Qt::FindDirectChildrenOnly))
        adopt(*bar);
    for (auto* dock : window.findChildren<QDockWidget*>())
        connect(dock, &QDockWidget::dockLocationChanged, this, [this, dock] {
            dock->setMaximumHeight(QWIDGETSIZE_MAX); // among others now, which may not be folded
            showButtons();
        });
}

QList<QDockWidget*> Folds::together(QDockWidget& dock) const {
    return window_.tabifiedDockWidgets(&dock) << &dock;
}

/// What lies behind tabs keeps the size that it had when it was last in front.
QDockWidget& Folds::frontOf(QDockWidget& dock) const {
    QDockWidget* front = dockInFrontOf(window_, dock);
    return front ? *front : dock;
}

bool Folds::isFolded(const QDockWidget& dock) const {
    return dock.maximumHeight() == 0;
}

void Folds::setFolded(QDockWidget& dock, bool folded) {
    if (isFolded(dock) == folded) return;
    if (const int now = frontOf(dock).height(); folded && now >= kLeastHeight)
        heights_[window_.dockWidgetArea(&dock)] = now;
    fold(dock, folded);
}

void Folds::fold(QDockWidget& dock, bool folded) {
    if (isFolded(dock) == folded) return;
    for (QDockWidget* each : together(dock))
        each->setMaximumHeight(folded ? 0 : QWIDGETSIZE_MAX);
    if (!folded) // once it is known which one is in front
        QMetaObject::invokeMethod(
            &dock,
            [this, &dock] {
                QDockWidget& front = frontOf(dock);
                const QTabBar* bar = tabsOf(window_, front); // which resizeDocks() counts
                const int height = heights_[window_.dockWidgetArea(&front)] + (bar ? bar->height() : 0);
                window_.resizeDocks({&front}, {height}, Qt::Vertical);
            },
            Qt::QueuedConnection);
    showButtons();
    emit changed();
}

void Folds::bringForward(QDockWidget& dock) {
    dock.show();
    dock.raise();
    setFolded(dock, false);
}

QStringList Folds::names() const {
    QStringList names;
    for (const auto* dock : window_.findChildren<QDockWidget*>())
        if (isFolded(*dock)) names << dock->objectName();
    return names;
}

void Folds::restore(const QStringList& names) {
    for (auto* dock : window_.findChildren<QDockWidget*>())
        fold(*dock, names.contains(dock->objectName()));
}

bool Folds::eventFilter(QObject* watched, QEvent* event) {
    auto* child = event->type() == QEvent::ChildPolished && watched == &window_
                      ? static_cast<QChildEvent*>(event)->child()
                      : nullptr;
    if (auto* bar = qobject_cast<QTabBar*>(child)) adopt(*bar);
    if (event->type() == QEvent::Resize || event->type() == QEvent::LayoutRequest)
        if (auto* bar = qobject_cast<QTabBar*>(watched)) showButton(*bar);
    return QObject::eventFilter(watched, event);
}

void Folds::adopt(QTabBar& bar) {
    if (bar.findChild<QToolButton*>(kButton)) return;
    auto* button = new QToolButton(&bar);
    button->setObjectName(kButton);
    button->setAutoRaise(true);
    button->setFocusPolicy(Qt::TabFocus);
    connect(button, &QToolButton::clicked, this, [this, &bar] {
        if (QDockWidget* dock = dockOf(window_, bar, bar.currentIndex())) decide(dock, !isFolded(*dock));
    });
    connect(&bar, &QTabBar::tabBarClicked, this,
            [this, &bar](int tab) { decide(dockOf(window_, bar, tab), false); });
    bar.installEventFilter(this);
    showButton(bar);
}

void Folds::decide(QDockWidget* dock, bool folded) {
    if (!dock || isFolded(*dock) == folded) return;
    setFolded(*dock, folded);
    emit decided();
}

/// At the right end of its row, where there is something to gain.
void Folds::showButton(QTabBar& bar) {
    bar.setFocusPolicy(bar.count() ? Qt::TabFocus : Qt::NoFocus); // Qt keeps an empty one out of sight
    auto* button = bar.findChild<QToolButton*>(kButton);
    const QDockWidget* dock = dockOf(window_, bar, bar.currentIndex());
    button->setVisible(dock && heights_.contains(window_.dockWidgetArea(const_cast<QDockWidget*>(dock))));
    if (!dock) return;
    const bool folded = isFolded(*dock);
    // An icon asks for a layout, which calls this: where it stays the same it is not given again, or no
    // window would rest.
    const QString looks = QStringLiteral("%1 %2").arg(folded).arg(theme().dark);
    if (button->property("looks") != looks) {
        button->setProperty("looks", looks);
        button->setIcon(icon(folded ? QStringLiteral("chevron-up") : QStringLiteral("chevron-down")));
        button->setToolTip(folded ? tr("Unfold these panels")
                                  : tr("Fold these panels, so that the view has their room"));
        button->setAccessibleName(button->toolTip());
    }
    const int side = bar.height();
    button->setGeometry(bar.width() - side, 0, side, side);
    button->raise();
}

void Folds::showButtons() {
    for (auto* bar : window_.findChildren<QTabBar*>(QString(), Qt::FindDirectChildrenOnly))
        if (bar->findChild<QToolButton*>(kButton)) showButton(*bar);
}

} // namespace tactum
