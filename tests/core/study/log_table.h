// A log as a reader of CSV sees it.
#pragma once

#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace tactum::test {

/// Cells by the names of their columns, of rows without quotes.
inline std::vector<std::map<std::string, std::string>> tableOf(const std::string& csv) {
    std::vector<std::vector<std::string>> lines;
    std::istringstream text(csv);
    for (std::string line; std::getline(text, line);) {
        std::istringstream cells(line + ','); // getline() drops an empty last one
        auto& row = lines.emplace_back();
        for (std::string cell; std::getline(cells, cell, ',');)
            row.push_back(cell);
    }
    std::vector<std::map<std::string, std::string>> table;
    for (std::size_t i = 1; i < lines.size(); ++i) {
        auto& row = table.emplace_back();
        for (std::size_t c = 0; c < lines[0].size() && c < lines[i].size(); ++c)
            row[lines[0][c]] = lines[i][c];
    }
    return table;
}

} // namespace tactum::test
