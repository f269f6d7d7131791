/* A process with the stock C client: see OurPeer.java. */
#include <inttypes.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include <lcm/lcm.h>

static int received, bad, ended;

static void on_message(const lcm_recv_buf_t *buffer, const char *channel, void *user)
{
    const uint8_t *data = buffer->data;
    received++;
    for (uint32_t at = 0; at < buffer->data_size; at++)
        if (data[at] != (uint8_t) (at * 31 + data[0])) {
            bad++;
            break;
        }
}

static void on_end(const lcm_recv_buf_t *buffer, const char *channel, void *user)
{
    ended = 1;
}

static int send_all(lcm_t *lcm, char **arguments)
{
    const int count = atoi(arguments[2]), pause = atoi(arguments[3]);
    uint32_t sizes[16], number = 0;
    for (char *size = strtok(arguments[1], ","); size && number < 16; size = strtok(NULL, ","))
        sizes[number++] = atoi(size);
    uint8_t *data = malloc(1 << 24);
    puts("ready");
    fflush(stdout);
    getchar();
    for (int i = 0; i < count; i++) {
        const uint32_t size = sizes[i % number];
        for (uint32_t at = 0; at < size; at++)
            data[at] = at * 31 + i;
        lcm_publish(lcm, arguments[0], data, size);
        usleep(pause);
    }
    printf("sent %d\n", count);
    fflush(stdout);
    for (;;) {
        lcm_publish(lcm, "END", data, 4);
        usleep(50000);
    }
}

static int receive_all(lcm_t *lcm, const char *channels)
{
    lcm_subscription_set_queue_capacity(lcm_subscribe(lcm, channels, on_message, NULL), 0);
    lcm_subscribe(lcm, "END", on_end, NULL);
    puts("ready");
    fflush(stdout);
    while (!ended)
        lcm_handle(lcm);
    printf("received %d bad %d\n", received, bad);
    return 0;
}

int main(int count, char **arguments)
{
    lcm_t *lcm = lcm_create(arguments[1]);
    if (!lcm)
        return 1;
    return strcmp(arguments[2], "send") == 0 ? send_all(lcm, arguments + 3) : receive_all(lcm, arguments[3]);
}
