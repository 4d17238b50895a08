// A page of the guide in the colours of the window.
#pragma once

#include <QTextBrowser>

namespace tactum {

/// Thread: ui.
class GuideBrowser : public QTextBrowser {
    Q_OBJECT
public:
    explicit GuideBrowser(QWidget* parent = nullptr);

    /// Opens a page at a place of its document, and marks these words wherever they are in it.
    void openAt(const QString& file, int position, const QStringList& words);

    QVariant loadResource(int type, const QUrl& name) override; ///< pictures no wider than the page

protected:
    void doSetSource(const QUrl& url, QTextDocument::ResourceType type) override;
    void changeEvent(QEvent* event) override; ///< another theme

private:
    void dress();
    void mark(const QStringList& words);

    QStringList words_;
};

} // namespace tactum
