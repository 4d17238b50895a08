// The numbers of a moving world that are of no single body: gravity, scales. Thread: ui.
#pragma once

#include <vector>

#include <QWidget>

#include "ui/document/document.h"

namespace tactum {

class ParameterField;

class WorldFields : public QWidget {
    Q_OBJECT
public:
    explicit WorldFields(Document& document, QWidget* parent = nullptr);

private:
    using Value = double& (*)(Mechanics&, int);
    void add(const Parameter& parameter, int index, Value value);
    void refresh();

    struct Row {
        ParameterField* field;
        int index;
        Value value;
    };
    Document& document_;
    std::vector<Row> rows_;
};

} // namespace tactum
