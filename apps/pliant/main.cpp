// The command line of Pliant: reads options, runs one command, turns errors into a line and an exit
// status.
//   0 done; 1 the work failed; 2 bad usage or bad input.

#include <iostream>
#include <new>
#include <signal.h>
#include <thread>
#include <unistd.h>

#include <malloc.h>

#include "pliant/base/errors.h"
#include "pliant/study/test_template.h"

#include "apps/pliant/command.h"
#include "apps/pliant/terminal_progress.h"
#include "apps/pliant/usage_problem.h"

namespace {

pliant::StopFlag stop_flag;

void request_stop(int signal) {
  // A second Ctrl-C ends the program at once.
  if (stop_flag.token().stop_requested()) _exit(128 + signal);
  stop_flag.request();
}

void stop_on_signals() {
  struct sigaction action = {};
  action.sa_handler = request_stop;
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
  ::signal(SIGPIPE, SIG_IGN);
  ::signal(SIGXFSZ, SIG_IGN);
}

// Pictures and matrices come and go by the thousand: given back to the system, which clears them
// each time anew, they would take a tenth to a third of the time.
void keep_freed_memory() {
  constexpr int kLargestBlock = 1 << 30, kUnused = 2'000'000'000, kAtOnce = 64 << 20;  // bytes
  mallopt(M_MMAP_THRESHOLD, kLargestBlock);
  mallopt(M_TRIM_THRESHOLD, kUnused);
  mallopt(M_TOP_PAD, kAtOnce);
}

pliant::Level level_of(const std::string& name) {
  if (name == "debug") return pliant::Level::debug;
  if (name == "warning") return pliant::Level::warning;
  return name == "error" ? pliant::Level::error : pliant::Level::info;
}

int fail(const std::string& message, int status) {
  std::cerr << "error: " << message << std::endl;
  return status;
}

int run(CLI::App& app, pliant::CommandRegistry& registry, int argc, char** argv) {
  const pliant::CommonOptions& common = registry.common;
  pliant::TerminalProgress progress(
      std::cerr, {isatty(STDERR_FILENO) != 0, common.quiet, level_of(common.log_level)});
  pliant::CommandContext context{
      common, {argv, argv + argc}, {progress, stop_flag.token(), common.threads, common.seed}};
  for (auto& [command, action] : registry.actions) {
    if (app.got_subcommand(command)) action(context);
  }
  if (!std::cout.flush()) return fail("standard output: cannot be written", 1);
  return 0;
}

int parse_and_run(int argc, char** argv) {
  CLI::App app(
      "Measures, fits and simulates deformable materials: force-deformation measurements of cloth "
      "in, "
      "a material with hysteresis and its uncertainty out.",
      "pliant");
  app.set_version_flag("--version", "pliant " PLIANT_VERSION);
  app.require_subcommand(1);
  app.footer("A first fit:  pliant init " + pliant::template_tests().front() +
             " -o mine; edit mine/study.yaml and its CSV;\n"
             "              pliant fit mine/study.yaml -o result; open result/report.html.\n"
             "Exit status: 0 done, 1 the work failed, 2 bad usage or bad input.");

  pliant::CommonOptions common;
  common.threads = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
  pliant::CommandRegistry registry{app, common, {}};
  pliant::add_init(registry);
  pliant::add_import(registry);
  pliant::add_fit(registry);
  pliant::add_evaluate(registry);
  pliant::add_lab(registry);
  pliant::add_simulate(registry);
  pliant::add_report(registry);
  pliant::add_render(registry);
  pliant::add_pattern(registry);
  pliant::add_calibrate(registry);
  pliant::add_compare(registry);
  pliant::add_convert(registry);
  pliant::add_info(registry);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return app.exit(error);
    return fail(pliant::usage_problem(app, {argv + 1, argv + argc}, error), 2);
  }
  return run(app, registry, argc, argv);
}

}  // namespace

int main(int argc, char** argv) {
  keep_freed_memory();
  stop_on_signals();
  try {
    return parse_and_run(argc, argv);
  } catch (const pliant::InputError& error) {
    return fail(error.what(), 2);
  } catch (const pliant::Interrupted& error) {
    return fail(error.what(), 1);
  } catch (const std::bad_alloc&) {
    return fail("out of memory", 1);
  } catch (const std::exception& error) {
    return fail(error.what(), 1);
  }
}
