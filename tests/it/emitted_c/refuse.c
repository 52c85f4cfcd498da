#include <stdio.h>

#include "name.h"

int main(void) {
    name_params params;
    name_model model;
    while (fread(&params, sizeof params, 1, stdin) == 1) {
        const int code = name_new(&model, &params);
        if (code < NAME_CONSTANT) {
            printf("%s\n", name_error(code));
        } else {
            printf("%s %d\n", name_error(code), code - NAME_CONSTANT);
        }
    }
    return 0;
}
