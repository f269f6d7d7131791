package org.robotui.core.internal.port;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.IntFunction;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.robotui.api.port.Envelope;
import org.robotui.api.port.SourceId;
import org.robotui.core.internal.support.Samples;
import org.robotui.data.Conflation;
import org.robotui.data.Data;
import org.robotui.data.DataType;
import org.robotui.data.Delivery;
import org.robotui.data.Keyed;
import org.robotui.data.Late;
import org.robotui.data.joint.JointState;
import org.robotui.data.joint.JointState.Joint;
import org.robotui.data.sensor.LaserScan;
import org.robotui.data.status.LogEntry;

class FanTest {
  private static final SourceId ID = new SourceId("base", "port");

  /** An event whose last value late consumers get. */
  @Delivery(conflation = Conflation.EVENT, late = Late.LAST)
  private record Notice(int number) implements Data {}

  /** A keyed value that counts how often it was merged. */
  @Delivery(conflation = Conflation.KEYED)
  private record Tagged(AtomicInteger merges, Set<String> tags) implements Keyed<Tagged> {
    @Override
    public Tagged over(Tagged older) {
      merges.incrementAndGet();
      Set<String> all = new TreeSet<>(older.tags);
      all.addAll(tags);
      return new Tagged(merges, all);
    }

    @Override
    public int keys() {
      return tags.size();
    }

    @Override
    public Tagged last(int most) {
      return this;
    }
  }

  private static <T extends Data> Fan<T> fan(Class<T> type) {
    return new Fan<>(ID, DataType.of(type), 0);
  }

  private static <T extends Data> void publish(Fan<T> fan, T value) {
    fan.publish(value, Optional.empty(), System.nanoTime(), Optional.empty());
  }

  private static <T extends Data> List<T> drain(Tap<T> tap) {
    List<T> taken = new ArrayList<>();
    tap.drain(e -> taken.add(e.value()));
    return taken;
  }

  private static Joint joint(String name, double position) {
    return new Joint(name, position, 0, 0);
  }

  @Test
  void samplesAreReplacedByNewerOnes() {
    Fan<LaserScan> fan = fan(LaserScan.class);
    Tap<LaserScan> tap = fan.join();
    publish(fan, Samples.scan(1));
    publish(fan, Samples.scan(2));
    assertEquals(List.of(Samples.scan(2)), drain(tap));
    assertEquals(List.of(), drain(tap));
    assertEquals(Samples.scan(2), tap.latest().orElseThrow().value());
    assertEquals(0, tap.dropped());
  }

  @Test
  void keyedValuesAreMergedUntilTheyAreTaken() {
    Fan<JointState> fan = fan(JointState.class);
    Tap<JointState> tap = fan.join();
    publish(fan, new JointState(List.of(joint("a", 1), joint("b", 1))));
    publish(fan, new JointState(List.of(joint("b", 2))));
    assertEquals(List.of(new JointState(List.of(joint("a", 1), joint("b", 2)))), drain(tap));
    publish(fan, new JointState(List.of(joint("c", 3))));
    assertEquals(List.of(new JointState(List.of(joint("c", 3)))), drain(tap), "only what changed");
    assertEquals(3, tap.latest().orElseThrow().value().joints().size());
  }

  @Test
  void lateConsumersOfKeyedValuesGetAllKeys() {
    Fan<JointState> fan = fan(JointState.class);
    publish(fan, new JointState(List.of(joint("a", 1))));
    publish(fan, new JointState(List.of(joint("b", 2))));
    assertEquals(List.of(new JointState(List.of(joint("a", 1), joint("b", 2)))), drain(fan.join()));
  }

  @Test
  void keysWithoutEndAreBoundedAndWhatIsGivenUpIsCounted() {
    Fan<JointState> fan = fan(JointState.class);
    Tap<JointState> tap = fan.join();
    drain(tap);
    int many = 3 * Keyed.MOST_KEYS;
    for (int i = 0; i < many; i++) {
      publish(fan, new JointState(List.of(joint("steady", i), joint("joint " + i, i))));
    }
    JointState last = fan.last().orElseThrow().value();
    List<Joint> taken = drain(tap).getFirst().joints();
    assertTrue(taken.size() <= Keyed.MOST_KEYS, "keys: " + taken.size());
    assertTrue(taken.contains(joint("steady", many - 1)) && taken.contains(joint("joint " + (many - 1), many - 1)));
    assertEquals(many + 1, taken.size() + tap.dropped());
    assertEquals(taken, last.joints());
    assertEquals(2 * tap.dropped(), fan.dropped(), "of this consumer, and of what late ones get");
    publish(fan, new JointState(List.of(joint("joint 0", 7))));
    assertEquals(List.of(joint("joint 0", 7)), drain(tap).getFirst().joints(), "back with its next value");
  }

  @Test
  void aSingleValueKeepsAllItsKeys() {
    Fan<JointState> fan = fan(JointState.class);
    Tap<JointState> tap = fan.join();
    drain(tap);
    publish(fan, new JointState(List.of(joint("old", 1))));
    publish(fan,
        new JointState(IntStream.range(0, Keyed.MOST_KEYS + 5).mapToObj(i -> joint("joint " + i, i)).toList()));
    assertEquals(Keyed.MOST_KEYS + 5, drain(tap).getFirst().joints().size());
    assertEquals(1, tap.dropped());
  }

  /** A view that only looks costs a publication nothing: what it merges for late consumers it merges once, for all. */
  @Test
  void keyedValuesAreMergedForAConsumerFromItsFirstDrainingOn() {
    AtomicInteger merges = new AtomicInteger();
    Fan<Tagged> fan = fan(Tagged.class);
    Tap<Tagged> looks = fan.join();
    publish(fan, new Tagged(merges, Set.of("a")));
    publish(fan, new Tagged(merges, Set.of("b")));
    assertEquals(1, merges.get(), "for late consumers");
    assertEquals(Set.of("a", "b"), looks.latest().orElseThrow().value().tags());

    assertEquals(Set.of("a", "b"), drain(looks).getFirst().tags(), "the first draining gives what holds");
    merges.set(0);
    publish(fan, new Tagged(merges, Set.of("c")));
    publish(fan, new Tagged(merges, Set.of("d")));
    assertEquals(3, merges.get(), "for late consumers, and for this one");
    assertEquals(Set.of("c", "d"), drain(looks).getFirst().tags());
  }

  @Test
  void aConsumerThatLeftBeforeItDrainedIsMergedNothing() {
    AtomicInteger merges = new AtomicInteger();
    Fan<Tagged> fan = fan(Tagged.class);
    Tap<Tagged> left = fan.join();
    left.close();
    drain(left);
    publish(fan, new Tagged(merges, Set.of("a")));
    publish(fan, new Tagged(merges, Set.of("b")));
    assertEquals(1, merges.get(), "for late consumers");
    assertEquals(List.of(), drain(left));
  }

  @Test
  void eventsAreAllDeliveredInOrder() {
    Fan<LogEntry> fan = fan(LogEntry.class);
    publish(fan, Samples.log("before"));
    Tap<LogEntry> tap = fan.join();
    assertTrue(tap.latest().isEmpty(), "late consumers of a log get nothing");
    publish(fan, Samples.log("one"));
    publish(fan, Samples.log("two"));
    assertEquals(List.of(Samples.log("one"), Samples.log("two")), drain(tap));
  }

  @Test
  void eventsBeyondTheQueueAreDroppedOldestFirstAndCounted() {
    Fan<LogEntry> fan = fan(LogEntry.class);
    Tap<LogEntry> tap = fan.join();
    for (int i = 0; i < EventMailbox.CAPACITY + 10; i++) {
      publish(fan, Samples.log("entry " + i));
    }
    List<LogEntry> taken = drain(tap);
    assertEquals(EventMailbox.CAPACITY, taken.size());
    assertEquals(Samples.log("entry 10"), taken.getFirst());
    assertEquals(10, tap.dropped());
    assertEquals(10, fan.dropped());
  }

  @Test
  void lateConsumersOfAnEventGetTheLastOnce() {
    Fan<Notice> fan = fan(Notice.class);
    publish(fan, new Notice(1));
    publish(fan, new Notice(2));
    Tap<Notice> tap = fan.join();
    publish(fan, new Notice(3));
    assertEquals(List.of(new Notice(2), new Notice(3)), drain(tap));
  }

  @Test
  void sequenceCountsAllValuesOfTheSource() {
    Fan<LaserScan> fan = fan(LaserScan.class);
    Tap<LaserScan> tap = fan.join();
    AtomicReference<Envelope<LaserScan>> seen = new AtomicReference<>();
    for (int i = 0; i < 5; i++) {
      publish(fan, Samples.scan(i));
    }
    tap.drain(seen::set);
    assertEquals(4, seen.get().sequence());
    assertEquals(ID, seen.get().source());
  }

  @Test
  void consumerThatLeftGetsNothing() {
    Fan<LaserScan> fan = fan(LaserScan.class);
    Tap<LaserScan> tap = fan.join();
    tap.close();
    publish(fan, Samples.scan(1));
    assertEquals(List.of(), drain(tap));
  }

  @Test
  void samplesNeverGoBackWhileFourThreadsPublishAndConsumersComeAndGo() throws InterruptedException {
    Fan<LaserScan> fan = fan(LaserScan.class);
    AtomicBoolean wentBack = new AtomicBoolean();
    AtomicBoolean over = new AtomicBoolean();
    Thread consumer = Thread.ofPlatform().start(() -> {
      while (!over.get()) {
        Tap<LaserScan> tap = fan.join();
        long[] last = {-1};
        for (int i = 0; i < 100; i++) {
          tap.drain(e -> {
            wentBack.compareAndSet(false, e.sequence() <= last[0]);
            last[0] = e.sequence();
          });
        }
        tap.close();
      }
    });
    publishFromFourThreads(fan, 20_000, i -> Samples.scan(i));
    over.set(true);
    consumer.join();
    assertFalse(wentBack.get());
    assertEquals(80_000, fan.rate().count());
  }

  @Test
  void noEventIsLostOrDoubledWhileFourThreadsPublish() throws InterruptedException {
    Fan<LogEntry> fan = fan(LogEntry.class);
    Tap<LogEntry> tap = fan.join();
    AtomicBoolean over = new AtomicBoolean();
    List<Long> taken = new ArrayList<>();
    Thread consumer = Thread.ofPlatform().start(() -> {
      while (!over.get()) {
        tap.drain(e -> taken.add(e.sequence()));
      }
    });
    publishFromFourThreads(fan, 5_000, i -> Samples.log("x"));
    over.set(true);
    consumer.join();
    tap.drain(e -> taken.add(e.sequence()));
    assertEquals(20_000, taken.size() + tap.dropped());
    assertEquals(taken.size(), taken.stream().distinct().count());
  }

  @Test
  void noKeyIsLostWhileFourThreadsPublish() throws InterruptedException {
    Fan<JointState> fan = fan(JointState.class);
    Tap<JointState> tap = fan.join();
    publishFromFourThreads(fan, 200, i -> new JointState(List.of(joint("joint " + i, i))));
    assertEquals(200, tap.latest().orElseThrow().value().joints().size());
    assertEquals(200, drain(tap).getFirst().joints().size());
  }

  private static <T extends Data> void publishFromFourThreads(
      Fan<T> fan, int each, IntFunction<T> value) throws InterruptedException {
    CountDownLatch go = new CountDownLatch(1);
    List<Thread> threads = new ArrayList<>();
    for (int t = 0; t < 4; t++) {
      threads.add(Thread.ofPlatform().start(() -> {
        try {
          go.await();
        } catch (InterruptedException e) {
          return;
        }
        for (int i = 0; i < each; i++) {
          publish(fan, value.apply(i));
        }
      }));
    }
    go.countDown();
    for (Thread thread : threads) {
      thread.join();
    }
  }
}
