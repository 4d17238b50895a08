#include "device/listings_text.h"

#include <nlohmann/json.hpp>

#include "core/base/text.h"

namespace tactum {

using Json = nlohmann::json;

std::string toJson(const std::vector<DeviceListing>& listings) {
    Json json = Json::array();
    for (const DeviceListing& listing : listings)
        json.push_back({{"id", listing.id},
                        {"name", listing.name},
                        {"usable", listing.usable},
                        {"sentence", listing.sentence},
                        {"forbidden", listing.forbidden},
                        {"lacks", listing.lacks}});
    return json.dump(2, ' ', false, Json::error_handler_t::replace);
}

std::vector<DeviceListing> listingsOf(std::string_view text) {
    const Json json = Json::parse(text, nullptr, false);
    if (!json.is_array()) return {};
    std::vector<DeviceListing> listings;
    try {
        for (const Json& entry : json)
            listings.push_back(
                {printable(entry.at("id").get<std::string>()), printable(entry.at("name").get<std::string>()),
                 entry.at("usable").get<bool>(), printable(entry.at("sentence").get<std::string>(), 400),
                 entry.value("forbidden", false), printable(entry.value("lacks", std::string()))});
    } catch (const Json::exception&) {
        return {};
    }
    return listings;
}

} // namespace tactum
