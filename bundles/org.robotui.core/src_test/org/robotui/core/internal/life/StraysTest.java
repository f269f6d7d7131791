package org.robotui.core.internal.life;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CountDownLatch;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.robotui.core.internal.support.Await;
import org.robotui.core.internal.watch.BundleNames;

class StraysTest {
  private final CountDownLatch over = new CountDownLatch(1);
  private final List<String> asked = new ArrayList<>();
  private final BundleNames names = className -> {
    asked.add(className);
    return Optional.of(className).filter(c -> c.startsWith(StraysTest.class.getName() + "$"))
        .map(c -> "bundle." + c.substring(c.indexOf('$') + 1));
  };

  /** The code of one bundle. */
  private record One(CountDownLatch over) implements Runnable {
    @Override
    public void run() {
      await(over);
    }
  }

  /** The code of another. */
  private record Two(CountDownLatch over) implements Runnable {
    @Override
    public void run() {
      await(over);
    }
  }

  private static void await(CountDownLatch latch) {
    try {
      latch.await();
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  private static void start(String name, Runnable code) {
    awaitRunning(Thread.ofPlatform().daemon().name(name).start(code));
  }

  /** Before that it has no code that could be seen. */
  private static void awaitRunning(Thread thread) {
    Await.until(thread.getName() + " runs", () -> thread.getState() == Thread.State.WAITING);
  }

  @AfterEach
  void end() {
    over.countDown();
  }

  @Test
  void oneLookFindsWhatSeveralBundlesLeft() {
    start("second", new One(over));
    start("first", new One(over));
    start("other", new Two(over));
    assertEquals(Map.of("bundle.One", List.of("first", "second"), "bundle.Two", List.of("other")),
        Strays.of(Set.of("bundle.One", "bundle.Two", "bundle.Three"), names));
  }

  @Test
  void thoseOfOthersAreNotMeant() {
    start("other", new Two(over));
    assertEquals(Map.of(), Strays.of(Set.of("bundle.One"), names));
  }

  @Test
  void thoseThatAFactoryMadeAreKnown() {
    TrackedThreads threads = new TrackedThreads("component", (thread, error) -> {});
    Thread thread = threads.newThread(new One(over));
    thread.start();
    awaitRunning(thread);
    assertEquals(Map.of(), Strays.of(Set.of("bundle.One"), names));
  }

  @Test
  void whereNoBundleIsMeantNoThreadIsHaltedForALook() {
    start("other", new Two(over));
    assertEquals(Map.of(), Strays.of(Set.of(), names));
    assertEquals(List.of(), asked);
  }
}
