// The commands, one file each: what a user can ask for. Each add_ function registers one with its
// options; the callback builds what it needs and runs it, and reports trouble by throwing
// gg::Error.
#pragma once

namespace CLI {
class App;
}

namespace gg::commands {

void add_all(CLI::App& app); // in the order in which --help shows them

void add_capture(CLI::App& app);
void add_compare(CLI::App& app);
void add_devices(CLI::App& app);
void add_eval(CLI::App& app);
void add_figures(CLI::App& app);
void add_needs(CLI::App& app);
void add_report(CLI::App& app);
void add_tables(CLI::App& app);
void add_truth(CLI::App& app);
void add_unfinished(CLI::App& app); // promised names that say so and exit with `unsupported`

} // namespace gg::commands
