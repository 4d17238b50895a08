// Every command of the window and every key, in one table: menus, tool bar and the keyboard sheet read it.
#pragma once

#include <span>
#include <unordered_map>

#include <QAction>
#include <QObject>

class QActionGroup;
class QMenuBar;
class QToolBar;

namespace tactum {

/// One command. Rows stand in the order of their menu.
struct Command {
    const char* id;
    const char* menu;     ///< title of its menu; "View/Bumps" is a menu inside another
    const char* text;     ///< in the menu
    const char* keys;     ///< portable key sequences separated by "; "; may be empty
    const char* icon;     ///< name in resources/icons, may be empty
    const char* sentence; ///< tooltip
    bool checkable = false;
    bool separatorBefore = false;
};
std::span<const Command> commands();
/// Whether it changes the document, the hand or the forces: not while a recording is shown in their place.
bool isLive(const Command& command);

/// A key or a mouse gesture that is no command: what the view does by itself.
struct Manner {
    const char* keys;
    const char* text;
};
std::span<const Manner> viewManners();

/// The actions of the table. Thread: ui.
class Actions : public QObject {
    Q_OBJECT
public:
    explicit Actions(QObject* parent = nullptr);

    /// By the row's id, which must exist.
    QAction& operator[](const char* id) const;
    /// On with what it does as its tool tip, or off with the sentence why.
    void allow(const char* id, const QString& whyNot) const;
    /// That sentence; empty where nobody gave one, or while it is on.
    QString whyNot(const QString& id) const;
    /// Takes all that isLive() away, or gives it back as it is allowed by then; but what belongs to a group
    /// where one of several is chosen stays.
    void setLive(bool live) const;
    /// All actions under their menus, in the order of the table.
    void fill(QMenuBar& bar) const;
    /// The icons in the colours of the theme that is on.
    void refreshIcons() const;

private:
    std::unordered_map<std::string, QAction*> actions_;
    QActionGroup& live_; ///< off, it takes its actions along, and remembers which are off by themselves
};

} // namespace tactum
