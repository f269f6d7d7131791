package org.robotui.ros2;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertNotSame;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.time.Duration;
import java.util.List;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ThreadFactory;
import org.junit.jupiter.api.Test;
import org.robotui.message.ros.std_msgs.StdString;
import org.robotui.ros2.Ros2Environment.Range;
import org.robotui.rtps.GuidPrefix;

/** Contexts that share participants. */
class Ros2ParticipantsTest {
  /** Nobody is looked for: what is shared is seen without a network. */
  private static final Ros2Environment ALONE = Ros2Environment.local(7).within(Range.OFF, List.of(), List.of());

  private final Set<Thread> threads = ConcurrentHashMap.newKeySet();
  private final ThreadFactory counting = work -> {
    Thread thread = Thread.ofPlatform().daemon().unstarted(work);
    threads.add(thread);
    return thread;
  };
  private final Ros2Participants participants = new Ros2Participants(counting);

  private Ros2Context open(Ros2Environment environment) throws IOException {
    return participants.open(environment, Ros2Options.standard(Thread::new));
  }

  private static GuidPrefix prefix(Ros2Context context) {
    return context.participant().info().guid().prefix();
  }

  private long alive() {
    return threads.stream().filter(Thread::isAlive).count();
  }

  @Test
  void theParticipantEndsWithItsLastContext() throws Exception {
    Ros2Context first = open(ALONE);
    Ros2Context second = open(ALONE);
    assertSame(first.participant(), second.participant());
    assertNotSame(first.types(), second.types(), "each has definitions of its own");
    GuidPrefix shared = prefix(first);
    Ros2Node staying = second.node("staying");
    first.node("leaving").publisher("chatter", Ros2Codec.of(StdString.class), QosProfiles.DEFAULT);
    assertEquals(2, second.graph().state().nodes().size());
    first.close();
    first.close();
    assertEquals(List.of(staying.name()), second.graph().state().nodes().stream().map(node -> node.name()).toList());
    assertTrue(second.graph().state().topics().stream().allMatch(topic -> topic.publishers().isEmpty()));
    assertTrue(participants.include(shared) && alive() > 0);
    second.close();
    assertFalse(participants.include(shared));
    assertEquals(0, alive());
    try (Ros2Context third = open(ALONE)) {
      assertNotEquals(shared, prefix(third));
      third.node("staying");
    }
  }

  @Test
  void whoLooksForOthersInAnotherWayIsAnotherParticipant() throws Exception {
    try (Ros2Context one = open(ALONE);
        Ros2Context other = open(Ros2Environment.local(7));
        Ros2Context slow = participants.open(ALONE,
            Ros2Options.standard(Thread::new).withLease(Duration.ofSeconds(9)))) {
      Set<GuidPrefix> all = Set.of(prefix(one), prefix(other), prefix(slow));
      assertEquals(3, all.size());
      assertTrue(all.stream().allMatch(participants::include));
    }
    assertEquals(0, alive());
  }

  @Test
  void namesOfNodesAreThoseOfOneParticipant() throws Exception {
    try (Ros2Context one = open(ALONE); Ros2Context other = open(ALONE)) {
      one.node("same");
      assertThrows(IllegalStateException.class, () -> other.node("same"));
      one.close();
      other.node("same");
      assertThrows(IllegalStateException.class, () -> one.node("late"));
    }
  }
}
