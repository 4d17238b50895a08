#include "ui/widgets/text_lines.h"

#include <QFontMetrics>
#include <QTextLayout>

namespace tactum {

QStringList linesOf(const QString& text, const QFont& font, int width, int most) {
    QTextLayout layout(text, font);
    QTextOption broken;
    broken.setWrapMode(QTextOption::WrapAtWordBoundaryOrAnywhere);
    layout.setTextOption(broken);
    QStringList lines;
    layout.beginLayout();
    for (QTextLine line = layout.createLine(); line.isValid(); line = layout.createLine()) {
        line.setLineWidth(width);
        if (lines.size() + 1 < most) {
            lines << text.mid(line.textStart(), line.textLength());
            continue;
        }
        lines << QFontMetrics(font).elidedText(text.mid(line.textStart()), Qt::ElideRight, width);
        break;
    }
    layout.endLayout();
    return lines;
}

} // namespace tactum
