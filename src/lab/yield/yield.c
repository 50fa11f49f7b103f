/* yield: what arms built to the tolerances of 1987, and to the corrected ones, do. */

#include "armtol/armtol.h"
#include "console/exit_code.h"
#include "console/message.h"
#include "console/rounding.h"
#include "lab/published.h"
#include "lab/yield/options.h"
#include "lab/yield/tables.h"

#include <stdio.h>
#include <stdlib.h>

static int run_cases(const published_list *list, const yield_options *options, yield_case cases[])
{
    size_t done = 0;
    for (size_t i = 0; i < list->count; i++) {
        if (published_begins_case(list, i)) {
            const int code = yield_case_run(list, i, options, &cases[done++]);
            if (code != EXIT_OK) {
                return code;
            }
        }
    }
    return yield_tables_print(cases, done, options) ? EXIT_OK : EXIT_FAILED;
}

static int run(const published_list *list, const yield_options *options)
{
    yield_case *cases = calloc(list->count, sizeof *cases); /* no more than there are numbers */
    if (cases == NULL) {
        out_of_memory();
        return EXIT_FAILED;
    }
    const int code = run_cases(list, options, cases);
    free(cases);
    return code;
}

static int read_and_run(const yield_options *options)
{
    published_list list;
    const int code = published_read(options->published, &list) ? run(&list, options) : EXIT_WRONG;
    published_free(&list);
    return code;
}

static int act(const yield_options *options)
{
    switch (options->action) {
    case YIELD_HELP:
        yield_options_help();
        return EXIT_OK;
    case YIELD_VERSION:
        printf("yield (armtol) %s\n", armtol_version());
        return EXIT_OK;
    default:
        return read_and_run(options);
    }
}

int main(int argc, char *argv[])
{
    yield_options options;
    rounding_to_double();
    message_start("yield");
    const int code = yield_options_parse(argc, argv, &options);
    return exit_code_of_output(code == EXIT_OK ? act(&options) : code);
}
