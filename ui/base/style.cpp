#include "ui/base/style.h"

#include <algorithm>

#include <QApplication>
#include <QFile>
#include <QFontDatabase>
#include <QPainter>
#include <QPalette>
#include <QPixmapCache>
#include <QStyle>
#include <QStyleFactory>
#include <QSvgRenderer>
#include <QWidget>

#include "ui/base/mnemonics.h"
#include "ui/base/preferences.h"

// Outside of any namespace, as Qt asks: the resources live in a static library.
static void initIcons() {
    Q_INIT_RESOURCE(tactum);
}

namespace tactum {

namespace {

bool isDark = true;

bool systemIsDark() {
    static const bool dark = QApplication::palette().color(QPalette::Window).lightness() < 128;
    return dark;
}

QPalette paletteOf(const Theme& t) {
    QPalette p;
    p.setColor(QPalette::Window, t.window);
    p.setColor(QPalette::WindowText, t.text);
    p.setColor(QPalette::Base, t.field);
    p.setColor(QPalette::AlternateBase, t.panel);
    p.setColor(QPalette::Text, t.text);
    p.setColor(QPalette::PlaceholderText, t.textDimmed);
    p.setColor(QPalette::Button, t.panel);
    p.setColor(QPalette::ButtonText, t.text);
    p.setColor(QPalette::BrightText, t.fault);
    p.setColor(QPalette::Highlight, t.accent);
    p.setColor(QPalette::HighlightedText, t.accentText);
    p.setColor(QPalette::ToolTipBase, t.field);
    p.setColor(QPalette::ToolTipText, t.text);
    p.setColor(QPalette::Link, t.accent);
    for (auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText})
        p.setColor(QPalette::Disabled, role, t.textDimmed);
    return p;
}

/// Replaces the names of the table's colours in resources/style.qss by their values.
QString styleSheetOf(const Theme& t) {
    QFile file(QStringLiteral(":/style.qss"));
    if (!file.open(QIODevice::ReadOnly)) return {};
    QString sheet = QString::fromUtf8(file.readAll());
    const std::pair<const char*, QColor> colours[] = {
        {"@window", t.window},         {"@panel", t.panel},           {"@field", t.field},
        {"@border", t.border},         {"@textDimmed", t.textDimmed}, {"@text", t.text},
        {"@accentText", t.accentText}, {"@accent", t.accent},         {"@faultGround", t.faultGround},
        {"@fault", t.fault},
    };
    for (const auto& [name, colour] : colours)
        sheet.replace(QLatin1String(name), colour.name());
    return sheet;
}

QFont applicationFont() {
    QFont font = QApplication::font();
    // Open Sans has figures of one width; otherwise the desktop's own font serves.
    if (QFontDatabase::families().contains(QStringLiteral("Open Sans")))
        font.setFamily(QStringLiteral("Open Sans"));
    font.setPointSize(9);
    return font;
}

QByteArray source(const QString& name) {
    initIcons();
    QFile file(QStringLiteral(":/icons/%1.svg").arg(name));
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

/// Drawn once: every field with a number shows the same few, and asks again whenever a palette changes.
QPixmap drawn(const QString& name, const QColor& colour, int size) {
    const qreal ratio = qApp->devicePixelRatio();
    const QString tint = colour.isValid() ? colour.name() : QString();
    const QString key = QStringLiteral("icon %1 %2 %3 %4").arg(name, tint).arg(size).arg(ratio);
    QPixmap pixmap;
    if (QPixmapCache::find(key, &pixmap)) return pixmap;
    QByteArray tinted = source(name);
    if (colour.isValid()) tinted.replace("#000000", tint.toUtf8());
    QSvgRenderer renderer(tinted);
    pixmap = QPixmap(QSize(size, size) * ratio);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    renderer.render(&painter);
    painter.end();
    pixmap.setDevicePixelRatio(ratio);
    QPixmapCache::insert(key, pixmap);
    return pixmap;
}

} // namespace

ThemeChoice rememberedTheme() {
    return Preferences::instance().choice<ThemeChoice>(Preferred::Theme);
}

void applyTheme(ThemeChoice choice) {
    initIcons();
    const bool systemDark = systemIsDark(); // asked first of all, before our palette hides the answer
    isDark = choice == ThemeChoice::System ? systemDark : choice == ThemeChoice::Dark;
    QApplication::setStyle(QStyleFactory::create(QStringLiteral("Fusion")));
    QApplication::setFont(applicationFont());
    QApplication::setPalette(paletteOf(theme()));
    qApp->setStyleSheet(styleSheetOf(theme()));
    QApplication::setAttribute(Qt::AA_DontUseNativeDialogs);
    giveMnemonicsToDialogs();
}

WithoutStyleSheet::WithoutStyleSheet() : kept_(qApp->styleSheet()) {
    qApp->setStyleSheet({});
}

WithoutStyleSheet::~WithoutStyleSheet() {
    qApp->setStyleSheet(kept_);
}

const Theme& theme() {
    return themeFor(isDark);
}

QIcon icon(const QString& name) {
    QIcon result;
    for (int size : {16, 24}) {
        result.addPixmap(drawn(name, theme().text, size), QIcon::Normal, QIcon::Off);
        result.addPixmap(drawn(name, theme().accent, size), QIcon::Normal, QIcon::On);
        result.addPixmap(drawn(name, theme().textDimmed, size), QIcon::Disabled);
    }
    return result;
}

QIcon icon(const QString& name, const QColor& colour) {
    QIcon result;
    for (int size : {16, 24})
        result.addPixmap(drawn(name, colour, size));
    return result;
}

QPixmap logo(int size) {
    return drawn(QStringLiteral("tactum"), QColor(), size);
}

void repolish(QWidget& widget) {
    const auto again = [](QWidget& one) {
        one.style()->unpolish(&one);
        one.style()->polish(&one);
    };
    again(widget);
    for (auto* inside : widget.findChildren<QWidget*>())
        again(*inside);
}

QFont figureFont(int points) {
    QFont font = QApplication::font();
    font.setPointSize(font.pointSize() + points);
    return font;
}

} // namespace tactum
