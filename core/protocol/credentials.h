// What a server that strangers can reach needs: a certificate with its key, and a token, as files of its
// person.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/base/result.h"

namespace tactum {

/// PEM, but for the token.
struct Credentials {
    std::string certificate, key;
    std::string token; ///< 128 bits as 32 hexadecimal digits
};

/// Certificate for these names and addresses, signed by itself, valid for ten years; key of P-256; token.
/// Thread: any but real time.
Result<Credentials> makeCredentials(const std::vector<std::string>& names);

/// As certificate.pem, key.pem and token in a folder, the last two for this person alone. Thread: any but
/// real time.
Result<void> saveCredentials(const Credentials& credentials, const std::filesystem::path& folder);
/// Errors: one of them is missing, a key that others may read, a token that is none.
Result<Credentials> loadCredentials(const std::filesystem::path& folder);
/// The same for a client, who has no key.
Result<Credentials> loadClientCredentials(const std::filesystem::path& folder);

/// ~/.config/Tactum/server, or below XDG_CONFIG_HOME; empty where there is neither.
std::filesystem::path credentialsFolder();

} // namespace tactum
