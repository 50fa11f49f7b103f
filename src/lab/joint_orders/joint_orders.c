/* joint-orders: which orders of steps and which precisions give the paper's joint values. */

#include "armtol/armtol.h"
#include "console/exit_code.h"
#include "console/message.h"
#include "console/rounding.h"
#include "lab/joint_orders/options.h"

#include <stdio.h>

static bool run_and_print(survey surveys[FAMILIES], const orders_options *options)
{
    bool needed = false, fine = true;
    for (int part = 0; part < PART_COUNT; part++) { /* these two have no need of a survey */
        needed = needed || (options->show[part] && part != PART_FAMILY && part != PART_MARGINS);
    }
    for (int i = 0; i < FAMILIES && fine && needed; i++) {
        fine = survey_run(&surveys[i], &options->given[i]);
    }
    for (int part = 0; part < PART_COUNT && fine; part++) {
        fine = !options->show[part] || orders_print((orders_part)part, surveys, options->format);
    }
    return fine;
}

static int survey_families(const published_list *list, const orders_options *options)
{
    survey surveys[FAMILIES];
    for (int i = 0; i < FAMILIES; i++) {
        if (!survey_start(&surveys[i], list, families[i])) {
            return EXIT_WRONG;
        }
    }
    const bool fine = run_and_print(surveys, options);
    for (int i = 0; i < FAMILIES; i++) {
        survey_free(&surveys[i]);
    }
    return fine ? EXIT_OK : EXIT_FAILED;
}

static int read_and_survey(const orders_options *options)
{
    published_list list;
    const int code = published_read(options->published, &list) ? survey_families(&list, options) : EXIT_WRONG;
    published_free(&list);
    return code;
}

static int act(const orders_options *options)
{
    switch (options->action) {
    case ORDERS_HELP:
        orders_options_help();
        return EXIT_OK;
    case ORDERS_VERSION:
        printf("joint-orders (armtol) %s\n", armtol_version());
        return EXIT_OK;
    default:
        return read_and_survey(options);
    }
}

int main(int argc, char *argv[])
{
    orders_options options;
    rounding_to_double();
    message_start("joint-orders");
    const int code = orders_options_parse(argc, argv, &options);
    return exit_code_of_output(code == EXIT_OK ? act(&options) : code);
}
