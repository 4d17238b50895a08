// Where a haptic server is to be found, as the person says it.
#pragma once

#include <QString>

class QWidget;

namespace tactum {

/// What `tactum --connect` gets.
struct ServerAddress {
    QString place;       ///< HOST:PORT
    QString credentials; ///< folder of certificate.pem and token; empty: none
};

/// Empty place: the person thought better of it. The last answer is remembered.
ServerAddress askForServer(QWidget* parent);
/// Whether it is HOST:PORT.
bool isServerPlace(const QString& text);

} // namespace tactum
