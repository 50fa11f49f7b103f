#include "1987/program.h"

#include "1987/options.h"
#include "1987/session.h"
#include "console/exit_code.h"
#include "console/message.h"
#include "console/rounding.h"
#include "files/outfile.h"

#include <signal.h>

int program_main(int argc, char *argv[], const program *program)
{
    options options;
    folder folder;
    rounding_to_double();
    message_start(program->name);
    signal(SIGXFSZ, SIG_IGN); /* a file size limit is then a failed write, with a message */
    const int code = options_parse(argc, argv, &options);
    if (code != EXIT_OK) {
        return code;
    }
    if (options.action != ACTION_RUN) {
        options_answer(options.action, program);
        return exit_code_of_output(EXIT_OK);
    }
    if (!folder_open(&folder, options.folder)) {
        return EXIT_FAILED;
    }
    const int ended = session_run(program, &options, &folder);
    folder_close(&folder);
    return ended;
}
