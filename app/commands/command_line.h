// The command line: commands with their options, and the variables that these are read into. The only
// file that sees CLI11, which takes seconds to parse, is command_line.cpp.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace CLI {
class App;
class Option;
} // namespace CLI

namespace gg::commands {

// Where a value goes. What it holds before parsing is the default that --help shows, except an empty
// text, list or optional: "not given".
using Variable =
    std::variant<std::string*, std::filesystem::path*, int*, long*, std::uint64_t*, float*, double*,
                 std::optional<int>*, std::optional<long>*, std::optional<float>*,
                 std::optional<double>*, std::vector<std::string>*, std::vector<int>*>;

class Option {
public:
  explicit Option(CLI::Option* option) : option_(option) {}
  Option required();
  Option excludes(const Option& other);
  Option one_of(const std::vector<std::string>& words);
  // For lists. By default an option takes one value each time that it is given, and SCENE-like
  // positionals take all that there are; this also splits each at commas.
  Option comma_separated();

private:
  CLI::Option* option_;
};

class Command {
public:
  explicit Command(CLI::App& app) : app_(&app) {}
  Command subcommand(const std::string& name, const std::string& description);
  // `names` as "-o,--output", or "SCENE" for a positional. The variable must live as long as the
  // command line: keep it in a shared_ptr that the action captures.
  Option option(const std::string& names, Variable variable, const std::string& help);
  Option flag(const std::string& names, bool& variable, const std::string& help);
  // What the command does, once all its options are read; trouble is thrown as gg::Error.
  void action(const std::function<void()>& run);

private:
  CLI::App* app_;
};

// The program's command line: add commands to root(), then parse.
class CommandLine {
public:
  CommandLine(const std::string& name, const std::string& description, const std::string& version);
  ~CommandLine();
  CommandLine(const CommandLine&) = delete;
  CommandLine& operator=(const CommandLine&) = delete;
  Command root();
  // Reads the options and runs the chosen command's action; prints help or version where asked for.
  // Throws Error(usage), naming the option and what was probably meant, and what the action throws.
  void run(int argc, char** argv);

private:
  std::unique_ptr<CLI::App> app_;
};

} // namespace gg::commands
