/* Sends messages as fast as it can: URL, then on each line of input SIZE COUNT; says "sent", and then for a while that this was all. */
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>

#include <lcm/lcm.h>

enum { ENDS = 15, BETWEEN_ENDS_US = 40000 };

int main(int count, char **arguments)
{
    lcm_t *lcm = count > 1 ? lcm_create(arguments[1]) : NULL;
    uint8_t *data = calloc(1, 1 << 24);
    unsigned size, messages, flood = 0;
    if (!lcm || !data)
        return 1;
    while (scanf("%u %u", &size, &messages) == 2) {
        for (unsigned i = 0; i < messages; i++)
            lcm_publish(lcm, "DATA", data, size);
        data[0] = (uint8_t) ++flood;
        for (unsigned i = 0; i < ENDS; i++) {
            usleep(BETWEEN_ENDS_US);
            lcm_publish(lcm, "END", data, 4);
        }
        puts("\"sent\"");
        fflush(stdout);
    }
    return 0;
}
