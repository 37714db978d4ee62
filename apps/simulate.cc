#include "commands.h"
namespace framewise::apps {
void add_simulate(CLI::App&, Action&) {}
}  // namespace framewise::apps
