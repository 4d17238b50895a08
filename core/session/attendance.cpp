#include "core/session/attendance.h"

#include <algorithm>

#include "core/base/text.h"
#include "core/session/secret.h"

namespace tactum {

Result<ClientId> Attendance::join(std::string_view name, std::string key, bool wantsPen, double now) {
    if (clients_.size() >= kMostClients)
        return machineError("as many clients attend as can (" + std::to_string(kMostClients) +
                            "): end one of them first");
    const std::string shown = printable(trimmed(name));
    clients_.push_back(
        {++last_, shown.empty() ? "client " + std::to_string(last_) : shown, std::move(key), now});
    if (wantsPen && pen_ == 0) pen_ = last_;
    return last_;
}

void Attendance::have(ClientId id) {
    pen_ = id;
    asker_ = 0;
}

void Attendance::leave(ClientId id) {
    std::erase_if(clients_, [id](const Client& client) { return client.id == id; });
    if (pen_ == id) have(0);
    if (asker_ == id) asker_ = 0;
}

void Attendance::heard(ClientId id, double now) {
    for (Client& client : clients_)
        if (client.id == id) client.heard = now;
}

// All of them are looked at, so that the time tells nothing.
ClientId Attendance::whoHas(std::string_view key) const {
    ClientId found = 0;
    for (const Client& client : clients_)
        if (sameSecret(client.key, key)) found = client.id;
    return found;
}

const Client* Attendance::find(ClientId id) const {
    const auto found = std::ranges::find(clients_, id, &Client::id);
    return found == clients_.end() ? nullptr : &*found;
}

Result<void> Attendance::takePen(ClientId id) {
    if (!find(id)) return inputError("who does not attend cannot have the pen: attend first");
    if (pen_ == 0) have(id);
    if (pen_ == id) return {};
    return inputError(find(pen_)->name + " has the pen: ask for it, and wait until it is passed on");
}

Result<void> Attendance::passPen(ClientId from, std::string_view name) {
    if (from == 0 || pen_ != from) return inputError("only who has the pen can pass it on");
    if (name.empty()) {
        have(0);
        return {};
    }
    const auto to = std::ranges::find(clients_, name, &Client::name);
    if (to == clients_.end()) return inputError(inQuotes(name) + " does not attend");
    have(to->id);
    return {};
}

std::optional<ClientId> Attendance::takeFromSilent(double now) {
    const Client* holder = find(pen_);
    if (!holder || now - holder->heard < kSilence) return std::nullopt;
    const ClientId silent = pen_;
    have(0);
    return silent;
}

} // namespace tactum
