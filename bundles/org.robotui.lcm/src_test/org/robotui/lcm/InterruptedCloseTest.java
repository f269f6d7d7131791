package org.robotui.lcm;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.util.List;
import java.util.concurrent.atomic.AtomicBoolean;
import org.junit.jupiter.api.Test;

/** Who closes a connection because it was interrupted leaves no thread behind. */
class InterruptedCloseTest {

  private final TestThreads threads = new TestThreads();
  private final AtomicBoolean listening = new AtomicBoolean();
  private final AtomicBoolean closing = new AtomicBoolean();
  private final AtomicBoolean returned = new AtomicBoolean();

  @Test
  void threadsAreWaitedForAfterAnInterrupt() throws IOException {
    Thread closer = Thread.currentThread();
    Lcm lcm = Lcm.open(LcmUrl.of("memq://"), LcmOptions.standard(threads));
    lcm.subscribe("SLOW", SubscriptionOptions.queued(1), message -> {
      listening.set(true);
      Eventually.await("a close that waits",
          () -> closing.get() && closer.getState() == Thread.State.TIMED_WAITING || returned.get());
    });
    Eventually.await("the connection", () -> lcm.state() instanceof LcmState.Connected);
    lcm.publish("SLOW", Heard.text("x"));
    Eventually.await("the listener", listening::get);
    closer.interrupt();
    closing.set(true);
    lcm.close();
    List<String> left = threads.alive();
    returned.set(true);
    assertTrue(Thread.interrupted(), "the caller may want to know");
    assertEquals(List.of(), left);
  }
}
