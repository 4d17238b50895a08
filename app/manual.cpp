#include "app/manual.h"

#include <algorithm>
#include <vector>

#include <CLI/CLI.hpp>

#include "app/exit_codes.h"

namespace tactum {
namespace {

/// One option or argument as all forms want it.
struct Entry {
    std::string name;  ///< --out, or SCENE of an argument
    std::string value; ///< FILE, N/m, on|off; empty for a flag
    std::string sentence;
    std::vector<std::string> words; ///< the values, where there are only these
    bool isArgument = false;
    bool isRequired = false;
};

struct Verb {
    std::string name, sentence, footer;
    std::vector<Entry> entries;
};

std::vector<std::string> wordsOf(const std::string& value) {
    if (value.find('|') == std::string::npos) return {};
    std::vector<std::string> words{""};
    for (const char c : value) {
        if (c == '|')
            words.emplace_back();
        else
            words.back() += c;
    }
    return words;
}

Entry entryOf(const CLI::Option& option) {
    Entry entry;
    entry.isArgument = option.get_positional();
    entry.name = entry.isArgument ? option.get_name(true) : "--" + option.get_lnames().front();
    // A flag takes no value, and an argument is its value.
    if (!entry.isArgument && option.get_items_expected_max() > 0) entry.value = option.get_type_name();
    entry.sentence = option.get_description();
    entry.words = wordsOf(entry.value);
    entry.isRequired = option.get_required();
    return entry;
}

std::vector<Verb> verbsOf(const CLI::App& program) {
    std::vector<Verb> verbs;
    for (const CLI::App* app : program.get_subcommands([](const CLI::App*) { return true; })) {
        if (app->get_group().empty()) continue;
        verbs.push_back({app->get_name(), app->get_description(), app->get_footer(), {}});
        for (const CLI::Option* option : app->get_options())
            if (!option->get_group().empty()) verbs.back().entries.push_back(entryOf(*option));
    }
    return verbs;
}

std::string replaced(std::string text, std::string_view from, std::string_view to) {
    for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size())
        text.replace(at, from.size(), to);
    return text;
}

// The man page, in the man macros of roff.

/// Text that roff takes for nothing but text: no request, no escape, and a dash that can be searched for.
std::string roff(const std::string& text) {
    std::string safe = replaced(replaced(text, "\\", "\\e"), "-", "\\-");
    if (!safe.empty() && (safe[0] == '.' || safe[0] == '\'')) safe = "\\&" + safe;
    return replaced(replaced(safe, "\n.", "\n\\&."), "\n'", "\n\\&'");
}

std::string synopsisOf(const Verb& verb) {
    std::string line = "\\fBtactum " + roff(verb.name) + "\\fR";
    for (const Entry& entry : verb.entries)
        if (entry.isArgument) line += " \\fI" + roff(entry.name) + "\\fR";
    for (const Entry& entry : verb.entries)
        if (!entry.isArgument && entry.isRequired)
            line += " \\fB" + roff(entry.name) + "\\fR \\fI" + roff(entry.value) + "\\fR";
    return line + " [\\fIoptions\\fR]\n";
}

std::string sectionOf(const Verb& verb) {
    std::string text = ".SS \"tactum " + roff(verb.name) + "\"\n" + roff(verb.sentence) + ".\n";
    for (const Entry& entry : verb.entries) {
        text += ".TP\n" + std::string(entry.isArgument ? "\\fI" : "\\fB") + roff(entry.name) + "\\fR";
        if (!entry.value.empty()) text += " \\fI" + roff(entry.value) + "\\fR";
        text += "\n" + roff(entry.sentence) + "\n";
    }
    if (!verb.footer.empty()) text += ".PP\n" + roff(verb.footer) + "\n";
    return text;
}

std::string manPage(const std::vector<Verb>& verbs) {
    std::string text = ".TH TACTUM 1 \"\" \"Tactum\" \"User commands\"\n"
                       ".SH NAME\ntactum \\- author haptic scenes, and touch them\n"
                       ".SH SYNOPSIS\n\\fBtactum\\fR [\\fISCENE\\fR]\n";
    for (const Verb& verb : verbs)
        text += ".br\n" + synopsisOf(verb);
    text +=
        ".SH DESCRIPTION\n"
        "Without a verb the window opens: say how each surface of a 3\\-D model feels, and touch it with a\n"
        "force\\-feedback device or with the mouse. With a verb no display is needed.\n"
        ".SH VERBS\n";
    for (const Verb& verb : verbs)
        text += sectionOf(verb);
    text += ".SH \"EXIT STATUS\"\n";
    for (const ExitCode& exit : kExitCodes)
        text += ".TP\n\\fB" + std::to_string(exit.code) + "\\fR\n" + roff(exit.meaning) + "\n";
    return text +
           ".PP\nEvery error is one line on standard error: what, where, and what to do.\n"
           ".SH \"SEE ALSO\"\nThe guide, in the window under Help, and in /usr/share/tactum/docs/guide.\n";
}

// Completions. A value that is not one of a few words is completed as a file's name.

std::string joined(const std::vector<std::string>& words) {
    std::string text;
    for (const std::string& word : words)
        text += (text.empty() ? "" : " ") + word;
    return text;
}

std::string bashCompletion(const std::vector<Verb>& verbs) {
    std::vector<std::string> names;
    std::string options, values;
    for (const Verb& verb : verbs) {
        names.push_back(verb.name);
        std::vector<std::string> dashed;
        for (const Entry& entry : verb.entries) {
            if (!entry.isArgument) dashed.push_back(entry.name);
            if (!entry.words.empty())
                values += "    \"" + verb.name + " " + entry.name + "\") words=\"" + joined(entry.words) +
                          "\" ;;\n";
        }
        options += "    " + verb.name + ") words=\"" + joined(dashed) + "\" ;;\n";
    }
    return "# bash completion for tactum\n"
           "_tactum() {\n"
           "    local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD - 1]} "
           "verb=${COMP_WORDS[1]} words=\n"
           "    COMPREPLY=()\n"
           "    if [ \"$COMP_CWORD\" -eq 1 ]; then\n"
           "        mapfile -t COMPREPLY < <(compgen -W \"" +
           joined(names) +
           "\" -- \"$word\"; compgen -f -- \"$word\")\n"
           "        return\n"
           "    fi\n"
           "    case \"$verb $before\" in\n" +
           values +
           "    esac\n"
           "    if [ -z \"$words\" ] && [[ $word == -* ]]; then\n"
           "        case \"$verb\" in\n" +
           replaced("    " + options.substr(0, options.size() - 1), "\n", "\n    ") +
           "\n"
           "        esac\n"
           "    fi\n"
           "    if [ -n \"$words\" ]; then\n"
           "        mapfile -t COMPREPLY < <(compgen -W \"$words\" -- \"$word\")\n"
           "    else\n"
           "        mapfile -t COMPREPLY < <(compgen -f -- \"$word\")\n"
           "    fi\n"
           "}\n"
           "complete -o filenames -F _tactum tactum\n";
}

/// In single quotes of a shell.
std::string shellQuoted(const std::string& text) {
    return "'" + replaced(text, "'", "'\\''") + "'";
}

std::string zshAction(const Entry& entry) {
    return entry.words.empty() ? "_files" : "(" + joined(entry.words) + ")";
}

std::string zshSpec(const Entry& entry) {
    // What separates the parts of a specification.
    std::string sentence = replaced(replaced(replaced(entry.sentence, ":", "\\:"), "[", "\\["), "]", "\\]");
    if (entry.isArgument) return shellQuoted(":" + entry.name + ":_files");
    std::string spec = entry.name + "[" + sentence + "]";
    if (!entry.value.empty()) spec += ":" + replaced(entry.value, ":", "\\:") + ":" + zshAction(entry);
    return shellQuoted(spec);
}

std::string zshCompletion(const std::vector<Verb>& verbs) {
    std::string described, cases;
    for (const Verb& verb : verbs) {
        described += "        " + shellQuoted(verb.name + ":" + replaced(verb.sentence, ":", "\\:")) + "\n";
        cases += "    " + verb.name + ") _arguments";
        for (const Entry& entry : verb.entries)
            cases += " \\\n        " + zshSpec(entry);
        cases += " ;;\n";
    }
    return "#compdef tactum\n"
           "_tactum() {\n"
           "    local -a verbs=(\n" +
           described +
           "    )\n"
           "    if (( CURRENT == 2 )); then\n"
           "        _describe verb verbs\n"
           "        _files\n"
           "        return\n"
           "    fi\n"
           "    local verb=$words[2]\n"
           "    shift words\n"
           "    (( CURRENT-- ))\n"
           "    case $verb in\n" +
           cases +
           "    *) _files ;;\n"
           "    esac\n"
           "}\n"
           "_tactum \"$@\"\n";
}

std::string fishLine(const Verb& verb, const Entry& entry) {
    std::string line =
        "complete -c tactum -n '__fish_seen_subcommand_from " + verb.name + "' -l " + entry.name.substr(2);
    if (!entry.words.empty())
        line += " -x -a " + shellQuoted(joined(entry.words));
    else if (!entry.value.empty())
        line += " -r";
    return line + " -d " + shellQuoted(replaced(entry.sentence, "\\", "\\\\")) + "\n";
}

std::string fishCompletion(const std::vector<Verb>& verbs) {
    std::string text = "# fish completion for tactum\n";
    for (const Verb& verb : verbs) {
        text += "complete -c tactum -n __fish_use_subcommand -a " + verb.name + " -d " +
                shellQuoted(verb.sentence) + "\n";
        for (const Entry& entry : verb.entries)
            if (!entry.isArgument) text += fishLine(verb, entry);
    }
    return text;
}

} // namespace

std::optional<std::string> manual(const CLI::App& program, std::string_view form) {
    const std::vector<Verb> verbs = verbsOf(program);
    if (form == "man") return manPage(verbs);
    if (form == "bash") return bashCompletion(verbs);
    if (form == "zsh") return zshCompletion(verbs);
    if (form == "fish") return fishCompletion(verbs);
    return {};
}

} // namespace tactum
