// Holds JSON against a schema: as much of JSON Schema as the files of docs/schema use.
#pragma once

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

namespace test_program {

class JsonSchema {
public:
    explicit JsonSchema(const QByteArray& text) : root_(QJsonDocument::fromJson(text).object()) {}

    bool isThere() const { return !root_.isEmpty(); }
    /// Where it does not fit, and why; empty where it does.
    QString faultOf(const QJsonValue& value) const { return faultOf(value, root_, "$"); }

private:
    static bool isOfType(const QJsonValue& value, const QString& type) {
        if (type == "integer") return value.isDouble() && value.toDouble() == double(value.toInteger());
        return (type == "object" && value.isObject()) || (type == "array" && value.isArray()) ||
               (type == "string" && value.isString()) || (type == "number" && value.isDouble()) ||
               (type == "boolean" && value.isBool()) || (type == "null" && value.isNull());
    }

    QString faultOf(const QJsonValue& value, const QJsonObject& schema, const QString& where) const {
        if (schema.contains("$ref"))
            return faultOf(value, root_["$defs"][schema["$ref"].toString().section('/', -1)].toObject(),
                           where);
        if (schema.contains("oneOf")) {
            QString faults;
            for (const QJsonValue& each : schema["oneOf"].toArray()) {
                const QString fault = faultOf(value, each.toObject(), where);
                if (fault.isEmpty()) return {};
                faults += fault + "; ";
            }
            return faults;
        }
        const QJsonArray types =
            schema["type"].isArray() ? schema["type"].toArray() : QJsonArray{schema["type"]};
        const bool fits = !schema.contains("type") || std::ranges::any_of(types, [&](const QJsonValue& type) {
            return isOfType(value, type.toString());
        });
        if (!fits) return where + " is of another type";
        if (schema.contains("const") && value != schema["const"]) return where + " is another constant";
        if (schema.contains("enum") && !schema["enum"].toArray().contains(value))
            return where + " is an unknown word: " + value.toString();
        if (schema.contains("minimum") && value.toDouble() < schema["minimum"].toDouble())
            return where + " is too small";
        return value.isObject()  ? faultInside(value.toObject(), schema, where)
               : value.isArray() ? faultInside(value.toArray(), schema, where)
                                 : QString();
    }

    QString faultInside(const QJsonArray& values, const QJsonObject& schema, const QString& where) const {
        if (values.size() < schema["minItems"].toInt() || values.size() > schema["maxItems"].toInt(1 << 30))
            return where + " has another length";
        for (qsizetype i = 0; i < values.size(); ++i)
            if (const QString fault =
                    faultOf(values[i], schema["items"].toObject(), where + "[" + QString::number(i) + "]");
                !fault.isEmpty())
                return fault;
        return {};
    }

    QString faultInside(const QJsonObject& object, const QJsonObject& schema, const QString& where) const {
        for (const QJsonValue& key : schema["required"].toArray())
            if (!object.contains(key.toString())) return where + " lacks " + key.toString();
        const QJsonObject properties = schema["properties"].toObject();
        for (auto each = object.begin(); each != object.end(); ++each) {
            if (!properties.contains(each.key()) && !schema["additionalProperties"].isObject())
                return where + " has the unknown member " + each.key();
            const QJsonObject of = properties.contains(each.key())
                                       ? properties[each.key()].toObject()
                                       : schema["additionalProperties"].toObject();
            if (const QString fault = faultOf(each.value(), of, where + "." + each.key()); !fault.isEmpty())
                return fault;
        }
        return {};
    }

    QJsonObject root_;
};

} // namespace test_program
