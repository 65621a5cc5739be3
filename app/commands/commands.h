// The commands, one file each: what a user can ask for. To add one, write NAME.cpp like devices.cpp
// (small) or needs.cpp (with the options that it shares with others):
//
//   void add_name(Command program) {
//     auto options = std::make_shared<Options>();
//     Command command = program.subcommand("name", "What it does, for --help");
//     command.option("SCENE", &options->scene, "A glTF 2.0 file, .gltf or .glb").required();
//     command.option("-o,--output", &options->output, "File to write").required();
//     command.action([options] { run(*options); });
//   }
//
// declare it here, call it in commands.cpp and list the file in CMakeLists.txt. See command_line.h;
// CLI11 is seen by command_line.cpp alone. Trouble is reported by throwing gg::Error.
#pragma once

#include "commands/chosen_method.h"
#include "commands/command_line.h"

namespace gg::commands {

// In the order in which --help shows them: all (commands.cpp), or capture by itself (capture_alone.cpp).
void add_all(Command program);

void add_capture(Command program, MethodChoice choose_method);
void add_compare(Command program);
void add_convert(Command program);
void add_devices(Command program);
void add_eval(Command program);
void add_figures(Command program);
void add_list(Command program);
void add_kit(Command program);
void add_needs(Command program);
void add_report(Command program);
void add_snippet(Command program);
void add_tables(Command program);
void add_truth(Command program);
void add_view(Command program);

} // namespace gg::commands
