// SPDX-License-Identifier: AGPL-3.0-or-later
// nmgs-tet: reads one request, runs TetGen on it, writes the answer and ends. Whatever TetGen does
// to this process, the workbench's process lives on.
#include "nmgs_tet/input.h"
#include "nmgs_tet/limits.h"
#include "nmgs_tet/result.h"

#include <tetgen.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <filesystem>
#include <fstream>
#include <new>
#include <sstream>
#include <string>
#include <system_error>

namespace {

using namespace nmgs::tet;

// Codes of the errors that are not TetGen's own (1 memory, 2 internal, 3 self-intersection,
// 4 small feature, 5 close facets, 10 input).
constexpr int memory_code = 1;
constexpr int internal_code = 2;
constexpr int input_code = 10;
constexpr int protocol_code = 101;

int answer_descriptor = -1;

// TetGen writes the triangles that it leaves out into two files.
const std::string &left_out_files() {
    static const std::string prefix =
        std::filesystem::temp_directory_path().string() + "/nmgs-tet-" + std::to_string(::getpid());
    return prefix;
}

// Says which triangles were left out, each by its nodes, on standard error as TetGen's own words
// are.
void tell_left_out() {
    std::ifstream file(left_out_files() + "_skipped.face");
    std::string line;
    std::getline(file, line); // how many there are
    long number = 0;
    long a = 0;
    long b = 0;
    long c = 0;
    while (std::getline(file, line) && std::istringstream(line) >> number >> a >> b >> c) {
        std::fprintf(stderr, "left out [%ld, %ld, %ld]\n", a, b, c);
    }
}

void remove_left_out_files() {
    for (const char *ending : {"_skipped.node", "_skipped.face", "_skipped_skipped.face"}) {
        std::error_code ignored;
        std::filesystem::remove(left_out_files() + ending, ignored);
    }
}

// Ends the process once all is said. Neither destructors nor exit handlers run: freeing a large
// mesh piece by piece takes longer than the system does.
[[noreturn]] void leave(int status) {
    std::fflush(stdout);
    std::fflush(stderr);
    remove_left_out_files();
    std::_Exit(status);
}

[[noreturn]] void leave_with_error(int code, const std::string &text) {
    std::fflush(stdout);
    write_text(answer_descriptor, Kind::error, text, code);
    leave(EXIT_FAILURE);
}

// TetGen calls exit() in places; leave() does not come here.
void on_exit() {
    leave_with_error(internal_code, "TetGen ended the process");
}

void run(const Request &request) {
    Input input(request);
    std::string switches = request.text(In::switches);
    tetgenbehavior behavior;
    if (!behavior.parse_commandline(switches.data())) {
        throw input_code;
    }
    if (left_out_files().size() < sizeof behavior.outfilename) {
        std::strcpy(behavior.outfilename, left_out_files().c_str());
    }
    // Of an STL file's facets TetGen drops the repeated points early; with -Y its mesh differs.
    if (const std::int32_t *stl = request.ints(In::stl); stl != nullptr && *stl != 0) {
        behavior.object = tetgenbehavior::STL;
    }
    tetgenio result;
    tetrahedralize(&behavior, &input.main, &result,
                   input.added.numberofpoints > 0 ? &input.added : nullptr,
                   input.background.numberofpoints > 0 ? &input.background : nullptr);
    std::fflush(stdout);
    write_result(answer_descriptor, result);
    write_text(answer_descriptor, Kind::done, "");
    leave(EXIT_SUCCESS);
}

} // namespace

int main(int argc, char **argv) {
    if (argc == 2 && std::string_view(argv[1]) == "--version") {
        std::puts(NMGS_TETGEN_VERSION);
        return EXIT_SUCCESS;
    }
    if (argc > 1) {
        std::fputs("nmgs-tet, the TetGen worker of the NMGS Workbench, reads a request from its "
                   "standard input; --version tells TetGen's version\n",
                   stderr);
        return EXIT_FAILURE;
    }
    // TetGen prints to standard output: what it says goes to standard error, line by line.
    answer_descriptor = ::dup(STDOUT_FILENO);
    ::dup2(STDERR_FILENO, STDOUT_FILENO);
    std::setvbuf(stdout, nullptr, _IOLBF, BUFSIZ);
    forbid_core_files();
    std::atexit(on_exit);
    write_text(answer_descriptor, Kind::hello, NMGS_TETGEN_VERSION,
               static_cast<std::int32_t>(protocol_version));
    try {
        start_life_line(STDIN_FILENO);
        const Request request = read_request(STDIN_FILENO);
        guard_life_line();
        run(request);
    } catch (const EndOfInput &) {
        leave(EXIT_FAILURE);
    } catch (const ProtocolError &e) {
        leave_with_error(protocol_code, e.what());
    } catch (const InputError &e) {
        leave_with_error(input_code, e.what());
    } catch (const std::bad_alloc &) {
        leave_with_error(memory_code, "not enough memory");
    } catch (const std::exception &e) {
        leave_with_error(internal_code, e.what());
    } catch (int code) { // TetGen's way to stop
        tell_left_out();
        leave_with_error(code, "");
    }
}
