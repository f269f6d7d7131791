// Receives as it is told by lines "KIND TOPIC" on stdin, and answers each with what it saw, as a JSON object. "discover COUNT" opens a participant and
// answers how long it took until it knew so many writers.
#include <inttypes.h>
#include <pthread.h>
#include <unistd.h>

#include "bench.h"
#include "common.h"

enum { MOST = 1 << 20, AT_ONCE = 64 };

typedef struct {
  int image;
  int64_t count, first, expected, nanos, cpu;
  int64_t *latencies;
  volatile int done;
} tally_t;

static void add(tally_t *tally, const char *tag) {
  int64_t time = now(CLOCK_MONOTONIC);
  char number[17] = {0}, stamp[17] = {0};
  if (strlen(tag) < TAG) return;
  memcpy(number, tag + 1, 16);
  memcpy(stamp, tag + 17, 16);
  int64_t n = (int64_t)strtoull(number, NULL, 16);
  if (*tag == 'm') {
    if (tally->count == 0) {
      tally->first = n;
      tally->nanos = -time;
      tally->cpu = -now(CLOCK_PROCESS_CPUTIME_ID);
    }
    if (tally->count < MOST) tally->latencies[tally->count] = time - (int64_t)strtoull(stamp, NULL, 16);
    tally->count++;
  } else if (*tag == 'e') {
    tally->cpu += now(CLOCK_PROCESS_CPUTIME_ID);
    tally->nanos += time;
    tally->expected = n - tally->first;
    tally->done = 1;
  }
}

// On the receiving thread, as with the other programs that have callbacks.
static void on_data(dds_entity_t reader, void *argument) {
  tally_t *tally = argument;
  void *samples[AT_ONCE] = {NULL};
  dds_sample_info_t infos[AT_ONCE];
  int32_t taken;
  while ((taken = dds_take(reader, samples, infos, AT_ONCE, AT_ONCE)) > 0) {
    for (int32_t i = 0; i < taken; i++) {
      if (!infos[i].valid_data) continue;
      add(tally, tally->image ? ((sensor_msgs_msg_dds__Image_ *)samples[i])->header.frame_id
                              : ((std_msgs_msg_dds__String_ *)samples[i])->data);
    }
    dds_return_loan(reader, samples, taken);
  }
}

static int ascending(const void *a, const void *b) {
  int64_t x = *(const int64_t *)a, y = *(const int64_t *)b;
  return (x > y) - (x < y);
}

static void tell(const tally_t *tally) {
  int64_t known = tally->count < MOST ? tally->count : MOST;
  qsort(tally->latencies, (size_t)known, sizeof *tally->latencies, ascending);
  int64_t p50 = known ? tally->latencies[(int64_t)(0.5 * (double)(known - 1))] : 0;
  int64_t p99 = known ? tally->latencies[(int64_t)(0.99 * (double)(known - 1))] : 0;
  printf("{\"count\": %" PRId64 ", \"lost\": %" PRId64 ", \"seconds\": %.9f, \"cpu\": %.6f, \"p50\": %" PRId64 ", \"p99\": %" PRId64 "}\n",
         tally->count, tally->expected - tally->count, (double)tally->nanos / 1e9, (double)tally->cpu / 1e9, p50, p99);
}

static void measure(dds_entity_t participant, const char *kind, const char *topic_name) {
  tally_t tally = {.image = !strcmp(kind, "image"), .latencies = calloc(MOST, sizeof(int64_t))};
  dds_entity_t topic = checked(dds_create_topic(participant,
      tally.image ? &sensor_msgs_msg_dds__Image__desc : &std_msgs_msg_dds__String__desc, topic_name, NULL, NULL), "topic");
  dds_qos_t *qos = reliable();
  dds_listener_t *listener = dds_create_listener(&tally);
  dds_lset_data_available(listener, on_data);
  dds_entity_t reader = checked(dds_create_reader(participant, topic, qos, listener), "reader");
  while (!tally.done) usleep(1000);
  dds_delete(reader);
  dds_delete(topic);
  dds_delete_qos(qos);
  dds_delete_listener(listener);
  tell(&tally);
  free(tally.latencies);
}

// Of one topic each, so that counting names is counting writers.
static void discover(uint32_t domain, int wanted) {
  int64_t start = now(CLOCK_MONOTONIC);
  dds_entity_t participant = checked(dds_create_participant(domain, NULL, NULL), "participant");
  dds_entity_t reader = checked(dds_create_reader(participant, DDS_BUILTIN_TOPIC_DCPSPUBLICATION, NULL, NULL), "reader");
  for (int known = 0; known < wanted;) {
    void *samples[AT_ONCE] = {NULL};
    dds_sample_info_t infos[AT_ONCE];
    int32_t taken = dds_take(reader, samples, infos, AT_ONCE, AT_ONCE);
    for (int32_t i = 0; i < taken; i++) {
      known += infos[i].valid_data && !strncmp(((dds_builtintopic_endpoint_t *)samples[i])->topic_name, "rt/endpoint_", 12);
    }
    if (taken > 0) {
      dds_return_loan(reader, samples, taken);
    } else {
      usleep(500);
    }
  }
  printf("{\"seconds\": %.6f}\n", (double)(now(CLOCK_MONOTONIC) - start) / 1e9);
  dds_delete(participant);
}

int main(int count, char **arguments) {
  uint32_t domain = count > 1 ? (uint32_t)atoi(arguments[1]) : 0;
  dds_entity_t participant = 0;
  char kind[20], topic[100], line[200];
  int wanted;
  while (fgets(line, sizeof line, stdin)) {
    if (sscanf(line, "discover %d", &wanted) == 1) {
      if (participant > 0) dds_delete(participant);
      participant = 0;
      discover(domain, wanted);
    } else if (sscanf(line, "%19s %99s", kind, topic) == 2) {
      if (participant <= 0) participant = checked(dds_create_participant(domain, NULL, NULL), "participant");
      measure(participant, kind, topic);
    }
    fflush(stdout);
  }
  return 0;
}
