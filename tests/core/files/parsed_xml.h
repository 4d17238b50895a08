// XML as a tree, for tests that look at what was written.
#pragma once

#include <functional>
#include <vector>

#include <QMap>
#include <QRegularExpression>
#include <QString>
#include <QXmlStreamReader>

#include "core/base/numbers.h"

namespace tactum::test {

struct Element {
    QString name;
    QMap<QString, QString> attributes;
    std::vector<Element> children;

    /// Itself and all below; of any name where none is wanted.
    std::vector<const Element*> all(const QString& wanted = {}) const {
        std::vector<const Element*> found;
        if (wanted.isEmpty() || name == wanted) found.push_back(this);
        for (const Element& child : children)
            for (const Element* element : child.all(wanted))
                found.push_back(element);
        return found;
    }
    const Element& one(const QString& wanted) const {
        const auto found = all(wanted);
        if (found.size() != 1) qFatal("not one %s but %zu", qPrintable(wanted), found.size());
        return *found[0];
    }
    double number(const QString& attribute) const {
        return *parseNumber(attributes[attribute].toStdString());
    }
    std::vector<double> numbers(const QString& attribute) const {
        std::vector<double> list;
        for (const QString& word :
             attributes[attribute].split(QRegularExpression("[ ,]+"), Qt::SkipEmptyParts))
            list.push_back(*parseNumber(word.toStdString()));
        return list;
    }
};

/// Fails the program on text that is not well formed.
inline Element parsed(const std::string& xml) {
    QXmlStreamReader reader(QByteArray::fromStdString(xml));
    Element root;
    const std::function<void(Element&)> read = [&](Element& element) {
        element.name = reader.name().toString();
        for (const auto& attribute : reader.attributes())
            element.attributes[attribute.name().toString()] = attribute.value().toString();
        while (reader.readNextStartElement())
            read(element.children.emplace_back());
    };
    if (reader.readNextStartElement()) read(root);
    while (!reader.atEnd())
        reader.readNext();
    if (reader.hasError()) qFatal("%s", qPrintable(reader.errorString()));
    return root;
}

} // namespace tactum::test
