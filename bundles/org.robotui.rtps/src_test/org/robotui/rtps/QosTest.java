package org.robotui.rtps;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.time.Duration;
import java.util.List;
import org.junit.jupiter.api.Test;

class QosTest {

  private static final Qos RELIABLE = Qos.reliable(10);

  private static final Qos BEST_EFFORT = Qos.bestEffort(5);

  @Test
  void more_is_offered_than_is_asked_for() {
    assertEquals(List.of(), Qos.mismatch(RELIABLE.with(Durability.TRANSIENT_LOCAL), BEST_EFFORT));
    assertEquals(List.of(), Qos.mismatch(RELIABLE, RELIABLE));
  }

  @Test
  void each_thing_that_is_missing_is_a_sentence() {
    assertEquals(List.of("the writer offers best effort, the reader asks for reliable",
        "the writer offers volatile, the reader asks for transient local"),
        Qos.mismatch(BEST_EFFORT, RELIABLE.with(Durability.TRANSIENT_LOCAL)));
  }

  @Test
  void a_deadline_must_be_as_short_as_is_asked_for() {
    Qos slow = RELIABLE.withTimes(Duration.ofSeconds(2), Qos.INFINITE);
    Qos fast = RELIABLE.withTimes(Duration.ofMillis(100), Qos.INFINITE);

    assertEquals(List.of(), Qos.mismatch(fast, slow));
    assertEquals(List.of("the writer offers a deadline of 2000 ms, the reader asks for a deadline of 100 ms"),
        Qos.mismatch(slow, fast));
    assertEquals(List.of("the writer offers a deadline of any time, the reader asks for a deadline of 100 ms"),
        Qos.mismatch(RELIABLE, fast));
  }

  @Test
  void liveliness_is_compared_by_kind_and_by_lease() {
    Qos manual = RELIABLE.with(Liveliness.MANUAL_BY_TOPIC, Duration.ofSeconds(1));

    assertEquals(List.of(), Qos.mismatch(manual, RELIABLE));
    assertEquals(List.of("the writer offers liveliness automatic, the reader asks for liveliness manual by topic",
        "the writer offers a liveliness lease of any time, the reader asks for a liveliness lease of 1000 ms"),
        Qos.mismatch(RELIABLE, manual));
  }

  @Test
  void partitions_meet_by_name_or_by_pattern() {
    assertEquals(List.of(), Qos.mismatch(RELIABLE.withPartitions(List.of("left", "right")),
        RELIABLE.withPartitions(List.of("r?g*"))));
    assertEquals(List.of(), Qos.mismatch(RELIABLE.withPartitions(List.of("")), RELIABLE));
    assertEquals(List.of("the writer offers the partitions [left], the reader asks for the partitions []"),
        Qos.mismatch(RELIABLE.withPartitions(List.of("left")), RELIABLE));
    assertEquals(1,
        Qos.mismatch(RELIABLE.withPartitions(List.of("l*")), RELIABLE.withPartitions(List.of("l*"))).size());
  }

  @Test
  void a_hostile_pattern_ends_soon() {
    Qos stars = RELIABLE.withPartitions(List.of("*a".repeat(500) + "b"));

    assertEquals(1, Qos.mismatch(stars, RELIABLE.withPartitions(List.of("a".repeat(1000)))).size());
  }

  @Test
  void the_encoding_must_be_one_that_the_reader_accepts() {
    Qos second = RELIABLE.withRepresentations(List.of(DataRepresentation.XCDR2));

    assertEquals(List.of("the writer offers the encoding XCDR2, the reader asks for one of the encodings [XCDR1]"),
        Qos.mismatch(second, RELIABLE));
    assertEquals(List.of(), Qos.mismatch(second,
        RELIABLE.withRepresentations(List.of(DataRepresentation.XCDR1, DataRepresentation.XCDR2))));
  }

  @Test
  void what_makes_no_sense_is_refused() {
    assertThrows(IllegalArgumentException.class, () -> RELIABLE.withDepth(0));
    assertThrows(IllegalArgumentException.class, () -> RELIABLE.withTimes(Duration.ofSeconds(-1), Qos.INFINITE));
    assertEquals(Qos.INFINITE, RELIABLE.withTimes(Duration.ofDays(1_000_000), Qos.INFINITE).deadline());
  }
}
