#include "ui/shortcuts.h"

#include <QMenu>
#include <QMenuBar>

#include "ui/style.h"

namespace tactum {

namespace {

constexpr Command kCommands[] = {
    {"open", "File", "&Open...", "Ctrl+O", "open", "Open a scene, a model or a recording"},
    {"save", "File", "&Save", "Ctrl+S", "save", "Write the scene with all its surfaces as glTF (.glb)", false,
     true},
    {"save-as", "File", "Save &as...", "Ctrl+Shift+S", "",
     "Write the scene under another name, and go on with that"},
    {"export", "File", "&Export a bundle...", "Ctrl+E", "export",
     "One zip for other programs: glTF, X3D for H3D, images, a finger path with its forces, a report", false,
     true},
    {"save-picture", "File", "Save &picture...", "", "picture", "Write the view as a PNG file", false, true},
    {"save-recording", "File", "Save &recording of the last minute...", "Ctrl+Shift+R", "record",
     "Everything that was touched and felt in the last minute, to be played again bit for bit", false, true},
    {"quit", "File", "&Quit", "Ctrl+Q", "", "Forces off, and out", false, true},
    {"undo", "Edit", "&Undo", "Ctrl+Z", "undo", "Take the last edit back"},
    {"redo", "Edit", "&Redo", "Ctrl+Shift+Z; Ctrl+Y", "redo", "Do the last undone edit again"},
    {"remove", "Edit", "Re&move object", "Ctrl+Del", "remove", "Take the object out of the scene", false,
     true},
    {"palette", "Edit", "&Find a command...", "Ctrl+Shift+P", "", "Every command by a few letters of it",
     false, true},
    {"hide", "Surface", "&Hide", "H", "eye-off",
     "The selected surfaces are neither seen nor felt until they are shown again"},
    {"isolate", "Surface", "Show &alone", "/", "", "Hide everything but the selected surfaces"},
    {"show-all", "Surface", "&Show all", "Alt+H", "eye", "Show every object and every surface"},
    {"lock", "Surface", "&Lock", "L", "lock",
     "No edit changes how the selected surfaces feel or which triangles they have; the same unlocks"},
    {"split", "Surface", "S&plit off", "P", "split", "The selected triangles become a surface of their own",
     false, true},
    {"merge", "Surface", "&Merge", "Ctrl+J", "merge",
     "The selected surfaces of one object become one, which feels like the one selected last"},
    {"touch", "Tools", "&Touch", "W", "touch", "Touch: drag on the model to lead the finger", true},
    {"select", "Tools", "&Select", "Q", "select", "Select: click a surface to see and set how it feels",
     true},
    {"fit", "View", "&Frame all", "Home; F", "fit", "Show the whole scene"},
    {"view-front", "View", "F&ront", "Num+1; Ctrl+1", "view-front", "Look from the front"},
    {"view-right", "View", "R&ight", "Num+3; Ctrl+3", "view-right", "Look from the right"},
    {"view-top", "View", "&Top", "Num+7; Ctrl+7", "view-top", "Look from above"},
    {"view-isometric", "View", "Is&ometric", "Num+0; Ctrl+0", "view-isometric",
     "Look from the corner between them"},
    {"overlay", "View", "Finger and f&orces", "Ctrl+T", "overlay", "Show finger, proxy, force and contacts",
     true, true},
    {"panels", "View", "&Hide all panels", "F9", "",
     "The view alone; Tab does the same while the view has the focus", true},
    {"next-panel", "View", "&Next panel", "F6", "", "Give the keys to the next panel", false, true},
    {"previous-panel", "View", "Pre&vious panel", "Shift+F6", "", "Give the keys to the panel before"},
    {"armed", "Device", "&Forces on", "Ctrl+Return", "power",
     "Let the device push. It starts without force and follows", true},
    {"stop", "Device", "&Stop", "", "stop", "Forces off at once; also hold Esc for half a second"},
    {"dead-man", "Device", "Hold the &button to feel", "", "",
     "Force only while a button of the device is held. Of the simulated hand: while the mouse holds the "
     "finger",
     true},
    {"restart-proxy", "Device", "&Put the proxy on the finger", "Ctrl+R", "",
     "Frees a proxy that is on the wrong side of a surface", false, true},
    {"record-stroke", "Compare", "&Record a stroke", "Ctrl+Shift+K", "",
     "Remember what the finger does until it is chosen again", true},
    {"take-stroke", "Compare", "&Take the last 10 s", "", "",
     "The stroke is what the finger did in the last ten seconds"},
    {"mark-a", "Compare", "&Mark as A", "Ctrl+Shift+A", "",
     "The scene as it is now is what edits are held against", false, true},
    {"swap-ab", "Compare", "&Swap A and B", "Ctrl+Shift+X", "",
     "The scene becomes A again, and A what the scene was"},
    {"compare-now", "Compare", "&Compare now", "Ctrl+Shift+C", "", "The stroke is felt in A and in the scene",
     false, true},
    {"compare-auto", "Compare", "After &each edit", "", "", "Each edit is compared with A at once", true},
    {"compare-csv", "Compare", "E&xport CSV...", "", "", "Both forces of each step of the stroke", false,
     true},
    {"keyboard", "Help", "&Keyboard", "F1", "keyboard", "All keys on one page"},
    {"about", "Help", "&About Tactum", "", "", "Version and licence"},
};

constexpr Manner kManners[] = {
    {"Drag on the model", "press the finger into the surface and stroke it (touch tool)"},
    {"Drag the finger", "move it in the plane of the camera"},
    {"Wheel, Ctrl+drag while touching", "move the finger along the view"},
    {"G", "the finger follows the mouse until a click or Esc"},
    {"Arrows, Page Up, Page Down", "nudge the finger"},
    {"Middle drag, Alt+drag", "orbit; with Shift pan"},
    {"Wheel", "zoom to the cursor"},
    {"Tab in the view", "hide or show all panels"},
    {"Space, Left, Right", "in a recording: play or pause, a hundredth of a second back or on"},
    {"Hold Esc for half a second", "forces off"},
};

QList<QKeySequence> keysOf(const Command& command) {
    QList<QKeySequence> keys;
    for (const QString& part :
         QString::fromLatin1(command.keys).split(QStringLiteral("; "), Qt::SkipEmptyParts))
        keys << QKeySequence::fromString(part, QKeySequence::PortableText);
    return keys;
}

/// The title with a key for Alt that no menu before it has.
QString withKey(const QString& title, QString& used) {
    for (qsizetype i = 0; i < title.size(); ++i) {
        const QChar letter = title[i].toLower();
        if (!letter.isLetter() || used.contains(letter)) continue;
        used += letter;
        return QString(title).insert(i, u'&');
    }
    return title;
}

QString tooltipOf(const Command& command) {
    const QList<QKeySequence> keys = keysOf(command);
    const QString sentence = QObject::tr(command.sentence);
    return keys.isEmpty()
               ? sentence
               : QStringLiteral("%1 (%2)").arg(sentence, keys.front().toString(QKeySequence::NativeText));
}

} // namespace

std::span<const Command> commands() {
    return kCommands;
}
std::span<const Manner> viewManners() {
    return kManners;
}

Actions::Actions(QObject* parent) : QObject(parent) {
    for (const Command& command : kCommands) {
        auto* action = new QAction(tr(command.text), this);
        action->setObjectName(QString::fromLatin1(command.id));
        action->setShortcuts(keysOf(command));
        action->setToolTip(tooltipOf(command));
        action->setCheckable(command.checkable);
        actions_[command.id] = action;
    }
    refreshIcons();
}

QAction& Actions::operator[](const char* id) const {
    return *actions_.at(id);
}

void Actions::fill(QMenuBar& bar) const {
    QMenu* menu = nullptr;
    QString used;
    for (const Command& command : kCommands) {
        if (!menu || menu->objectName() != QLatin1String(command.menu)) {
            menu = bar.addMenu(withKey(tr(command.menu), used));
            menu->setObjectName(QString::fromLatin1(command.menu));
        }
        if (command.separatorBefore) menu->addSeparator();
        menu->addAction(actions_.at(command.id));
    }
}

void Actions::refreshIcons() const {
    for (const Command& command : kCommands)
        if (*command.icon) actions_.at(command.id)->setIcon(icon(QString::fromLatin1(command.icon)));
}

} // namespace tactum
