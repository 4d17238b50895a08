// What a self-test found: what is wrong, the figures, and what can be done with them.
#pragma once

#include <QWidget>

#include "core/self_test/self_test.h"

class QLabel;
class QPushButton;
class QTreeWidget;

namespace tactum {

class SelfTestResult : public QWidget {
    Q_OBJECT
public:
    explicit SelfTestResult(QWidget* parent = nullptr);

    void show(const SelfTestReport& report);
    /// A sentence of what became of it.
    void tell(const QString& words, bool wrong = false);

signals:
    void keepPressed();
    void showPressed();
    void savePressed();
    void closePressed();

private:
    QWidget* makeButtons();

    QLabel *verdict_, *found_, *told_;
    QTreeWidget* figures_;
    QPushButton* keep_ = nullptr;
};

} // namespace tactum
