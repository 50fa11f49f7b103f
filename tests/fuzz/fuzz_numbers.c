/*
 * Numbers and lists of them: the first byte says which reader. What is taken is the number that the C library reads
 * from the whole text, and what is written is read as the same number again.
 */

#include "fuzz/harness.h"
#include "fuzz/require.h"

#include "armtol/ask/given.h"
#include "armtol/ask/number_list.h"
#include "armtol/ask/weights.h"
#include "armtol/tables/degrees.h"
#include "armtol/wish/accuracy.h"
#include "console/message.h"
#include "console/number.h"

#include <float.h>
#include <math.h>
#include <string.h>

enum { MOST_BYTES = 4096, MOST_NUMBERS = 6 };

/* For the names of --weights. */
enum { MOST_COLUMNS = 64 };
static const armtol_arm *arm;
static armtol_column columns[MOST_COLUMNS];
static size_t n_columns;

static bool same(double one, double other)
{
    return memcmp(&one, &other, sizeof one) == 0;
}

/* The neighbours of a double are the same number but for its last digit. */
static bool is_near(double expected, double actual)
{
    return actual == expected || actual == nextafter(expected, -(double)INFINITY) ||
           actual == nextafter(expected, (double)INFINITY);
}

/* ---- one number ---- */

/* Long doubles have 64 bits where degrees matter here; elsewhere nothing is said. */
static void check_degrees(const char *text, double value)
{
    const double radians = degrees_parse(text);
    REQUIRE(isfinite(radians));
    REQUIRE(signbit(radians) == signbit(value));
    if (LDBL_MANT_DIG >= 64 && fabs(value) > 1e-280) {
        const long double degree = 3.14159265358979323846264338327950288L / 180;
        REQUIRE(is_near((double)(strtold(text, NULL) * degree), radians));
    }
}

static void check_written(double value)
{
    number_text text;
    double again;
    REQUIRE(number_parse(number_shortest(value, &armtol_errata_none, &text), &again) == NUMBER_FINE);
    REQUIRE(same(again, value));
    if (fabs(value) <= LARGEST_ANGLE) {
        REQUIRE(number_parse(degrees_shortest(value, &text), &again) == NUMBER_FINE);
        REQUIRE(fabs(value) <= 1e-280 || same(degrees_parse(text.text), value));
    }
}

static void check_number(const char *text)
{
    double value = 1987;
    const number_fault fault = number_parse(text, &value);
    REQUIRE(caught_nothing());
    if (fault != NUMBER_FINE) {
        REQUIRE(value == 1987);
        return;
    }
    char *end;
    REQUIRE(strtod(text, &end) == value && *end == '\0' && isfinite(value));
    check_degrees(text, value);
    check_written(value);
}

/* The bytes are a double as it is kept. */
static void check_bits(const char *text, size_t length)
{
    double value = 0;
    memcpy(&value, text, length < sizeof value ? length : sizeof value);
    if (isfinite(value)) {
        check_written(value);
    }
}

/* ---- lists ---- */

/* The item that the list has at *at, which moves behind it and its comma: a list taken apart once more. */
static double next_item(const char **at)
{
    char *end;
    *at += strspn(*at, " \t\n");
    const bool free = strncmp(*at, "-", 1) == 0 && strchr(" \t\n,", (*at)[1]) != NULL;
    const double value = free ? (double)INFINITY : strtod(*at, &end);
    *at = free ? *at + 1 : end;
    *at += strspn(*at, " \t\n");
    *at += **at == ',';
    return value;
}

static void check_list(const char *text)
{
    for (int i = 0; i < 2; i++) {
        double values[MOST_NUMBERS];
        const size_t count = i == 0 ? 3 : MOST_NUMBERS;
        caught_forget();
        if (!number_list_parse("--list", text, "numbers", i == 1, count, values)) {
            REQUIRE(caught_one_message());
            continue;
        }
        REQUIRE(caught_nothing());
        const char *at = text;
        for (size_t k = 0; k < count; k++) {
            REQUIRE(same(next_item(&at), values[k]));
        }
        REQUIRE(*at == '\0');
    }
}

static void check_option(const char *text)
{
    double value, positive;
    const bool fine = number_option_parse("--number", text, &value);
    REQUIRE(fine ? caught_nothing() : caught_one_message());
    caught_forget();
    const bool is_positive = number_option_positive("--number", text, &positive);
    REQUIRE(is_positive ? caught_nothing() : caught_one_message());
    REQUIRE(is_positive == (fine && value > 0));
    REQUIRE(!is_positive || same(value, positive));
}

static void check_whole(const char *text)
{
    uint64_t value = 0;
    const bool fine = whole_number_parse("--whole", text, 1, 1000000000000u, &value);
    REQUIRE(fine ? caught_nothing() : caught_one_message());
    REQUIRE(!fine || (value >= 1 && value <= 1000000000000u));
    REQUIRE(!fine || (double)value == strtod(text, NULL));
}

/* Every number that is taken is in one place, each above 0. */
static void check_accuracy(const char *text)
{
    named_accuracy accuracy;
    size_t taken, named = 0;
    caught_forget();
    if (!accuracy_parse(text, &accuracy)) {
        REQUIRE(caught_one_message());
        return;
    }
    REQUIRE(caught_nothing() && accuracy.n_norms <= ARMTOL_MOST_NORMS);
    REQUIRE(accuracy.repeatability > 0 && !(accuracy.r && accuracy.ap));
    taken = accuracy.n_norms + (isfinite(accuracy.repeatability) != 0);
    for (size_t i = 0; i < 6; i++) {
        REQUIRE(accuracy.components[i] > 0);
        taken += isfinite(accuracy.components[i]) != 0;
    }
    for (size_t i = 0; i < accuracy.n_norms; i++) {
        REQUIRE(armtol_norm_is_known(accuracy.norms[i].components));
        REQUIRE(accuracy.norms[i].limit > 0 && isfinite(accuracy.norms[i].limit));
    }
    for (; *text != '\0'; text++) {
        named += *text == '=';
    }
    REQUIRE(taken == named && taken > 0);
}

/* The weight of the last item is that of some column: it names one. */
static void check_weights(const char *text)
{
    double weights[MOST_COLUMNS];
    if (strchr(text, '=') == NULL) {
        return; /* the name of a file */
    }
    const bool fine = weights_parse(text, arm, columns, n_columns, weights);
    REQUIRE(fine ? caught_nothing() : caught_one_message());
    check_accuracy(text);
    if (!fine) {
        return;
    }
    const double last = strtod(strrchr(text, '=') + 1, NULL);
    bool any = false;
    for (size_t k = 0; k < n_columns; k++) {
        REQUIRE(weights[k] > 0 && isfinite(weights[k]));
        any = any || same(weights[k], last);
    }
    REQUIRE(any);
}

/* What is taken is said in words that are taken again. */
static void check_spreads(const char *text)
{
    static const units units = {ARMTOL_MILLIMETRE, ARMTOL_MILLIMETRE, UNIT_RADIAN};
    armtol_error_spread spreads[MOST_COLUMNS] = {{ARMTOL_UNIFORM, 0, 0, 0}};
    const named_columns of = {arm, columns, n_columns};
    if (strchr(text, '=') == NULL) {
        return; /* the name of a file */
    }
    const bool fine = given_spreads_parse(text, &of, &units, spreads, NULL);
    REQUIRE(fine ? caught_nothing() : caught_one_message());
    for (size_t k = 0; k < n_columns; k++) {
        armtol_error_spread again = {ARMTOL_UNIFORM, 0, 0, 0};
        REQUIRE(armtol_spread_is_known(&spreads[k]));
        REQUIRE(distribution_parse(distribution_words(&spreads[k], &(distribution_text){""}), &again));
        REQUIRE(again.distribution == spreads[k].distribution && same(again.sigmas, spreads[k].sigmas));
    }
}

int LLVMFuzzerInitialize(int *argc, char ***argv)
{
    (void)argc;
    (void)argv;
    caught_start("armtol");
    arm = armtol_arm_named("stanford");
    n_columns = armtol_column_count(arm->links, arm->n_links);
    REQUIRE(n_columns <= MOST_COLUMNS && armtol_columns(arm->links, arm->n_links, columns, n_columns) == ARMTOL_OK);
    return 0;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    static void (*const readers[])(const char *) = {check_number, check_list, check_option, check_whole,
                                                    check_weights};
    enum { READERS = sizeof readers / sizeof readers[0] };
    char text[MOST_BYTES + 1];
    if (size == 0) {
        return 0;
    }
    const size_t length = size - 1 < MOST_BYTES ? size - 1 : MOST_BYTES;
    memcpy(text, data + 1, length);
    text[length] = '\0';
    caught_forget();
    if (data[0] == 's') { /* the numbers of others stay: seeds have them */
        check_spreads(text);
    } else if (data[0] % (READERS + 1) == READERS) {
        check_bits(text, length);
    } else {
        readers[data[0] % (READERS + 1)](text);
    }
    return 0;
}
