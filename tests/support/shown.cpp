#include "tests/support/shown.h"

#include <map>
#include <memory>

#include <QAction>
#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QDialog>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QMetaProperty>
#include <QPaintEngine>
#include <QPainter>
#include <QPainterPath>
#include <QProgressBar>
#include <QPushButton>
#include <QScrollArea>
#include <QSlider>
#include <QStackedWidget>
#include <QToolButton>
#include <QTreeWidget>
#include <QUndoView>

#include "ui/base/style.h"

namespace tactum::test {
namespace {

QString quoted(QString text) {
    return u'"' + text.replace(u'\\', QStringLiteral("\\\\")).replace(u'\n', QStringLiteral("\\n")) + u'"';
}

/// A widget of the kind as it comes.
const QWidget* usual(const QMetaObject* kind) {
    using Make = std::function<QWidget*()>;
    static const std::map<QByteArray, Make> makers{
        {"QLabel", [] { return new QLabel; }},
        {"QPushButton", [] { return new QPushButton; }},
        {"QToolButton", [] { return new QToolButton; }},
        {"QCheckBox", [] { return new QCheckBox; }},
        {"QComboBox", [] { return new QComboBox; }},
        {"QLineEdit", [] { return new QLineEdit; }},
        {"QProgressBar", [] { return new QProgressBar; }},
        {"QDoubleSpinBox", [] { return new QDoubleSpinBox; }},
        {"QSlider", [] { return new QSlider; }},
        {"QTreeWidget", [] { return new QTreeWidget; }},
        {"QUndoView", [] { return new QUndoView; }},
        {"QScrollArea", [] { return new QScrollArea; }},
        {"QFrame", [] { return new QFrame; }},
        {"QDialog", [] { return new QDialog; }},
        {"QDialogButtonBox", [] { return new QDialogButtonBox; }},
        {"QStackedWidget", [] { return new QStackedWidget; }},
        {"QWidget", [] { return new QWidget; }},
    };
    static std::map<QByteArray, std::unique_ptr<QWidget>> made;
    while (!makers.contains(kind->className()))
        kind = kind->superClass();
    auto& widget = made[kind->className()];
    if (!widget) widget.reset(makers.at(kind->className())());
    return widget.get();
}

/// Nothing for what says nothing to a person, or differs from one screen to the next.
std::optional<QString> wordOf(const QVariant& value, const QMetaProperty& property) {
    if (property.isFlagType()) return QString::fromLatin1(property.enumerator().valueToKeys(value.toInt()));
    if (property.isEnumType()) return QString::fromLatin1(property.enumerator().valueToKey(value.toInt()));
    switch (value.typeId()) {
    case QMetaType::QString:
        return quoted(value.toString());
    case QMetaType::Bool:
    case QMetaType::Int:
    case QMetaType::UInt:
    case QMetaType::Double:
        return value.toString();
    case QMetaType::QKeySequence:
        return value.value<QKeySequence>().toString(QKeySequence::PortableText);
    case QMetaType::QIcon:
        return value.value<QIcon>().isNull() ? QStringLiteral("none") : QStringLiteral("there");
    case QMetaType::QSize:
        return QStringLiteral("%1x%2").arg(value.toSize().width()).arg(value.toSize().height());
    case QMetaType::QSizePolicy: {
        const auto policy = value.value<QSizePolicy>();
        const auto name = QMetaEnum::fromType<QSizePolicy::Policy>();
        return QStringLiteral("%1/%2%3").arg(QLatin1String(name.valueToKey(policy.horizontalPolicy())),
                                             QLatin1String(name.valueToKey(policy.verticalPolicy())),
                                             policy.retainSizeWhenHidden() ? QStringLiteral("/retained")
                                                                           : QString());
    }
    case QMetaType::QPixmap: {
        const auto pixmap = value.value<QPixmap>();
        return pixmap.isNull() ? QStringLiteral("none")
                               : QStringLiteral("%1x%2").arg(pixmap.width()).arg(pixmap.height());
    }
    default:
        return std::nullopt;
    }
}

bool isLeftOut(const QByteArray& name) {
    static const QList<QByteArray> names{"objectName",
                                         "geometry",
                                         "frameGeometry",
                                         "normalGeometry",
                                         "x",
                                         "y",
                                         "pos",
                                         "frameSize",
                                         "size",
                                         "width",
                                         "height",
                                         "rect",
                                         "childrenRect",
                                         "childrenRegion",
                                         "isActiveWindow",
                                         "focus",
                                         "sizeHint",
                                         "palette",
                                         "font",
                                         "minimumSizeHint",
                                         "updatesEnabled",
                                         "fullScreen",
                                         "maximized",
                                         "minimized",
                                         "windowIcon",
                                         "locale",
                                         "visible",
                                         "enabled",
                                         "frameRect",
                                         "frameWidth",
                                         "styleSheet",
                                         "cursorPosition",
                                         "displayText",
                                         "selectedText",
                                         "undoAvailable",
                                         "redoAvailable",
                                         "cleanText",
                                         "acceptableInput",
                                         "sliderPosition",
                                         "windowModified",
                                         "minimumSize",
                                         "maximumSize",
                                         "baseSize",
                                         "modified",
                                         "hasSelectedText",
                                         "currentText",
                                         "currentData",
                                         "count",
                                         "down",
                                         "inputMask",
                                         "layoutDirection",
                                         "text",
                                         "frameStyle"};
    return names.contains(name);
}

QString stateOf(const QWidget& widget) {
    QStringList words;
    const auto add = [&](const QString& name, const QString& value) { words << name + u'=' + value; };
    const QWidget& plain = *usual(widget.metaObject());
    const QMetaObject& kind = *plain.metaObject();
    // What it says comes first.
    const QVariant text = widget.property("text");
    if (text.isValid() && !text.toString().isEmpty()) words << quoted(text.toString());
    if (widget.isHidden() && !widget.isWindow()) words << QStringLiteral("hidden");
    if (!(widget.parentWidget() ? widget.isEnabledTo(widget.parentWidget()) : widget.isEnabled()))
        words << QStringLiteral("disabled");
    for (int i = 0; i < kind.propertyCount(); ++i) {
        const QMetaProperty property = kind.property(i);
        if (!property.isReadable() || isLeftOut(property.name())) continue;
        // Every button that was drawn once in a style follows the mouse.
        const bool isButton =
            qobject_cast<const QAbstractButton*>(&widget) || qobject_cast<const QMenu*>(&widget);
        if (isButton && qstrcmp(property.name(), "mouseTracking") == 0) continue;
        // The layout of a window sets them, by its font.
        if (widget.isWindow() && widget.layout() && QByteArray(property.name()).startsWith("minimum"))
            continue;
        const auto now = wordOf(property.read(&widget), property),
                   before = wordOf(property.read(&plain), property);
        if (now && now != before) add(QLatin1String(property.name()), *now);
    }
    if (const auto shape = widget.cursor().shape(); widget.testAttribute(Qt::WA_SetCursor))
        add(QStringLiteral("cursor"), QString::number(int(shape)));
    const int points = widget.font().pointSize() - QApplication::font().pointSize();
    if (points != 0) add(QStringLiteral("points"), QString::number(points));
    for (const auto& [attribute, name] : {std::pair(Qt::WA_StyledBackground, "styled"),
                                          std::pair(Qt::WA_DeleteOnClose, "goes when it is closed")})
        if (widget.testAttribute(attribute)) words << QLatin1String(name);
    for (const QByteArray& name : widget.dynamicPropertyNames())
        if (!name.startsWith("_q_")) add(u'.' + QString::fromLatin1(name), widget.property(name).toString());
    if (const auto* label = qobject_cast<const QLabel*>(&widget); label && label->buddy())
        add(QStringLiteral("buddy"), label->buddy()->objectName());
    if (const auto* button = qobject_cast<const QToolButton*>(&widget); button && button->defaultAction())
        add(QStringLiteral("action"), button->defaultAction()->objectName());
    return words.join(u' ');
}

QString layoutOf(const QLayout& layout) {
    QStringList items;
    const auto* box = qobject_cast<const QBoxLayout*>(&layout);
    const auto* grid = qobject_cast<const QGridLayout*>(&layout);
    for (int i = 0; i < layout.count(); ++i) {
        QLayoutItem* item = layout.itemAt(i);
        QString text = item->layout()   ? layoutOf(*item->layout())
                       : item->widget() ? item->widget()->objectName()
                                        : QStringLiteral("space");
        if (text.isEmpty()) text = QStringLiteral("-");
        if (box && box->stretch(i) != 0) text += QStringLiteral(" x%1").arg(box->stretch(i));
        if (item->alignment())
            text += u' ' + QString::fromLatin1(
                               QMetaEnum::fromType<Qt::Alignment>().valueToKeys(int(item->alignment())));
        if (grid) {
            int row = 0, column = 0, rows = 0, columns = 0;
            const_cast<QGridLayout*>(grid)->getItemPosition(i, &row, &column, &rows, &columns);
            text += QStringLiteral(" @%1,%2 %3x%4").arg(row).arg(column).arg(rows).arg(columns);
        }
        items << text;
    }
    QString stretches;
    for (int i = 0; grid && i < grid->columnCount(); ++i)
        stretches +=
            QStringLiteral("%1%2").arg(i ? QStringLiteral(" ") : QString()).arg(grid->columnStretch(i));
    const QString inside = items.join(QStringLiteral(", "));
    if (grid) return QStringLiteral("grid(%1){%2}").arg(stretches, inside);
    if (!box) return QStringLiteral("{%1}").arg(inside);
    return (box->direction() == QBoxLayout::TopToBottom ? QStringLiteral("column{%1}")
                                                        : QStringLiteral("row{%1}"))
        .arg(inside);
}

QString actionOf(const QAction& action) {
    if (action.isSeparator()) return QStringLiteral("separator");
    QString text = action.objectName().isEmpty() ? QString() : action.objectName() + u' ';
    text += quoted(action.text());
    if (!action.isEnabled()) text += QStringLiteral(" disabled");
    if (!action.isVisible()) text += QStringLiteral(" hidden");
    if (action.isCheckable()) text += action.isChecked() ? QStringLiteral(" on") : QStringLiteral(" off");
    if (!action.icon().isNull()) text += QStringLiteral(" icon");
    for (const QKeySequence& keys : action.shortcuts())
        text += QStringLiteral(" [%1]").arg(keys.toString(QKeySequence::PortableText));
    if (!action.shortcuts().isEmpty() && action.shortcutContext() != Qt::WindowShortcut)
        text += QStringLiteral(" context %1").arg(int(action.shortcutContext()));
    if (!action.statusTip().isEmpty()) text += u' ' + quoted(action.statusTip());
    return text;
}

void addRows(QStringList& lines, const QTreeWidget& tree, const QTreeWidgetItem& item,
             const QString& indent) {
    QString line = indent + (item.isSelected() ? u'*' : u'-') +
                   (&item == tree.currentItem() ? QStringLiteral(">") : QString());
    for (int column = 0; column < tree.columnCount(); ++column) {
        line += QStringLiteral(" | ") + quoted(item.text(column));
        if (!item.icon(column).isNull()) line += QStringLiteral(" icon");
        if (!item.toolTip(column).isEmpty()) line += QStringLiteral(" tip ") + quoted(item.toolTip(column));
        for (const int role : {int(Qt::AccessibleTextRole), int(Qt::AccessibleDescriptionRole),
                               int(Qt::UserRole), int(Qt::UserRole) + 1, int(Qt::UserRole) + 2})
            if (const QVariant data = item.data(column, role); data.isValid() && data.canConvert<QString>())
                line += QStringLiteral(" %1:%2").arg(role).arg(quoted(data.toString()));
        if (const QVariant brush = item.data(column, Qt::ForegroundRole); brush.isValid())
            line += QStringLiteral(" coloured");
    }
    if (item.flags() & Qt::ItemIsEditable) line += QStringLiteral(" editable");
    if (item.isHidden()) line += QStringLiteral(" hidden");
    lines << line;
    for (int i = 0; i < item.childCount(); ++i)
        addRows(lines, tree, *item.child(i), indent + QStringLiteral("  "));
}

void addLines(QStringList& lines, const QWidget& widget, const QString& indent) {
    QString kind = QString::fromLatin1(widget.metaObject()->className()).remove(QStringLiteral("tactum::"));
    const bool isQts = widget.objectName().startsWith(QStringLiteral("qt_"));
    QString line = indent + kind;
    if (!widget.objectName().isEmpty() && !isQts) line += u' ' + widget.objectName();
    if (const QString state = stateOf(widget); !state.isEmpty() && !isQts)
        line += QStringLiteral(": ") + state;
    lines << line;
    const QString deeper = indent + QStringLiteral("  ");
    if (const QLayout* layout = widget.layout(); layout && !isQts) lines << deeper + layoutOf(*layout);
    if (const auto* list = qobject_cast<const QComboBox*>(&widget))
        for (int i = 0; i < list->count(); ++i)
            lines << deeper + (i == list->currentIndex() ? u'>' : u'-') + u' ' + quoted(list->itemText(i)) +
                         (list->itemData(i, Qt::ToolTipRole).isValid()
                              ? u' ' + quoted(list->itemData(i, Qt::ToolTipRole).toString())
                              : QString());
    if (const auto* tree = qobject_cast<const QTreeWidget*>(&widget)) {
        for (int column = 0; column < tree->columnCount(); ++column) {
            const auto mode = tree->header()->sectionResizeMode(column);
            lines << deeper + QStringLiteral("column %1 mode %2").arg(column).arg(int(mode)) +
                         (mode == QHeaderView::Fixed
                              ? QStringLiteral(" width %1").arg(tree->header()->sectionSize(column))
                              : QString());
        }
        for (int i = 0; i < tree->topLevelItemCount(); ++i)
            addRows(lines, *tree, *tree->topLevelItem(i), deeper);
    }
    if (!isQts && !qobject_cast<const QLineEdit*>(&widget))
        for (const QAction* action : widget.actions())
            lines << deeper + QStringLiteral("action ") + actionOf(*action);
    if (qobject_cast<const QComboBox*>(&widget) || qobject_cast<const QAbstractSpinBox*>(&widget) ||
        qobject_cast<const QLineEdit*>(&widget))
        return; // what Qt puts into them
    for (const QObject* child : widget.children()) {
        const auto* inside = qobject_cast<const QWidget*>(child);
        if (!inside || qobject_cast<const QHeaderView*>(child) ||
            child->inherits("QAbstractScrollAreaScrollBarContainer") || child->inherits("QScrollBar"))
            continue;
        if (inside->isWindow() && !qobject_cast<const QMenu*>(inside)) continue;
        if (const QByteArray name = child->objectName().toLatin1();
            name == "qt_scrollarea_hcontainer" || name == "qt_scrollarea_vcontainer")
            continue;
        addLines(lines, *inside, deeper);
    }
}

/// The theme's name of a colour.
QString colourOf(const QColor& colour) {
    const Theme& t = theme();
    const std::pair<const char*, QColor> names[] = {{"text", t.text},           {"dimmed", t.textDimmed},
                                                    {"accent", t.accent},       {"accentText", t.accentText},
                                                    {"panel", t.panel},         {"field", t.field},
                                                    {"window", t.window},       {"fault", t.fault},
                                                    {"finger", t.finger},       {"proxy", t.proxy},
                                                    {"contact", t.contact},     {"stick", t.stick},
                                                    {"slip", t.slip},           {"border", t.border},
                                                    {"grid", t.plotGrid},       {"label", t.label},
                                                    {"labelText", t.labelText}, {"axisX", t.axisX},
                                                    {"axisY", t.axisY},         {"axisZ", t.axisZ}};
    QColor opaque = colour;
    opaque.setAlpha(255);
    for (const auto& [name, of] : names)
        if (of == colour) return QLatin1String(name);
    for (const auto& [name, of] : names)
        if (of == opaque)
            return QLatin1String(name) + QStringLiteral(" %1%").arg(qRound(100 * colour.alphaF()));
    return colour.name(QColor::HexArgb);
}

QString pixels(double value) {
    const QString text = QString::number(value, 'f', 1);
    return text == QLatin1String("-0.0") ? QStringLiteral("0.0") : text;
}

class NotingEngine final : public QPaintEngine {
public:
    NotingEngine() : QPaintEngine(AllFeatures) {}
    QStringList lines;

    bool begin(QPaintDevice*) override { return true; }
    bool end() override { return true; }
    Type type() const override { return User; }
    void updateState(const QPaintEngineState& now) override {
        const auto what = now.state();
        if (what & DirtyPen) pen_ = now.pen();
        if (what & DirtyBrush) brush_ = now.brush();
        if (what & DirtyTransform) transform_ = now.transform();
        if (what & DirtyOpacity) opacity_ = now.opacity();
    }
    void drawLines(const QLineF* line, int count) override {
        for (int i = 0; i < count; ++i)
            note(QStringLiteral("line"), {line[i].p1(), line[i].p2()}, true, false);
    }
    void drawRects(const QRectF* rect, int count) override {
        for (int i = 0; i < count; ++i)
            note(QStringLiteral("rect"), {rect[i].topLeft(), rect[i].bottomRight()}, true, true);
    }
    void drawEllipse(const QRectF& rect) override {
        note(QStringLiteral("ellipse"), {rect.topLeft(), rect.bottomRight()}, true, true);
    }
    void drawPath(const QPainterPath& path) override {
        const QRectF bounds = path.boundingRect();
        note(QStringLiteral("shape"), {bounds.topLeft(), bounds.bottomRight()}, true, true);
    }
    void drawPolygon(const QPointF* points, int count, PolygonDrawMode mode) override {
        note(mode == PolylineMode ? QStringLiteral("curve") : QStringLiteral("polygon"),
             QList<QPointF>(points, points + count), true, mode != PolylineMode);
    }
    void drawPoints(const QPointF* points, int count) override {
        note(QStringLiteral("points"), QList<QPointF>(points, points + count), true, false);
    }
    void drawPixmap(const QRectF& rect, const QPixmap&, const QRectF&) override {
        note(QStringLiteral("picture"), {rect.topLeft(), rect.bottomRight()}, false, false);
    }
    void drawImage(const QRectF& rect, const QImage&, const QRectF&, Qt::ImageConversionFlags) override {
        note(QStringLiteral("picture"), {rect.topLeft(), rect.bottomRight()}, false, false);
    }
    void drawTextItem(const QPointF& at, const QTextItem& item) override {
        lines << QStringLiteral("%1 %2").arg(quoted(item.text()), colourOf(pen_.color())) + placeOf(at) +
                     faded();
    }

private:
    QString placeOf(const QPointF& point) const {
        const QPointF p = transform_.map(point);
        return QStringLiteral(" (%1 %2)").arg(pixels(p.x()), pixels(p.y()));
    }
    QString faded() const { return opacity_ < 1 ? QStringLiteral(" opacity %1").arg(opacity_) : QString(); }
    /// Of long curves every so many points, and the corners of the box around all.
    void note(const QString& what, QList<QPointF> points, bool stroked, bool filled) {
        QString line = what;
        if (stroked && pen_.style() != Qt::NoPen)
            line += QStringLiteral(" %1 %2%3")
                        .arg(colourOf(pen_.color()))
                        .arg(pen_.widthF())
                        .arg(pen_.style() == Qt::SolidLine ? QString() : QStringLiteral(" dashed"));
        if (filled && brush_.style() != Qt::NoBrush)
            line += QStringLiteral(" filled %1").arg(colourOf(brush_.color()));
        constexpr qsizetype kMany = 12;
        if (points.size() > kMany) {
            const QRectF bounds = QPolygonF(points).boundingRect();
            line += QStringLiteral(" %1 in%2%3")
                        .arg(points.size())
                        .arg(placeOf(bounds.topLeft()), placeOf(bounds.bottomRight()));
            QList<QPointF> few;
            for (qsizetype i = 0; i < kMany; ++i)
                few << points[i * (points.size() - 1) / (kMany - 1)];
            points = few;
            line += QStringLiteral(" by");
        }
        for (const QPointF& point : points)
            line += placeOf(point);
        lines << line + faded();
    }

    QPen pen_;
    QBrush brush_;
    QTransform transform_;
    double opacity_ = 1;
};

class NotingDevice final : public QPaintDevice {
public:
    explicit NotingDevice(QSize size) : size_(size) {}
    QPaintEngine* paintEngine() const override { return &engine_; }
    mutable NotingEngine engine_;

protected:
    int metric(PaintDeviceMetric what) const override {
        switch (what) {
        case PdmWidth:
            return size_.width();
        case PdmHeight:
            return size_.height();
        case PdmWidthMM:
            return int(size_.width() * 25.4 / 96);
        case PdmHeightMM:
            return int(size_.height() * 25.4 / 96);
        case PdmNumColors:
            return 1 << 24;
        case PdmDepth:
            return 32;
        case PdmDpiX:
        case PdmDpiY:
        case PdmPhysicalDpiX:
        case PdmPhysicalDpiY:
            return 96;
        case PdmDevicePixelRatio:
            return 1;
        case PdmDevicePixelRatioScaled:
            return int(devicePixelRatioFScale());
        }
        return 0;
    }

private:
    QSize size_;
};

} // namespace

QString shownIn(const QWidget& widget) {
    QStringList lines;
    addLines(lines, widget, {});
    return lines.join(u'\n') + u'\n';
}

QString drawnBy(QWidget& widget) {
    NotingDevice device(widget.size());
    widget.render(&device, QPoint(), QRegion(), QWidget::RenderFlags());
    return device.engine_.lines.join(u'\n') + u'\n';
}

QString drawnBy(QSize size, const std::function<void(QPainter&)>& paint) {
    NotingDevice device(size);
    QPainter painter(&device);
    paint(painter);
    painter.end();
    return device.engine_.lines.join(u'\n') + u'\n';
}

} // namespace tactum::test
