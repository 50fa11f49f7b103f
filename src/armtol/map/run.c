#include "armtol/map/run.h"

#include "armtol/map/output.h"
#include "armtol/map/rows.h"
#include "console/exit_code.h"
#include "console/message.h"
#include "files/outfile.h"

static bool write_one(const char *path, void (*write)(FILE *stream, const void *data), const map_findings *findings)
{
    return path == NULL || outfile_write(path, write, findings);
}

static int tell(const map_findings *findings)
{
    const cli_options *options = findings->plan->request->options;
    const bool standard = outfile_is_standard(options->svg) || outfile_is_standard(options->map.tsv);
    if (!write_one(options->svg, map_write_svg, findings) || !write_one(options->map.tsv, map_write_tsv, findings)) {
        return EXIT_FAILED;
    }
    if (options->format == OUTPUT_JSON) {
        return map_print_json(findings) ? EXIT_OK : EXIT_FAILED;
    }
    if (!standard) {
        map_print_text(findings);
    }
    return EXIT_OK;
}

/* What a picture needs is there before a file is begun. */
static int draw_and_tell(const map_plan *plan, const map_found *found)
{
    sheet sheet;
    if (plan->request->options->svg == NULL) {
        return tell(&(map_findings){plan, found, NULL});
    }
    if (!sheet_make(&sheet, plan, found)) {
        return EXIT_FAILED;
    }
    const int code = tell(&(map_findings){plan, found, &sheet});
    sheet_free(&sheet);
    return code;
}

static bool is_one_output(const cli_options *options)
{
    const int n = outfile_is_standard(options->svg) + outfile_is_standard(options->map.tsv) +
                  (options->format == OUTPUT_JSON);
    if (n > 1) {
        message("--svg -, --tsv - and --json exclude each other: there is one standard output");
    }
    return n <= 1;
}

static int find_and_tell(const map_plan *plan, const merged *merged)
{
    map_found found;
    int code = merged != NULL ? rows_merge(plan, merged, &found) : map_find(plan, NULL, &found);
    if (code == EXIT_OK) {
        code = draw_and_tell(plan, &found);
        map_found_free(&found);
    }
    return code;
}

int map_run(const request *request, const merged *merged)
{
    map_plan plan;
    if (!is_one_output(request->options)) {
        return EXIT_WRONG;
    }
    int code = map_plan_make(&plan, request);
    if (code != EXIT_OK) {
        return code;
    }
    code = request->options->shard != 0 && merged == NULL ? rows_shard(&plan) : find_and_tell(&plan, merged);
    map_plan_free(&plan);
    return code;
}
