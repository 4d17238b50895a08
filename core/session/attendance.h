// Who attends a scene that several share: names, heartbeats, and the pen, which one of them has.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"

namespace tactum {

/// Names a client as long as it attends, and nobody else ever. 0 is nobody.
using ClientId = std::uint64_t;

/// Every so long a client says something; three times without, and what it holds is taken from it. Unit: s.
inline constexpr double kHeartbeat = 0.25;
inline constexpr double kSilence = 3 * kHeartbeat;
/// More cannot attend at once.
inline constexpr std::size_t kMostClients = 32;

struct Client {
    ClientId id = 0;
    std::string name; ///< safe to print
    std::string key;  ///< a secret
    double heard = 0; ///< s, on the clock of whoever calls
};

/// Values and a time that is given: no thread, no clock. Times in s. Thread: one at a time.
class Attendance {
public:
    /// The key is a secret that the caller has made. The pen goes to who wants it and finds it free.
    /// Errors: too many attend already.
    Result<ClientId> join(std::string_view name, std::string key, bool wantsPen, double now);
    /// Its pen is free then.
    void leave(ClientId id);
    void heard(ClientId id, double now);

    /// 0 for a key that is nobody's.
    ClientId whoHas(std::string_view key) const;
    const Client* find(ClientId id) const;
    std::size_t count() const { return clients_.size(); }

    ClientId pen() const { return pen_; }
    /// Who asked for it last and waits; 0: nobody. Whoever gets it or lets it go has answered.
    ClientId asker() const { return asker_; }
    void ask(ClientId id) { asker_ = id; }
    /// Whether it has the pen now, which it takes where it is free. The error says who has it.
    Result<void> takePen(ClientId id);
    /// To the first client of this name, or to nobody for an empty one. Errors: it has no pen, or there is no
    /// such client.
    Result<void> passPen(ClientId from, std::string_view name);
    /// Takes the pen from whoever has been silent for kSilence, and says who it was.
    std::optional<ClientId> takeFromSilent(double now);

private:
    void have(ClientId id);

    std::vector<Client> clients_;
    ClientId last_ = 0, pen_ = 0, asker_ = 0;
};

} // namespace tactum
