// What a person decides once for the whole program, in one table: the dialog, the settings' keys, defaults
// and ranges follow from it.
#pragma once

#include <span>
#include <vector>

#include <QObject>

#include "core/surface/parameter.h"

namespace tactum {

/// In the order of the table.
enum class Preferred {
    DragTurns,
    TurnSpeed,
    ZoomSpeed,
    WheelAway,
    ZoomTo,
    Flight,
    Lag,
    Lengths,
    Stiffnesses,
    Theme,
    Size,
    Language,
    JournalTime,
    JournalEdits,
    LargestForce,
    Vibration
};

struct Preference {
    Preferred id;
    const char* page;                 ///< of the dialog; those of a page stand together
    Parameter parameter;              ///< its key is that of the settings; of a choice the place of it
    std::vector<const char*> choices; ///< none: a number
    bool atNextStart = false;         ///< what is open goes on without it
};
std::span<const Preference> preferenceTable();
const Preference& preference(Preferred id);

/// Which of the mouse's buttons turn and move the camera.
enum class DragTurns { MiddleTurns, MiddleMoves, RightTurns };
enum class WheelAway { Nearer, Farther };
enum class ZoomTo { Cursor, Middle };
enum class LanguageChoice { System, English, German };

/// One for the program. Values are kept in the person's settings. Thread: ui.
class Preferences : public QObject {
    Q_OBJECT
public:
    static Preferences& instance();

    /// In its range, whatever the settings hold; the default where they hold nothing.
    double value(Preferred id) const;
    template <typename Choice> Choice choice(Preferred id) const { return Choice(int(value(id))); }
    /// Brought into its range, kept, and told if it is another one than before.
    void set(Preferred id, double value);

signals:
    void changed(tactum::Preferred id);
};

} // namespace tactum
