/* A stored answer as any text: `verify` reads it against a scene and ends with one of its statuses. */
#include "fuzz.h"
#include "../../port/host/command/commands.h"
#include "../../port/host/files/json_in.h"

#include <fcntl.h>
#include <unistd.h>
#include <sys/mman.h>

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    static int fd = -1;
    static char path[64], name[] = "stonepack", command[] = "verify", bundled[] = "tests/scenes/two-cubes.obj";
    json_tree tree;
    failure why;
    if (size > 20000) return 0;
    if (fd < 0) {
        fd = memfd_create("json", 0);
        snprintf(path, sizeof path, "/proc/self/fd/%d", fd);
        const int nothing = open("/dev/null", O_WRONLY);
        if (nothing < 0 || dup2(nothing, 1) < 0) abort();
    }
    char *text = malloc(size + 1);
    if (!text) abort();
    memcpy(text, data, size);
    text[size] = 0;
    memset(&tree, 0, sizeof tree);
    memset(&why, 0, sizeof why);
    const int status = json_parse("fuzz", text, size, &tree, &why);
    HOLDS(status == 0 || why.line[0], "status %d without a line", status);
    json_free(&tree);
    if (ftruncate(fd, 0) || pwrite(fd, data, size, 0) != (ssize_t)size) abort();
    char *argv[] = { name, command, bundled, path, NULL };
    const int end = command_verify(4, argv);
    HOLDS((end >= 0 && end <= 2) || (end >= 64 && end <= 66), "verify ends with %d", end);
    return 0;
}
