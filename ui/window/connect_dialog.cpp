#include "ui/window/connect_dialog.h"

#include <QDialog>
#include <QDialogButtonBox>
#include <QFileDialog>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSettings>

#include "core/base/host_port.h"
#include "ui/base/style.h"

namespace tactum {
namespace {

const QString kPlaceKey = QStringLiteral("server/place"), kFolderKey = QStringLiteral("server/credentials");

class ConnectDialog : public QDialog {
public:
    explicit ConnectDialog(QWidget* parent)
        : QDialog(parent), place_(new QLineEdit), folder_(new QLineEdit),
          buttons_(new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel)) {
        setObjectName(QStringLiteral("connect-dialog"));
        setWindowTitle(QObject::tr("Connect to a haptic server"));
        const QSettings settings;
        place_->setObjectName(QStringLiteral("connect-place"));
        place_->setPlaceholderText(QStringLiteral("127.0.0.1:51270"));
        place_->setText(settings.value(kPlaceKey, place_->placeholderText()).toString());
        folder_->setObjectName(QStringLiteral("connect-folder"));
        folder_->setText(settings.value(kFolderKey).toString());
        auto* browse = new QPushButton(QObject::tr("&Browse..."));
        connect(browse, &QPushButton::clicked, this, [this] {
            const QString chosen = QFileDialog::getExistingDirectory(this, windowTitle(), folder_->text());
            if (!chosen.isEmpty()) folder_->setText(chosen);
        });
        auto* row = new QHBoxLayout;
        row->addWidget(folder_, 1);
        row->addWidget(browse);
        auto* form = new QFormLayout(this);
        auto* note = new QLabel(QObject::tr(
            "Another window opens on the server's scene and device. A server on another machine needs "
            "certificate.pem and token, which tactum serve --make-certificate has made there."));
        note->setWordWrap(true);
        form->addRow(note);
        form->addRow(QObject::tr("&Server"), place_);
        auto* folder = new QLabel(QObject::tr("&Folder of certificate and token"));
        folder->setBuddy(folder_);
        form->addRow(folder, row);
        form->addRow(buttons_);
        buttons_->button(QDialogButtonBox::Ok)->setText(QObject::tr("&Connect"));
        connect(buttons_, &QDialogButtonBox::accepted, this, &QDialog::accept);
        connect(buttons_, &QDialogButtonBox::rejected, this, &QDialog::reject);
        connect(place_, &QLineEdit::textChanged, this, [this] { judge(); });
        setMinimumWidth(56 * kRhythm);
        judge();
    }

    ServerAddress answer() const {
        QSettings settings;
        settings.setValue(kPlaceKey, place_->text().trimmed());
        settings.setValue(kFolderKey, folder_->text());
        return {place_->text().trimmed(), folder_->text()};
    }

private:
    void judge() {
        const bool right = isServerPlace(place_->text().trimmed());
        buttons_->button(QDialogButtonBox::Ok)->setEnabled(right);
        place_->setToolTip(right ? QString() : QObject::tr("HOST:PORT, as in 127.0.0.1:51270"));
    }

    QLineEdit *place_, *folder_;
    QDialogButtonBox* buttons_;
};

} // namespace

bool isServerPlace(const QString& text) {
    const auto place = hostPortOf(text.toStdString());
    return place && place->port > 0;
}

ServerAddress askForServer(QWidget* parent) {
    ConnectDialog dialog(parent);
    if (dialog.exec() != QDialog::Accepted) return {};
    return dialog.answer();
}

} // namespace tactum
