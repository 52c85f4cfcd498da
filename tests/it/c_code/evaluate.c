#include <stdio.h>
#include <string.h>

#include "name.h"

static name_model model;
static double in[IN], out[OUT];
DECLARED
int main(void) {
    const double *const more = in + MORE;
    (void)more;
    if (name_new(&model, &name_defaults) != 0) return 1;
    while (fread(in, sizeof in, 1, stdin) == 1) {
        CALLS
        fwrite(out, sizeof out, 1, stdout);
    }
    return 0;
}
