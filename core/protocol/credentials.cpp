#include "core/protocol/credentials.h"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <memory>

#include <arpa/inet.h>
#include <openssl/bio.h>
#include <openssl/ec.h>
#include <openssl/evp.h>
#include <openssl/pem.h>
#include <openssl/x509v3.h>
#include <sys/stat.h>

#include "core/base/atomic_file.h"
#include "core/base/text.h"
#include "core/session/secret.h"

namespace tactum {
namespace {

template <class T, void (*release)(T*)> struct Release {
    void operator()(T* held) const { release(held); }
};
using Key = std::unique_ptr<EVP_PKEY, Release<EVP_PKEY, EVP_PKEY_free>>;
using Certificate = std::unique_ptr<X509, Release<X509, X509_free>>;
using Memory = std::unique_ptr<BIO, Release<BIO, BIO_free_all>>;
using Extension = std::unique_ptr<X509_EXTENSION, Release<X509_EXTENSION, X509_EXTENSION_free>>;

bool isAddress(const std::string& name) {
    in6_addr room{};
    return inet_pton(AF_INET, name.c_str(), &room) == 1 || inet_pton(AF_INET6, name.c_str(), &room) == 1;
}

/// Nothing that could end a name and begin another.
bool isPlain(const std::string& name) {
    const auto plain = [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '.' ||
               c == '-' || c == ':';
    };
    return !name.empty() && name.size() <= 253 && std::ranges::all_of(name, plain);
}

/// Digits and dots alone, and no address all the same: no name of a machine is like that.
bool isBrokenAddress(const std::string& name) {
    return name.find_first_not_of("0123456789.") == std::string::npos && !isAddress(name);
}

bool add(X509* certificate, int what, const std::string& value) {
    X509V3_CTX context;
    X509V3_set_ctx_nodb(&context);
    X509V3_set_ctx(&context, certificate, certificate, nullptr, nullptr, 0);
    const Extension extension(X509V3_EXT_conf_nid(nullptr, &context, what, value.c_str()));
    return extension && X509_add_ext(certificate, extension.get(), -1) == 1;
}

bool fill(X509* certificate, EVP_PKEY* key, const std::string& alternatives) {
    constexpr long kTenYears = 3650L * 24 * 3600;
    unsigned char serial[8] = {};
    const auto random = makeSecret();
    if (!random) return false;
    std::copy_n(random->begin(), sizeof serial, serial);
    serial[0] &= 0x7f; // positive
    BIGNUM* number = BN_bin2bn(serial, sizeof serial, nullptr);
    const bool numbered = number && BN_to_ASN1_INTEGER(number, X509_get_serialNumber(certificate));
    BN_free(number);
    X509_NAME* name = X509_get_subject_name(certificate);
    const auto* common = reinterpret_cast<const unsigned char*>("Tactum server");
    return numbered && X509_set_version(certificate, 2) == 1 &&
           X509_gmtime_adj(X509_getm_notBefore(certificate), -60) &&
           X509_gmtime_adj(X509_getm_notAfter(certificate), kTenYears) &&
           X509_set_pubkey(certificate, key) == 1 &&
           X509_NAME_add_entry_by_txt(name, "CN", MBSTRING_ASC, common, -1, -1, 0) == 1 &&
           X509_set_issuer_name(certificate, name) == 1 &&
           add(certificate, NID_basic_constraints, "critical,CA:TRUE") &&
           add(certificate, NID_subject_alt_name, alternatives) &&
           X509_sign(certificate, key, EVP_sha256()) > 0;
}

std::string contentOf(BIO* memory) {
    char* bytes = nullptr;
    const long size = BIO_get_mem_data(memory, &bytes);
    return {bytes, std::size_t(std::max(0L, size))};
}

/// What a person without the file has to do.
constexpr const char *kMake = "make it with tactum serve --make-certificate NAME",
                     *kCopy = "copy it from the folder of the server that made it";

/// Of a file and nothing else: a pipe would keep who reads it for ever.
Result<std::string> contentOf(const std::filesystem::path& file, const char* remedy) {
    constexpr std::uintmax_t kMost = 1 << 16;
    std::error_code fault;
    std::string text;
    if (std::filesystem::is_regular_file(file, fault) && std::filesystem::file_size(file, fault) <= kMost) {
        std::ifstream in(file, std::ios::binary);
        text.assign(std::istreambuf_iterator<char>(in), {});
    }
    if (!text.empty()) return text;
    return inputError(file.string() + ": cannot be read; " + remedy);
}

/// Nobody is asked for a password.
int noPassword(char*, int, int, void*) {
    return 0;
}

template <class Read> auto parsed(const std::string& pem, Read read) {
    const Memory text(BIO_new_mem_buf(pem.data(), int(pem.size())));
    return read(text.get(), nullptr, noPassword, nullptr);
}

/// What gRPC finds out only when nobody can be told any more.
Result<void> demandFitting(const Credentials& credentials, const std::filesystem::path& folder,
                           const char* remedy) {
    const Certificate certificate(parsed(credentials.certificate, PEM_read_bio_X509));
    if (!certificate)
        return inputError((folder / "certificate.pem").string() + ": is no certificate; " + remedy);
    if (credentials.key.empty()) return {};
    const Key key(parsed(credentials.key, PEM_read_bio_PrivateKey));
    if (!key) return inputError((folder / "key.pem").string() + ": is no key, or has a password; " + remedy);
    if (X509_check_private_key(certificate.get(), key.get()) == 1) return {};
    return inputError(
        (folder / "key.pem").string() +
        ": belongs to another certificate than certificate.pem; make both anew with tactum serve "
        "--make-certificate NAME");
}

Result<void> saveSecret(const std::filesystem::path& file, const std::string& text) {
    // Made for this person alone before there is anything in it.
    const mode_t before = umask(077);
    auto written = writeFileAtomically(file, text, 0);
    umask(before);
    if (written && chmod(file.c_str(), 0600) != 0)
        return machineError(file.string() + ": cannot be kept from others; choose another folder");
    return written;
}

} // namespace

Result<Credentials> makeCredentials(const std::vector<std::string>& names) {
    std::string alternatives = "DNS:localhost,IP:127.0.0.1,IP:::1";
    for (const std::string& name : names) {
        if (!isPlain(name) || isBrokenAddress(name))
            return inputError(inQuotes(name) + " is no name or address of a server");
        alternatives += (isAddress(name) ? ",IP:" : ",DNS:") + name;
    }
    const auto secret = makeSecret();
    if (!secret) return tl::unexpected(secret.error());
    const Key key(EVP_EC_gen("P-256"));
    const Certificate certificate(X509_new());
    const Memory certificateText(BIO_new(BIO_s_mem())), keyText(BIO_new(BIO_s_mem()));
    if (!key || !certificate || !fill(certificate.get(), key.get(), alternatives) ||
        PEM_write_bio_X509(certificateText.get(), certificate.get()) != 1 ||
        PEM_write_bio_PrivateKey(keyText.get(), key.get(), nullptr, nullptr, 0, nullptr, nullptr) != 1)
        return machineError("OpenSSL could not make a certificate of these names");
    return Credentials{contentOf(certificateText.get()), contentOf(keyText.get()), hexOf(*secret)};
}

Result<void> saveCredentials(const Credentials& credentials, const std::filesystem::path& folder) {
    std::error_code fault;
    std::filesystem::create_directories(folder, fault);
    if (auto saved = saveSecret(folder / "key.pem", credentials.key); !saved) return saved;
    if (auto saved = saveSecret(folder / "token", credentials.token + '\n'); !saved) return saved;
    return writeFileAtomically(folder / "certificate.pem", credentials.certificate, 0);
}

namespace {

Result<Credentials> load(const std::filesystem::path& folder, bool withKey) {
    constexpr std::size_t kDigits = 32;
    const char* remedy = withKey ? kMake : kCopy;
    Credentials credentials;
    for (const auto& [name, text] : {std::pair{"certificate.pem", &credentials.certificate},
                                     {"key.pem", withKey ? &credentials.key : nullptr},
                                     {"token", &credentials.token}}) {
        if (!text) continue;
        auto content = contentOf(folder / name, remedy);
        if (!content) return tl::unexpected(content.error());
        *text = std::move(*content);
    }
    credentials.token = std::string(trimmed(credentials.token.substr(0, credentials.token.find('\n'))));
    if (credentials.token.size() < kDigits)
        return inputError((folder / "token").string() + ": is shorter than 32 digits; " + remedy);
    for (const char* secret : {"key.pem", "token"}) {
        struct stat file {};
        const auto path = folder / secret;
        if (stat(path.c_str(), &file) == 0 && (file.st_mode & 077) != 0)
            return inputError(path.string() + ": others may read it; chmod 600 it, or make it anew");
    }
    if (auto fits = demandFitting(credentials, folder, remedy); !fits) return tl::unexpected(fits.error());
    return credentials;
}

} // namespace

Result<Credentials> loadCredentials(const std::filesystem::path& folder) {
    return load(folder, true);
}
Result<Credentials> loadClientCredentials(const std::filesystem::path& folder) {
    return load(folder, false);
}

std::filesystem::path credentialsFolder() {
    const auto below = [](const char* folder, const char* path) {
        return folder && *folder ? std::filesystem::path(folder) / path : std::filesystem::path();
    };
    const auto own = below(std::getenv("XDG_CONFIG_HOME"), "Tactum/server");
    return own.empty() ? below(std::getenv("HOME"), ".config/Tactum/server") : own;
}

} // namespace tactum
