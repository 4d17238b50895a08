// What a person prefers, brought to where it counts.
#pragma once

#include <QObject>

#include "ui/base/preferences.h"
#include "ui/base/style.h"
#include "ui/controllers/workbench.h"

namespace tactum {

class Journal;

/// Thread: ui.
class PreferenceController : public QObject {
    Q_OBJECT
public:
    PreferenceController(const Workbench& bench, Journal& journal);

signals:
    void themeChanged();

private:
    void connectTheme();
    void follow(Preferred id);
    void setTheme(ThemeChoice choice);

    Workbench bench_;
    Journal& journal_;
};

} // namespace tactum
