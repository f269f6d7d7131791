/* Sends messages: URL, then on each line of input SIZE COUNT PAUSE, in microseconds between two; says for a while that this was all, and then "sent". */
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>

#include <lcm/lcm.h>

/* So long a receiver waits for missing fragments at most, and then has counted what it lost: only where nothing is timed. */
enum { ENDS = 15, BETWEEN_ENDS_US = 40000, AFTER_PACED_US = 1200000 };

int main(int count, char **arguments)
{
    lcm_t *lcm = count > 1 ? lcm_create(arguments[1]) : NULL;
    uint8_t *data = calloc(1, 1 << 24);
    unsigned size, messages, pause, flood = 0;
    if (!lcm || !data)
        return 1;
    while (scanf("%u %u %u", &size, &messages, &pause) == 3) {
        for (unsigned i = 0; i < messages; i++) {
            lcm_publish(lcm, "DATA", data, size);
            if (pause > 0)
                usleep(pause);
        }
        if (pause > 0)
            usleep(AFTER_PACED_US);
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
