package org.robotui.player;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.concurrent.atomic.AtomicBoolean;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.robotui.player.client.ClientOptions;
import org.robotui.player.client.LinkState;
import org.robotui.player.client.PlayerClient;

/** Who closes a client because it was interrupted leaves no thread behind. */
class InterruptedCloseTest {

  private final World world = new World();
  private final TestThreads threads = new TestThreads();
  private final AtomicBoolean closing = new AtomicBoolean();
  private final AtomicBoolean returned = new AtomicBoolean();

  @AfterEach
  void close() throws Exception {
    world.close();
  }

  @Test
  void threadsAreWaitedForAfterAnInterrupt() throws Exception {
    Thread closer = Thread.currentThread();
    PlayerClient client =
        world.client(world.server(0).port(), none -> ClientOptions.standard(threads).withLinks(state -> {
          if (state instanceof LinkState.Closed) {
            Eventually.await("a close that waits",
                () -> closing.get() && closer.getState() == Thread.State.TIMED_WAITING || returned.get());
          }
        }));
    World.awaitLink(client);
    closer.interrupt();
    closing.set(true);
    client.close();
    List<String> left = threads.alive();
    returned.set(true);
    assertTrue(Thread.interrupted(), "the caller may want to know");
    assertEquals(List.of(), left);
  }
}
