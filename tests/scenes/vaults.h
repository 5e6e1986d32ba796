/* Vaults with mortar that are known by their numbers: each joint has strengths of its own, or none. All of it is static. */
#ifndef VAULTS_H
#define VAULTS_H

#include "../test.h"
#include "gen.h"

#include <math.h>

/* Vault number k, and a direction to push it. */
static void numbered_vault(uint32_t k, sp_scene *s, double push[3])
{
    uint32_t draws = 2654435769u * (k + 1);
    gen_scene g;
    double weight_of_all = 0;
    for (int i = 0; i < 5; i++) (void)test_draw(&draws, 0, 1);
    gen_open(&g, "vault");
    gen_set(&g, "around", 3 + (int)test_draw(&draws, 0, 5));
    gen_set(&g, "n", 2 + (int)test_draw(&draws, 0, 2));
    gen_set(&g, "t", test_draw(&draws, 0.15, 0.4));
    gen_set(&g, "half", test_draw(&draws, 30, 70));
    gen_set(&g, "seed", 1 + (int)test_draw(&draws, 0, 900));
    gen_set(&g, "jitter", test_draw(&draws, 0, 0.4));
    test_arena.used = 0;
    if (!CHECK_INT(gen_build(&g, &test_arena, s), SP_OK)) return;
    for (int32_t i = 0; i < s->count.blocks; i++) weight_of_all += 9.8 * (double)s->block[i].mass;
    for (int32_t j = 0; j < s->count.joints; j++) {
        sp_strength *t = &s->joint[j].strength;
        if (test_draw(&draws, 0, 1) < 0.2) continue;
        const double stress = weight_of_all / s->count.blocks / 0.05 * pow(10, test_draw(&draws, -1, 1));
        if (test_draw(&draws, 0, 1) < 0.7) t->cohesion = R(stress * test_draw(&draws, 0.01, 1));
        if (test_draw(&draws, 0, 1) < 0.5 && t->cohesion > 0) t->tension = R(stress * test_draw(&draws, 0.01, 0.5));
        if (test_draw(&draws, 0, 1) < 0.7) t->crushing = R(stress * pow(10, test_draw(&draws, 1, 2)));
    }
    for (int c = 0; c < 3; c++) push[c] = test_draw(&draws, -10, 10);
}

#endif /* VAULTS_H */
