/* Reads data of a Player server over one connection, and decodes it or not: PORT decode|drain, INTERFACE:INDEX..., then for each line MESSAGES
   BYTES says how long so many took. It is written for this comparison, from the wire format, with one buffer and no allocation per message: no client
   can do less and be of use. */
#include <arpa/inet.h>
#include <endian.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/socket.h>
#include <time.h>
#include <unistd.h>

enum { HEADER = 40, BANNER = 32, ROOM = 1 << 20, MOST = 1 << 17 };

static unsigned char room[ROOM];
static size_t begin, end;
static int peer;
static float floats[MOST];
static double doubles[MOST], sum;

static double now(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double) t.tv_sec + (double) t.tv_nsec / 1e9;
}

static void need(size_t bytes)
{
    while (end - begin < bytes) {
        if (ROOM - begin < bytes || begin == end) {
            memmove(room, room + begin, end - begin);
            end -= begin;
            begin = 0;
        }
        ssize_t more = recv(peer, room + end, ROOM - end, 0);
        if (more <= 0)
            exit(1);
        end += (size_t) more;
    }
}

static uint32_t u32(const unsigned char *at)
{
    uint32_t word;
    memcpy(&word, at, 4);
    return be32toh(word);
}

static float f32(const unsigned char *at)
{
    uint32_t word = u32(at);
    float value;
    memcpy(&value, &word, 4);
    return value;
}

static double f64(const unsigned char *at)
{
    uint64_t word;
    double value;
    memcpy(&word, at, 8);
    word = be64toh(word);
    memcpy(&value, &word, 8);
    return value;
}

static uint32_t bounded(uint32_t count)
{
    return count < MOST ? count : MOST;
}

static void decode(uint32_t interface, uint32_t subtype, const unsigned char *at)
{
    uint32_t count;
    double six[6];
    switch (interface) {
    case 4:
        for (int i = 0; i < 6; i++)
            six[i] = f64(at + 8 * i);
        sum += six[0] + u32(at + 48);
        break;
    case 6:
        count = bounded(u32(at + 16));
        for (uint32_t i = 0; i < count; i++)
            floats[i] = f32(at + 24 + 4 * i);
        sum += f32(at + 12) + floats[0];
        break;
    case 40:
        sum += u32(at);
        count = u32(at + 24);
        memcpy(doubles, at + 32, count < sizeof doubles ? count : sizeof doubles);
        break;
    default:
        if (subtype != 1)
            break;
        count = bounded(u32(at));
        for (uint32_t i = 0; i < count; i++)
            doubles[i] = f64(at + 8 + 8 * i);
        sum += doubles[0];
    }
}

static void message(int decoding)
{
    need(HEADER);
    uint32_t size = u32(room + begin + 36);
    need(HEADER + size);
    const unsigned char *at = room + begin;
    if (decoding && u32(at + 16) == 1)
        decode(u32(at + 8), u32(at + 20), at + HEADER);
    begin += HEADER + size;
}

static void subscribe(unsigned interface, unsigned index)
{
    const uint32_t words[] = {0, 0, 1, 0, 3, 3, 0, 0, 0, 28, 0, 0, interface, index, 1, 0, 0};
    uint32_t wire[17];
    for (int i = 0; i < 17; i++)
        wire[i] = htobe32(words[i]);
    if (send(peer, wire, sizeof wire, 0) != sizeof wire)
        exit(1);
    message(0);
}

int main(int count, char **arguments)
{
    if (count < 3)
        return 1;
    struct sockaddr_in server = {.sin_family = AF_INET, .sin_port = htons((uint16_t) atoi(arguments[1])), .sin_addr = {htonl(INADDR_LOOPBACK)}};
    int decoding = !strcmp(arguments[2], "decode");
    unsigned long messages, bytes;
    peer = socket(AF_INET, SOCK_STREAM, 0);
    if (connect(peer, (struct sockaddr *) &server, sizeof server))
        return 1;
    need(BANNER);
    begin += BANNER;
    for (int i = 3; i < count; i++) {
        unsigned interface, index;
        if (sscanf(arguments[i], "%u:%u", &interface, &index) == 2)
            subscribe(interface, index);
    }
    puts("\"ready\"");
    fflush(stdout);
    while (scanf("%lu %lu", &messages, &bytes) == 2) {
        puts("\"waits\"");
        fflush(stdout);
        need(1);
        double from = now();
        if (decoding)
            for (unsigned long i = 0; i < messages; i++)
                message(1);
        else {
            bytes -= end - begin;
            begin = end = 0;
            while (bytes > 0) {
                need(1);
                bytes -= end;
                begin = end = 0;
            }
        }
        printf("{\"seconds\": %.9f, \"sum\": %.6g}\n", now() - from, sum);
        fflush(stdout);
    }
    return 0;
}
