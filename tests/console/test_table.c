/* Tables of texts: for people, as Markdown, as tab-separated values. */

#include "console/message.h"
#include "console/table.h"

#include "support/said.h"
#include "unity.h"

#include <string.h>

void setUp(void)
{
}

void tearDown(void)
{
}

static void check_printed(const char *expected, FILE *stream, table_format format)
{
    static const char *const names[FORMAT_COUNT] = {"text", "markdown", "tsv"};
    char printed[1000];
    rewind(stream);
    printed[fread(printed, 1, sizeof printed - 1, stream)] = '\0';
    fclose(stream);
    TEST_ASSERT_EQUAL_STRING_MESSAGE(expected, printed, names[format]);
}

/* Fills a table. */
typedef void filling(table *table);

static void check_table(filling *fill, const char *const expected[FORMAT_COUNT])
{
    for (int i = 0; i < FORMAT_COUNT; i++) {
        table table = TABLE_EMPTY;
        FILE *stream = stream_of("", 0);
        fill(&table);
        TEST_ASSERT_TRUE(table_finish(&table, NULL, NULL, (table_format)i, stream));
        TEST_ASSERT_NULL(table.rows);
        check_printed(expected[i], stream, (table_format)i);
    }
}

static void fill_three(table *table)
{
    table_add(table, "name\tx\tlength");
    table_add(table, "a\t%d\t%.1f", 7, 12345.5);
    table_add(table, "longer");
    table_add(table, "%s", "");
    table_add_cells(table, "\t%d", 2);
    table_add_cells(table, "%s", "not in the head");
}

static void test_three_formats(void)
{
    /* the second column is three wide: so wide has Markdown's rule to be */
    check_table(fill_three, (const char *const[]){"  name      x   length\n"
                                                  "  a         7  12345.5\n"
                                                  "  longer              \n"
                                                  "                     2\n",
                                                  "| name   |   x |  length |\n"
                                                  "|--------|----:|--------:|\n"
                                                  "| a      |   7 | 12345.5 |\n"
                                                  "| longer |     |         |\n"
                                                  "|        |     |       2 |\n",
                                                  "name\tx\tlength\n"
                                                  "a\t7\t12345.5\n"
                                                  "longer\t\t\n"
                                                  "\t\t2\n"});
}

static void fill_nothing(table *table)
{
    (void)table;
}

static void test_a_table_without_rows(void)
{
    check_table(fill_nothing, (const char *const[]){"", "", ""});
}

static void test_what_is_too_long_or_too_many_is_cut(void)
{
    table table = TABLE_EMPTY;
    table_add(&table, "%0*d\tb\tc", 2 * TABLE_CELL, 1);
    TEST_ASSERT_EQUAL_UINT(3, table.n_columns);
    TEST_ASSERT_EQUAL_UINT(TABLE_CELL - 1, strlen(table.rows[0].cells[0]));
    TEST_ASSERT_EQUAL_STRING("b", table.rows[0].cells[1]);
    for (int i = 3; i < TABLE_COLUMNS; i++) {
        table_add_cells(&table, "%d", i);
    }
    const table_row before = table.rows[0];
    table_add_cells(&table, "%d", TABLE_COLUMNS);
    TEST_ASSERT_EQUAL_UINT(TABLE_COLUMNS, table.n_columns);
    TEST_ASSERT_EQUAL_MEMORY(&before, &table.rows[0], sizeof before);
    FILE *stream = stream_of("", 0);
    table.failed = true; /* as where a row finds no memory */
    table_add(&table, "another");
    TEST_ASSERT_EQUAL_UINT(1, table.n_rows);
    TEST_ASSERT_FALSE(table_finish(&table, "Title", NULL, FORMAT_TEXT, stream));
    check_printed("", stream, FORMAT_TEXT);
    TEST_ASSERT_NULL(table.rows);
}

static void test_titles(void)
{
    static const char *const plain[FORMAT_COUNT] = {"\nTitle\n\n", "\n### Title\n\n", "# Title\n"};
    static const char *const more[FORMAT_COUNT] = {"\nTitle\nA remark.\n\n", "\n### Title\n\nA remark.\n\n",
                                                   "# Title\n# A remark.\n"};
    for (int i = 0; i < FORMAT_COUNT; i++) {
        FILE *stream = stream_of("", 0);
        table_print_title("Title", NULL, (table_format)i, stream);
        check_printed(plain[i], stream, (table_format)i);
        stream = stream_of("", 0);
        table_print_title("Title", "A remark.", (table_format)i, stream);
        check_printed(more[i], stream, (table_format)i);
        stream = stream_of("", 0);
        table table = TABLE_EMPTY;
        TEST_ASSERT_TRUE(table_finish(&table, "Title", "A remark.", (table_format)i, stream));
        check_printed(more[i], stream, (table_format)i);
    }
}

static void test_names_of_formats(void)
{
    table_format format = FORMAT_COUNT;
    said said;
    TEST_ASSERT_TRUE(table_format_parse("text", &format));
    TEST_ASSERT_EQUAL_INT(FORMAT_TEXT, format);
    TEST_ASSERT_TRUE(table_format_parse("markdown", &format));
    TEST_ASSERT_EQUAL_INT(FORMAT_MARKDOWN, format);
    TEST_ASSERT_TRUE(table_format_parse("tsv", &format));
    TEST_ASSERT_EQUAL_INT(FORMAT_TSV, format);
    said_begin();
    const bool known = table_format_parse("html", &format);
    said_end(&said);
    TEST_ASSERT_FALSE(known);
    TEST_ASSERT_EQUAL_INT(FORMAT_TSV, format);
    TEST_ASSERT_EQUAL_STRING("test: --format: unknown format \"html\"; expected text, markdown or tsv\n", said.text);
}

static void check_text(table *table, const char *expected)
{
    FILE *stream = stream_of("", 0);
    TEST_ASSERT_TRUE(table_finish(table, NULL, NULL, FORMAT_TEXT, stream));
    check_printed(expected, stream, FORMAT_TEXT);
}

/* 2 + 4 + 2 + 21 + 2 + 21 + 2 + 19 = 73: a column of five has room, one of six has not. */
static void test_what_is_wider_than_a_line_comes_in_parts(void)
{
    table table = TABLE_EMPTY;
    table_add(&table, "name\ttwenty-characters-one\ttwenty-characters-two\ttwenty-characters-3\t5five");
    table_add(&table, "a\t1\t2\t3\t4");
    check_text(&table, "  name  twenty-characters-one  twenty-characters-two  twenty-characters-3  5five\n"
                       "  a                         1                      2                    3      4\n");
    table_add(&table, "name\ttwenty-characters-one\ttwenty-characters-two\ttwenty-characters-3\tsixsix");
    table_add(&table, "a\t1\t2\t3\t4");
    check_text(&table, "  name  twenty-characters-one  twenty-characters-two  twenty-characters-3\n"
                       "  a                         1                      2                    3\n\n"
                       "  name  sixsix\n  a          4\n");
}

/* Of a table that is about two columns both stand in each part; 2 + 4 + 2 + 4 + 2 + 30 + 2 + 30 = 76. */
static void fill_with_two_keys(table *table)
{
    table->n_more = 1;
    table_add(table, "link\twhat\t%030d\t%030d\tlast", 1, 2);
    table_add(table, "0\ta\t1\t2\t3");
}

static void test_what_rows_are_about_is_in_all_parts(void)
{
    table table = TABLE_EMPTY;
    check_table(fill_with_two_keys, (const char *const[]){
        "  link  what  000000000000000000000000000001  000000000000000000000000000002\n"
        "  0        a                               1                               2\n\n"
        "  link  what  last\n"
        "  0        a     3\n",
        "| link | what | 000000000000000000000000000001 | 000000000000000000000000000002 | last |\n"
        "|------|-----:|-------------------------------:|-------------------------------:|-----:|\n"
        "| 0    |    a |                              1 |                              2 |    3 |\n",
        "link\twhat\t000000000000000000000000000001\t000000000000000000000000000002\tlast\n"
        "0\ta\t1\t2\t3\n"});
    table.n_more = 1; /* and nothing else */
    table_add(&table, "link\twhat");
    check_text(&table, "  link  what\n");
}

/* As many as a line has, in characters, which are not bytes. */
static void test_a_line_holds_eighty_characters(void)
{
    table table = TABLE_EMPTY;
    table_add(&table, "\xc3\xbc\xc3\xbc\xc3\xbc\xc3\xbc\t%030d\t%040d", 1, 2); /* 2 + 4 + 2 + 30 + 2 + 40 = 80 */
    check_text(&table, "  \xc3\xbc\xc3\xbc\xc3\xbc\xc3\xbc  000000000000000000000000000001  "
                       "0000000000000000000000000000000000000002\n");
    table_add(&table, "a\t%030d\t%044d", 1, 2); /* a first column of three, and one character more */
    check_text(&table, "  a    000000000000000000000000000001\n\n"
                       "  a    00000000000000000000000000000000000000000002\n");
}

/* Names may lose their ends where the rest then has room, and not where it has none. */
static void test_names_are_cut_where_that_is_enough(void)
{
    table table = {.cut_first = true};
    table_add(&table, "name\t%030d\t%030d", 1, 2);
    table_add(&table, "abc\xc3\xbc" "efghijklmnop\t3\t4"); /* 2 + 16 + 64 = 82: two have to go, and two are dots */
    table_add(&table, "abc\t5\t6");
    check_text(&table, "  name            000000000000000000000000000001  000000000000000000000000000002\n"
                       "  abc\xc3\xbc" "efghijkl..                               3                               4\n"
                       "  abc                                          5                               6\n");
    table.cut_first = true;
    table_add(&table, "abcdefghijk\t%040d\t%034d", 1, 2); /* it would be six characters then */
    check_text(&table, "  abcdefghijk  0000000000000000000000000000000000000001\n\n"
                       "  abcdefghijk  0000000000000000000000000000000002\n");
}

int main(void)
{
    message_start("test");
    UNITY_BEGIN();
    RUN_TEST(test_three_formats);
    RUN_TEST(test_a_table_without_rows);
    RUN_TEST(test_what_is_too_long_or_too_many_is_cut);
    RUN_TEST(test_titles);
    RUN_TEST(test_names_of_formats);
    RUN_TEST(test_what_is_wider_than_a_line_comes_in_parts);
    RUN_TEST(test_what_rows_are_about_is_in_all_parts);
    RUN_TEST(test_a_line_holds_eighty_characters);
    RUN_TEST(test_names_are_cut_where_that_is_enough);
    return UNITY_END();
}
