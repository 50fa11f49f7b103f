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

static void check_table(const table *table, const char *const expected[FORMAT_COUNT])
{
    for (int i = 0; i < FORMAT_COUNT; i++) {
        FILE *stream = stream_of("", 0);
        table_print(table, (table_format)i, stream);
        check_printed(expected[i], stream, (table_format)i);
    }
}

static void test_three_formats(void)
{
    static const char *const head[] = {"name", "x", "length"};
    table table;
    table_start(&table, 3);
    TEST_ASSERT_TRUE(table_add_head(&table, head));
    table_row *row = table_add(&table, "a");
    TEST_ASSERT_NOT_NULL(row);
    table_set(row, 1, "%d", 7);
    table_set(row, 2, "%.1f", 12345.5);
    TEST_ASSERT_NOT_NULL(table_add(&table, "longer"));
    /* the second column is three wide: so wide has Markdown's rule to be */
    check_table(&table, (const char *const[]){"  name      x   length\n"
                                              "  a         7  12345.5\n"
                                              "  longer              \n",
                                              "| name   |   x |  length |\n"
                                              "|--------|----:|--------:|\n"
                                              "| a      |   7 | 12345.5 |\n"
                                              "| longer |     |         |\n",
                                              "name\tx\tlength\n"
                                              "a\t7\t12345.5\n"
                                              "longer\t\t\n"});
    table_free(&table);
    TEST_ASSERT_NULL(table.rows);
}

static void test_a_table_without_rows(void)
{
    table table;
    table_start(&table, 2);
    check_table(&table, (const char *const[]){"", "", ""});
    table_free(&table);
}

static void test_what_is_too_long_or_too_many_is_cut(void)
{
    table table;
    table_start(&table, TABLE_COLUMNS + 1);
    TEST_ASSERT_EQUAL_UINT(TABLE_COLUMNS, table.n_columns);
    table_row *row = table_add(&table, "");
    TEST_ASSERT_NOT_NULL(row);
    table_set(row, TABLE_COLUMNS - 1, "%0*d", 2 * TABLE_CELL, 1);
    TEST_ASSERT_EQUAL_UINT(TABLE_CELL - 1, strlen(row->cells[TABLE_COLUMNS - 1]));
    const table_row before = *row;
    table_set(row, TABLE_COLUMNS, "%d", 1);
    TEST_ASSERT_EQUAL_MEMORY(&before, row, sizeof before);
    table_free(&table);
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

int main(void)
{
    message_start("test");
    UNITY_BEGIN();
    RUN_TEST(test_three_formats);
    RUN_TEST(test_a_table_without_rows);
    RUN_TEST(test_what_is_too_long_or_too_many_is_cut);
    RUN_TEST(test_titles);
    RUN_TEST(test_names_of_formats);
    return UNITY_END();
}
