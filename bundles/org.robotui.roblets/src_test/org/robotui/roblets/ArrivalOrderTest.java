package org.robotui.roblets;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.robotui.roblets.tree.BodyElement;
import org.robotui.roblets.wire.ArrivalOrder;
import org.robotui.roblets.wire.ArrivalOrder.Arrival;
import org.robotui.roblets.wire.ArrivalOrder.Tally;
import org.robotui.roblets.wire.BodyDatagram;
import org.robotui.roblets.wire.DatagramKind;

/** What is lost, doubled, late, or of an earlier run. */
class ArrivalOrderTest {
  private final ArrivalOrder order = new ArrivalOrder();
  private long now = 1_000_000_000L;

  private Arrival judge(long run, long sequence, String name) {
    now += 1_000_000;
    return order.judge(new BodyDatagram(DatagramKind.MESSAGE, "gps", run, sequence, 0, "brain",
        Optional.of(BodyElement.of(name))), now);
  }

  @Test
  void newer_is_taken_and_older_left() {
    assertEquals(Arrival.STARTED, judge(5, 1, "a"));
    assertEquals(Arrival.TAKEN, judge(5, 4, "a"));
    assertEquals(Arrival.DOUBLED, judge(5, 4, "a"));
    assertEquals(Arrival.LATE, judge(5, 2, "a"));
    assertEquals(Arrival.TAKEN, judge(5, 3, "b"), "names have an order of their own");
    assertEquals(Optional.of(new Tally(4, 0, 1, 1, 1)), order.tally("gps"));
    judge(5, 10, "a");
    assertEquals(5, order.tally("gps").orElseThrow().lost());
  }

  @Test
  void a_run_that_begins_is_taken_and_an_old_one_is_not() {
    judge(5, 100, "a");
    assertEquals(Arrival.STARTED, judge(6, 1, "a"));
    assertEquals(Arrival.OLD_RUN, judge(5, 101, "a"));
    assertEquals(Arrival.TAKEN, judge(6, 2, "a"));
    assertEquals(2, order.tally("gps").orElseThrow().runs());
    now += 10_000_000_000L;
    assertEquals(Arrival.STARTED, judge(4, 1, "a"), "its clock was set back");
  }
}
