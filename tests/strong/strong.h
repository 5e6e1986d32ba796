/* The question of a strong verdict, asked and judged. All of it is static. */
#ifndef STRONG_H
#define STRONG_H

#include "../test.h"
#include "../scenes/gen.h"
#include "../scenes/change.h"
#include "stool.h"

#include <string.h>

/* The answer of a scene, in the memory that it says it takes; sp_strong_verify proves the same from the evidence alone. */
static sp_strong_result ask(const sp_scene *s, const sp_strong_settings *how)
{
    sp_strong_result r;
    sp_strong_kind proved = SP_STRONG_NONE;
    memset(&r, 0, sizeof r);
    sp_settings set = sp_settings_default();
    sp_result x, pressed;
    sp_settings spare = set;
    spare.budget = 200000000;                           /* enough for all that is asked here; a board's day is short */
    CHECK_INT(sp_check(s, &set, &test_arena, &x), SP_OK);
    set.effect[SP_EFFECT_FRICTION] = SP_WITHOUT;
    CHECK_INT(sp_check(s, &set, &test_arena, &pressed), SP_OK);
    const sp_real *level = pressed.verdict == SP_STABLE ? pressed.f : NULL;
    if (!CHECK_INT(sp_strong(s, &spare, how, x.f, level, &test_arena, &r), SP_OK)) return r;
    CHECK_INT(sp_strong_verify(s, NULL, &r, test_arena, &proved), SP_OK);
    CHECK_INT(proved, r.kind);
    CHECK((r.kind == SP_STRONG_NONE) == (x.verdict != SP_STABLE));
    return r;
}

/* The answer of a generated scene, one number changed. */
static sp_strong_result of(const char *name, const char *param, double value)
{
    sp_scene s;
    test_arena.used = 0;
    CHECK_INT(gen_make(name, param, value, &test_arena, &s), SP_OK);
    return ask(&s, NULL);
}

#endif /* STRONG_H */
