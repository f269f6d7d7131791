// Publishes as it is told by lines "KIND TOPIC WARM MEASURED" on stdin: for so many seconds what does not count, and what counts, then an end. Answers each
// with "done". "endpoints COUNT" makes so many writers, and takes back those that there were.
#include <inttypes.h>
#include <unistd.h>

#include "bench.h"
#include "common.h"

enum { SMALL = 100, PACE_NS = 1000000, MOST = 1000 };

typedef struct {
  int image;
  std_msgs_msg_dds__String_ small;
  sensor_msgs_msg_dds__Image_ picture;
  char text[SMALL + 1];
  int64_t number;
} message_t;

static void write_one(dds_entity_t writer, message_t *message, char phase) {
  snprintf(message->text, TAG + 1, "%c%016" PRIx64 "%016" PRIx64, phase, message->number++, now(CLOCK_MONOTONIC));
  if (!message->image) message->text[TAG] = '.';
  checked(dds_write(writer, message->image ? (void *)&message->picture : (void *)&message->small), "write");
}

static void phase(dds_entity_t writer, message_t *message, char name, double seconds, int paced) {
  int64_t next = now(CLOCK_MONOTONIC), end = next + (int64_t)(seconds * 1e9);
  while (now(CLOCK_MONOTONIC) < end) {
    write_one(writer, message, name);
    if (paced) {
      next += PACE_NS;
      struct timespec until = {next / 1000000000, next % 1000000000};
      clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &until, NULL);
    }
  }
}

static message_t *message_of(int image) {
  message_t *message = calloc(1, sizeof *message);
  message->image = image;
  memset(message->text, '.', SMALL);
  message->small.data = message->text;
  sensor_msgs_msg_dds__Image_ *picture = &message->picture;
  picture->header.frame_id = message->text;
  picture->encoding = "mono8";
  picture->height = picture->width = picture->step = 1024;
  picture->data._buffer = calloc(1, IMAGE);
  picture->data._length = picture->data._maximum = IMAGE;
  return message;
}

static void measure(dds_entity_t participant, const char *kind, const char *topic_name, double warm, double measured) {
  int image = !strcmp(kind, "image"), paced = !strcmp(kind, "latency");
  dds_qos_t *qos = reliable();
  dds_entity_t topic = checked(dds_create_topic(participant,
      image ? &sensor_msgs_msg_dds__Image__desc : &std_msgs_msg_dds__String__desc, topic_name, NULL, NULL), "topic");
  dds_entity_t writer = checked(dds_create_writer(participant, topic, qos, NULL), "writer");
  dds_publication_matched_status_t status = {0};
  while (status.current_count < 1) {
    dds_get_publication_matched_status(writer, &status);
    usleep(10000);
  }
  usleep(300000); // until the reader knows the writer, too
  message_t *message = message_of(image);
  phase(writer, message, 'w', warm, paced);
  phase(writer, message, 'm', measured, paced);
  write_one(writer, message, 'e');
  dds_wait_for_acks(writer, DDS_SECS(20));
  usleep(200000);
  dds_delete(writer);
  dds_delete(topic);
  dds_delete_qos(qos);
  free(message->picture.data._buffer);
  free(message);
}

static void endpoints(dds_entity_t participant, int count) {
  static dds_entity_t made[2 * MOST];
  static int there;
  while (there > 0) dds_delete(made[--there]);
  for (int i = 0; i < count && i < MOST; i++) {
    char name[40];
    snprintf(name, sizeof name, "rt/endpoint_%d", i);
    dds_entity_t topic = checked(dds_create_topic(participant, &std_msgs_msg_dds__String__desc, name, NULL, NULL), "topic");
    made[there++] = topic;
    made[there++] = checked(dds_create_writer(participant, topic, NULL, NULL), "writer");
  }
}

int main(int count, char **arguments) {
  dds_entity_t participant = checked(dds_create_participant(count > 1 ? (uint32_t)atoi(arguments[1]) : 0, NULL, NULL), "participant");
  char kind[20], topic[100], line[200];
  double warm, measured;
  int wanted;
  while (fgets(line, sizeof line, stdin)) {
    if (sscanf(line, "endpoints %d", &wanted) == 1) {
      endpoints(participant, wanted);
    } else if (sscanf(line, "%19s %99s %lf %lf", kind, topic, &warm, &measured) == 4) {
      measure(participant, kind, topic, warm, measured);
    }
    puts("done");
    fflush(stdout);
  }
  return 0;
}
