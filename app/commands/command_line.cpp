#include "commands/command_line.h"

#include "core/error.h"
#include "core/suggest.h"

#include <CLI/CLI.hpp>

#include <charconv>
#include <concepts>
#include <string_view>
#include <type_traits>
#include <utility>

namespace gg::commands {
namespace {

template <class T>
constexpr bool is_list = false;
template <class T>
constexpr bool is_list<std::vector<T>> = true;

template <class T>
struct ValueOf {
  using type = T;
};
template <class T>
struct ValueOf<std::optional<T>> {
  using type = T;
};
template <class T>
struct ValueOf<std::vector<T>> {
  using type = T;
};
template <class T>
using Value = typename ValueOf<T>::type;

template <class T>
constexpr const char* type_name() {
  if constexpr (std::integral<T>) return "INT";
  if constexpr (std::floating_point<T>) return "NUMBER";
  if constexpr (std::same_as<T, std::filesystem::path>) return "PATH";
  return "TEXT";
}

template <class T>
T read(const std::string& text) {
  if constexpr (std::is_arithmetic_v<T>) {
    T value{};
    const char *first = text.data(), *last = first + text.size();
    if (text.size() > 1 && text[0] == '+') ++first;
    const auto [end, error] = std::from_chars(first, last, value);
    if (error == std::errc::result_out_of_range)
      throw CLI::ValidationError("'" + text + "' is too large or too small");
    if (error != std::errc() || end != last)
      throw CLI::ValidationError("'" + text + "' is not a "
                                 + (std::integral<T> ? "whole number" : "number"));
    return value;
  } else {
    return T(text);
  }
}

template <class T>
std::string default_text(const T& value) {
  if constexpr (std::is_arithmetic_v<T>) {
    char text[32];
    return {text, std::to_chars(text, text + sizeof text, value).ptr};
  } else if constexpr (std::same_as<T, std::filesystem::path>) {
    return value.string();
  } else if constexpr (std::same_as<T, std::string>) {
    return value;
  } else {
    return {};
  }
}

// "--output" of "-o,--output": what messages call it.
std::string called(const std::string& names) {
  return names.substr(names.rfind(',') + 1);
}

std::vector<std::string> option_names(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::Option* option : app.get_options())
    for (const std::string& name : option->get_lnames())
      names.push_back("--" + name);
  return names;
}

std::vector<std::string> command_names(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* one : app.get_subcommands([](const CLI::App*) { return true; }))
    names.push_back(one->get_name());
  return names;
}

// What is wrong, for people: CLI11 complains of what is missing before what is mistyped, which is
// often the same.
[[noreturn]] void complain(const CLI::App& app, const CLI::ParseError& error) {
  const auto chosen = app.get_subcommands();
  const CLI::App& command = chosen.empty() ? app : *chosen.front();
  const std::string help =
      "See groundglass " + (chosen.empty() ? "" : command.get_name() + " ") + "--help.";
  const std::vector<std::string> before = app.remaining();
  if (!chosen.empty() && !before.empty())
    throw Error(ExitCode::usage, before.front(), "stands before the command",
                "Put the command first: groundglass " + command.get_name() + " ...");
  const std::vector<std::string> unknown = chosen.empty() ? before : command.remaining();
  if (chosen.empty() && !unknown.empty() && !unknown.front().starts_with('-'))
    throw Error(ExitCode::usage, unknown.front(), "is not a command",
                did_you_mean(unknown.front(), command_names(app)) + help);
  for (const std::string& word : unknown)
    if (word.starts_with('-')) {
      const std::string name = word.substr(0, word.find('='));
      throw Error(ExitCode::usage, name,
                  "is not an option of groundglass"
                      + (chosen.empty() ? "" : " " + command.get_name()),
                  did_you_mean(name, option_names(command)) + help);
    }
  if (!unknown.empty())
    throw Error(ExitCode::usage, unknown.front(), "is one argument too many", help);
  if (chosen.empty()) throw Error(ExitCode::usage, "", "no command is given", help);
  const std::string what = error.what();
  for (const auto& [theirs, ours] : {
           std::pair{": 1 required",
                     "is given without a value"},               // "--size: 1 required TEXT missing"
           {" is required", "is missing"},                      // "SCENE is required"
           {": At Most 1 required", "is given more than once"}, // "...but received 2"
       })
    if (const std::size_t at = what.find(theirs); at != std::string::npos)
      throw Error(ExitCode::usage, what.substr(0, at), ours, help);
  // "--spp excludes --error"
  constexpr std::string_view excludes = " excludes ";
  if (const std::size_t at = what.find(excludes); at != std::string::npos)
    throw Error(ExitCode::usage, what.substr(0, at),
                "is given with " + what.substr(at + excludes.size()), "Choose one. " + help);
  throw Error(ExitCode::usage, "", what, help);
}

} // namespace

Option Option::required() {
  option_->required();
  return *this;
}

Option Option::excludes(const Option& other) {
  option_->excludes(other.option_);
  return *this;
}

Option Option::one_of(const std::vector<std::string>& words) {
  option_->check([words](const std::string& text) -> std::string {
    if (std::ranges::find(words, text) != words.end()) return {};
    std::string list;
    for (std::size_t i = 0; i < words.size(); ++i)
      list += (i == 0 ? "" : i + 1 == words.size() ? " or " : ", ") + words[i];
    return "'" + text + "' is not known. " + did_you_mean(text, words) + "Choose " + list;
  });
  return *this;
}

Option Option::comma_separated() {
  option_->delimiter(',');
  return *this;
}

Command Command::subcommand(const std::string& name, const std::string& description) {
  return Command(*app_->add_subcommand(name, description));
}

Option Command::option(const std::string& names, Variable variable, const std::string& help) {
  return std::visit(
      [&]<class T>(T* at) {
        const std::string name = called(names);
        const auto store = [at, name](const std::vector<std::string>& texts) {
          try {
            if constexpr (is_list<T>) {
              at->clear();
              for (const std::string& text : texts)
                at->push_back(read<Value<T>>(text));
            } else {
              *at = read<Value<T>>(texts.front());
            }
          } catch (const CLI::ValidationError& error) {
            throw CLI::ValidationError(name, error.what());
          }
          return true;
        };
        CLI::Option* option = app_->add_option(names, store, help);
        option->type_name(type_name<Value<T>>())->default_str(default_text(*at));
        if constexpr (is_list<T>) {
          if (names.starts_with('-'))
            option->expected(1);
          else
            option->expected(1, CLI::detail::expected_max_vector_size)->allow_extra_args();
          option->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
        }
        return Option(option);
      },
      variable);
}

Option Command::flag(const std::string& names, bool& variable, const std::string& help) {
  return Option(app_->add_flag(names, variable, help));
}

void Command::action(const std::function<void()>& run) {
  app_->callback(run);
}

CommandLine::CommandLine(const std::string& name, const std::string& description,
                         const std::string& version)
    : app_(std::make_unique<CLI::App>(description, name)) {
  app_->require_subcommand(1);
  app_->set_version_flag("--version", version);
}

CommandLine::~CommandLine() = default;

Command CommandLine::root() {
  return Command(*app_);
}

void CommandLine::run(int argc, char** argv) {
  try {
    app_->parse(argc, argv);
  } catch (const CLI::Success& asked) {
    app_->exit(asked); // prints help or version
  } catch (const CLI::ParseError& error) {
    complain(*app_, error);
  }
}

} // namespace gg::commands
