/* Tables as CSV. Host only. */
#include "../test.h"
#include "../../port/host/files/csv_out.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* What was written must be this. */
static void ends_as(FILE *f, const char *want)
{
    char got[256];
    rewind(f);
    got[fread(got, 1, sizeof got - 1, f)] = 0;
    fclose(f);
    CHECK_TEXT(got, want);
}

TEST(text_is_quoted_where_it_has_to_be)
{
    csv_out c = { tmpfile(), 0 };
    NEED(c.out);
    csv_text(&c, "b1");
    csv_text(&c, "a,b");
    csv_text(&c, "the \"key\" stone");
    csv_text(&c, "two\nlines");
    csv_text(&c, " led by a space");
    csv_text(&c, "");
    csv_end(&c);
    ends_as(c.out, "b1,\"a,b\",\"the \"\"key\"\" stone\",\"two\nlines\",\" led by a space\",\n");
}

TEST(names_in_one_value_are_told_apart)
{
    static const char *const name[] = { "a", "b \"c\"", "d" };
    const int32_t which[] = { 2, 1 };
    csv_out c = { tmpfile(), 0 };
    NEED(c.out);
    csv_names(&c, name, which, 2);
    csv_names(&c, name, which, 0);
    csv_names(&c, name, which, 1);
    csv_end(&c);
    ends_as(c.out, "\"d;b \"\"c\"\"\",,\"d\"\n");
}

TEST(numbers_read_back_and_what_is_no_number_is_empty)
{
    csv_out c = { tmpfile(), 0 };
    const sp_real x[3] = { R(0.5), R(-2), R(1e-3) };
    NEED(c.out);
    csv_header(&c, "n,x,y,z,none,inf,nan");
    csv_int(&c, -7);
    csv_reals(&c, x, 3);
    csv_none(&c);
    csv_real(&c, (sp_real)HUGE_VAL);
    csv_real(&c, (sp_real)NAN);
    csv_end(&c);
    csv_int(&c, 8);
    csv_end(&c);
    ends_as(c.out, "n,x,y,z,none,inf,nan\n-7,0.5,-2,0.001,,,\n8\n");
}

TEST_LIST(csv_out)
    RUN(text_is_quoted_where_it_has_to_be)
    RUN(names_in_one_value_are_told_apart)
    RUN(numbers_read_back_and_what_is_no_number_is_empty)
TEST_END
