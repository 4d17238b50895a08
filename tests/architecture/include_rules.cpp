#include "tests/architecture/include_rules.h"

#include <algorithm>
#include <cctype>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>

#include "tests/architecture/house_plan.h"

namespace tactum::architecture {
namespace {

namespace fs = std::filesystem;

bool isHeader(std::string_view path) {
    return path.ends_with(".h");
}

bool isIn(std::string_view path, std::string_view folder) {
    return path.starts_with(folder) && path.size() > folder.size() && path[folder.size()] == '/';
}

SourceFile readFile(const fs::path& root, const fs::path& file) {
    std::ostringstream text;
    text << std::ifstream(file, std::ios::binary).rdbuf();
    return {fs::relative(file, root).generic_string(), text.str()};
}

std::vector<SourceFile> readFiles(const fs::path& root, bool (*isWanted)(const fs::path&)) {
    std::vector<SourceFile> files;
    for (const char* folder : {"app", "core", "device", "ui"})
        for (const auto& entry : fs::recursive_directory_iterator(root / folder))
            if (isWanted(entry.path())) files.push_back(readFile(root, entry.path()));
    std::sort(files.begin(), files.end(), [](const auto& a, const auto& b) { return a.path < b.path; });
    return files;
}

const Room* findRoom(std::string_view folder) {
    auto it =
        std::find_if(kRooms.begin(), kRooms.end(), [&](const Room& room) { return room.folder == folder; });
    return it == kRooms.end() ? nullptr : &*it;
}

// Whether arrows lead from one room to another, over any number of rooms.
bool leadsTo(std::string_view from, std::string_view to) {
    const Room* room = findRoom(from);
    return room && std::any_of(room->uses.begin(), room->uses.end(),
                               [&](std::string_view used) { return used == to || leadsTo(used, to); });
}

// The room that tactum_<name> is built from: "geometry" is core/geometry, "ui_view" is ui/view.
std::string_view roomOfTarget(const std::string& name) {
    const bool ofWindow = name.starts_with("ui_");
    for (const Room& room : kRooms)
        if (ofWindow
                ? room.folder == "ui/" + name.substr(3)
                : room.folder == "core/" + name || room.folder == "device/" + name || room.folder == name)
            return room.folder;
    return {};
}

// <vector> and <cmath>: lower case and neither dot nor slash.
bool isStandard(std::string_view include) {
    return std::all_of(include.begin(), include.end(),
                       [](unsigned char c) { return std::islower(c) || std::isdigit(c) || c == '_'; });
}

bool isGenerated(std::string_view include) {
    return include.ends_with(".moc");
}

const Library* findLibrary(std::string_view include) {
    auto it = std::find_if(kLibraries.begin(), kLibraries.end(),
                           [&](const Library& library) { return include.starts_with(library.prefix); });
    return it == kLibraries.end() ? nullptr : &*it;
}

std::string libraryFault(const std::string& path, const std::string& include) {
    const Library* library = findLibrary(include);
    if (!library)
        return path + ": <" + include +
               "> belongs to no known library; write project headers from the root of the repository, or "
               "name the library in tests/architecture/house_plan.h";
    const bool allowed = std::any_of(library->places.begin(), library->places.end(),
                                     [&](std::string_view place) { return path.starts_with(place); });
    if (allowed) return {};
    return path + ": <" + include + "> may be seen only in " + std::string(library->places.front());
}

std::string roomFault(const std::string& path, const std::string& include) {
    const auto from = roomOf(path), to = roomOf(include);
    if (from == to || leadsTo(from, to)) return {};
    return path + ": \"" + include + "\": no arrow leads from " + std::string(from) + " to " +
           std::string(to);
}

using IncludeGraph = std::map<std::string, std::vector<std::string>>;

// Depth first; `trail` is the way from the first header to this one. Returns the first ring.
std::string findRing(const IncludeGraph& graph, const std::string& file, std::vector<std::string>& trail,
                     std::set<std::string>& finished) {
    if (finished.count(file)) return {};
    const auto begin = std::find(trail.begin(), trail.end(), file);
    if (begin != trail.end()) {
        std::string ring;
        for (auto it = begin; it != trail.end(); ++it)
            ring += *it + " -> ";
        return ring + file;
    }
    trail.push_back(file);
    if (auto node = graph.find(file); node != graph.end())
        for (const auto& next : node->second)
            if (auto ring = findRing(graph, next, trail, finished); !ring.empty()) return ring;
    trail.pop_back();
    finished.insert(file);
    return {};
}

Faults ringsOf(const IncludeGraph& graph) {
    std::set<std::string> finished;
    for (const auto& [file, includes] : graph) {
        std::vector<std::string> trail;
        if (auto ring = findRing(graph, file, trail, finished); !ring.empty())
            return {"these include each other: " + ring};
    }
    return {};
}

} // namespace

std::vector<SourceFile> readSources(const fs::path& root) {
    return readFiles(root, [](const fs::path& file) {
        return file.extension() == ".h" || file.extension() == ".inc" || file.extension() == ".cpp";
    });
}

std::vector<SourceFile> readBuildFiles(const fs::path& root) {
    return readFiles(root, [](const fs::path& file) { return file.filename() == "CMakeLists.txt"; });
}

std::vector<std::string> includesOf(std::string_view text) {
    static const std::regex directive(R"(^\s*#\s*include\s*[<"]([^>"]+)[>"])");
    std::vector<std::string> includes;
    std::istringstream lines{std::string(text)};
    std::smatch match;
    for (std::string line; std::getline(lines, line);)
        if (std::regex_search(line, match, directive)) includes.push_back(match[1]);
    return includes;
}

std::string_view roomOf(std::string_view path) {
    for (const Room& room : kRooms)
        if (isIn(path, room.folder)) return room.folder;
    return {};
}

Faults wrongIncludes(const SourceFile& file) {
    if (roomOf(file.path).empty())
        return {file.path + ": lies in no room of tests/architecture/house_plan.h"};
    Faults faults;
    for (const auto& include : includesOf(file.text)) {
        if (isStandard(include) || isGenerated(include)) continue;
        const std::string fault =
            roomOf(include).empty() ? libraryFault(file.path, include) : roomFault(file.path, include);
        if (!fault.empty()) faults.push_back(fault);
    }
    return faults;
}

Faults wrongLinks(const SourceFile& cmakeLists) {
    static const std::regex uses(R"(\bUSES\s+([a-z_\s]+))");
    std::smatch match;
    if (!std::regex_search(cmakeLists.text, match, uses)) return {};
    const auto from = roomOf(cmakeLists.path);
    Faults faults;
    std::istringstream names(match[1]);
    for (std::string name; names >> name;) {
        const auto to = roomOfTarget(name);
        if (to.empty() || (from != to && !leadsTo(from, to)))
            faults.push_back(cmakeLists.path + ": USES " + name + ": no arrow leads there from " +
                             std::string(from));
    }
    return faults;
}

Faults formFaults(const SourceFile& file) {
    Faults faults;
    if (!isHeader(file.path)) return faults;
    if (!file.text.starts_with("// "))
        faults.push_back(file.path + ": the first line must be a comment that says what the file is for");
    if (file.text.find("\n#pragma once\n") == std::string::npos)
        faults.push_back(file.path + ": has no #pragma once");
    const auto includes = includesOf(file.text);
    if (file.path.starts_with("core/") && std::count(includes.begin(), includes.end(), "iostream") > 0)
        faults.push_back(file.path + ": <iostream> in a header of core makes every user of it pay");
    return faults;
}

bool isMarkedRealtime(const SourceFile& file) {
    static const std::regex lineOfComment(R"(\n\s*//+ ?)"), sentence(R"(Thread[^.]*real time)"),
        exception(R"((but|not|outside)[^,;.]*real time)");
    const std::string text = std::regex_replace(file.text, lineOfComment, " ");
    for (std::sregex_iterator at(text.begin(), text.end(), sentence), end; at != end; ++at)
        if (!std::regex_search(at->str(), exception)) return true;
    return false;
}

std::vector<SourceFile> realtimeSources(const std::vector<SourceFile>& files) {
    std::map<std::string, const SourceFile*> byPath;
    std::set<std::string> marked, met;
    std::vector<std::string> todo;
    for (const SourceFile& file : files) {
        byPath[file.path] = &file;
        if (isMarkedRealtime(file)) marked.insert(file.path);
        if (marked.contains(file.path) || file.text.find("const RealtimeScope ") != std::string::npos)
            todo.push_back(file.path);
    }
    while (!todo.empty()) {
        const std::string path = todo.back();
        todo.pop_back();
        if (!byPath.contains(path) || !met.insert(path).second) continue;
        for (const auto& include : includesOf(byPath[path]->text))
            todo.push_back(include);
        if (isHeader(path) && marked.contains(path)) todo.push_back(path.substr(0, path.size() - 2) + ".cpp");
    }
    std::vector<SourceFile> found;
    for (const SourceFile& file : files)
        if (met.contains(file.path) && (!isHeader(file.path) || marked.contains(file.path)))
            found.push_back(file);
    return found;
}

Faults realtimeFaults(const SourceFile& file) {
    Faults faults;
    for (const auto& include : includesOf(file.text))
        if (std::find(kNotRealtime.begin(), kNotRealtime.end(), include) != kNotRealtime.end())
            faults.push_back(file.path + ": runs in real time and must not include <" + include + ">");
    return faults;
}

Faults includeRings(const std::vector<SourceFile>& files) {
    IncludeGraph graph;
    for (const auto& file : files)
        graph[file.path] = includesOf(file.text);
    return ringsOf(graph);
}

Faults roomRings() {
    IncludeGraph graph;
    for (const Room& room : kRooms)
        for (std::string_view used : room.uses)
            graph[std::string(room.folder)].emplace_back(used);
    return ringsOf(graph);
}

} // namespace tactum::architecture
