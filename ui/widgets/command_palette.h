// Ctrl+Shift+P: every command by a few letters of it.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include <QFrame>
#include <QString>

class QLabel;
class QLineEdit;
class QTreeWidget;

namespace tactum {

/// One thing that can be done.
struct PaletteEntry {
    QString id;   ///< by which it is remembered; empty: it is not
    QString text; ///< without "&" and "..."
    QString menu;
    QString keys; ///< as the person's system writes them; may be empty
    QString sentence;
    QString whyNot; ///< one sentence; empty: it can be done now
    std::function<void()> run;
    std::optional<bool> on = {}; ///< of what is switched on and off
};

/// How well an entry fits what was typed: each word somewhere in it, in any order; 0 not at all. A word may
/// leave letters out, as "fal" does for "frame all". Nothing typed fits everything.
int paletteScore(const QString& typed, const PaletteEntry& entry);

/// Indices of the entries that fit, best first; of equal ones those that were run last. Thread: ui.
std::vector<std::size_t> paletteOrder(const QString& typed, const std::vector<PaletteEntry>& entries,
                                      const QStringList& recent);

/// A list over the window that closes when something is run, with Esc, or by a click elsewhere. Thread: ui.
class CommandPalette : public QFrame {
    Q_OBJECT
public:
    CommandPalette(std::vector<PaletteEntry> entries, QWidget* parent);

    /// What is offered besides for a line that was typed, before all commands.
    using Source = std::function<std::vector<PaletteEntry>(const QString& typed)>;
    void setSource(Source source) { source_ = std::move(source); }
    /// Below the upper edge of the parent.
    void open();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void fill();
    void explain();
    void runCurrent();
    void addRow(const PaletteEntry& entry, std::size_t index);
    const PaletteEntry* current() const;

    std::vector<PaletteEntry> entries_;
    Source source_;
    std::vector<PaletteEntry> sourced_; ///< for the line as it is; their numbers follow those of the entries
    QLineEdit* line_;
    QTreeWidget* list_;
    QLabel* sentence_;
};

} // namespace tactum
