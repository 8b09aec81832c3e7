#include <hachure/editor/command_line.h>

int main(int argc, char** argv) { return hachure::run_command_line(argc, argv); }
