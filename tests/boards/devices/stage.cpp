// Simulates the stage of a scanner on a simulated GPIO chip.
//
//   stage FOLDER STEP...
//
//   sync:N          N pulses of the sync line, 2 ms apart
//   button:T        the line is high for T ms; end-stop:T likewise
//   low-button:T    the line, normally high, is low for T ms
//   rest:T          nothing changes for T ms
//   stop:PID        stops a process, like a busy processor; go:PID continues it, end:PID ends it
#include <signal.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <string>

namespace {

enum Offset { sync, button, end_stop };

std::string folder;

void pull(Offset line, bool up) {
  const std::string name = folder + "/sim_gpio" + std::to_string(line) + "/pull";
  std::FILE* file = std::fopen(name.c_str(), "w");
  if (file == nullptr || std::fputs(up ? "pull-up" : "pull-down", file) < 0) {
    std::perror(name.c_str());
    std::exit(1);
  }
  std::fclose(file);
}

void rest(int ms) {
  usleep(static_cast<useconds_t>(ms) * 1000);
}

void press(Offset line, bool is_high, int ms) {
  rest(50);
  pull(line, is_high);
  rest(ms);
  pull(line, !is_high);
  rest(50);
}

bool play(const std::string& step, int number) {
  if (step == "sync") {
    for (int i = 0; i < number; ++i) {
      pull(sync, true);
      rest(1);
      pull(sync, false);
      rest(1);
    }
  } else if (step == "button") {
    press(button, true, number);
  } else if (step == "low-button") {
    press(button, false, number);
  } else if (step == "end-stop") {
    press(end_stop, true, number);
  } else if (step == "rest") {
    rest(number);
  } else if (step == "stop") {
    kill(number, SIGSTOP);
  } else if (step == "go") {
    kill(number, SIGCONT);
  } else if (step == "end") {
    kill(number, SIGTERM);
  } else {
    return false;
  }
  return true;
}

}  // namespace

int main(int count, char** arguments) {
  if (count < 2) return 2;
  folder = arguments[1];
  for (int i = 2; i < count; ++i) {
    const std::string step = arguments[i];
    const std::size_t colon = step.find(':');
    if (colon == std::string::npos ||
        !play(step.substr(0, colon), std::atoi(step.c_str() + colon + 1))) {
      std::fprintf(stderr, "stage: no step '%s'\n", step.c_str());
      return 2;
    }
  }
}
