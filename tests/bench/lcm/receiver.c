/* Counts messages with the stock C client and says at each end what came: see BenchReceiver.java. */
#include <inttypes.h>
#include <stdint.h>
#include <stdio.h>
#include <time.h>

#include <lcm/lcm.h>

static uint64_t messages, bytes, first, last;
static uint8_t told;

static uint64_t now(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (uint64_t) t.tv_sec * 1000000000u + (uint64_t) t.tv_nsec;
}

static void on_data(const lcm_recv_buf_t *buffer, const char *channel, void *user)
{
    (void) channel, (void) user;
    last = now();
    if (messages++ == 0)
        first = last;
    bytes += buffer->data_size;
}

static void on_end(const lcm_recv_buf_t *buffer, const char *channel, void *user)
{
    (void) channel, (void) user;
    if (buffer->data_size == 0 || *(const uint8_t *) buffer->data == told)
        return;
    told = *(const uint8_t *) buffer->data;
    printf("{\"messages\": %" PRIu64 ", \"bytes\": %" PRIu64 ", \"seconds\": %.9f}\n", messages, bytes, (double) (last - first) / 1e9);
    fflush(stdout);
    messages = bytes = first = last = 0;
}

int main(int count, char **arguments)
{
    lcm_t *lcm = count > 1 ? lcm_create(arguments[1]) : NULL;
    if (!lcm)
        return 1;
    lcm_subscription_set_queue_capacity(lcm_subscribe(lcm, "DATA", on_data, NULL), 0);
    lcm_subscribe(lcm, "END", on_end, NULL);
    puts("\"ready\"");
    fflush(stdout);
    while (lcm_handle(lcm) == 0)
        ;
    return 0;
}
