package org.robotui.core.internal.host;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.CountDownLatch;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.robotui.api.host.Host.Subscription;
import org.robotui.api.host.HostListener;
import org.robotui.core.internal.support.Await;

class NotifierTest {
  private final Notifier notifier = new Notifier();
  private final HostEvents events = new HostEvents(notifier, r -> {});
  private final List<String> told = new CopyOnWriteArrayList<>();
  private final CountDownLatch entered = new CountDownLatch(1);
  private final CountDownLatch gate = new CountDownLatch(1);

  private final HostListener slow = new HostListener() {
    @Override
    public void ruicsChanged() {
      entered.countDown();
      try {
        gate.await();
      } catch (InterruptedException e) {
        Thread.currentThread().interrupt();
      }
    }

    @Override
    public void frameReady(String ruic, String uic) {
      told.add(uic);
    }

    @Override
    public void alert(String ruic, String message) {
      told.add(message);
    }
  };

  @AfterEach
  void end() {
    notifier.close();
  }

  @Test
  void slowListenerIsToldOnceOfWhatHappenedOften() {
    notifier.listen(slow);
    events.ruicsChanged();
    Await.until("it is taken", () -> entered.getCount() == 0);
    for (int i = 0; i < 100; i++) {
      events.frameReady("r", "map");
      events.frameReady("r", "camera");
    }
    events.alert("r", "one");
    events.alert("r", "two");
    gate.countDown();
    Await.until("all is told", () -> told.contains("two"));
    assertEquals(List.of("map", "camera", "one", "two"), told);
  }

  @Test
  void listenerThatThrowsDoesNotKeepOthersFromHearing() {
    notifier.listen(new HostListener() {
      @Override
      public void alert(String ruic, String message) {
        throw new IllegalStateException("broken listener");
      }
    });
    notifier.listen(slow);
    events.alert("", "message");
    Await.until("the other is told", () -> told.contains("message"));
  }

  /** Formerly two more places made one of many on the way to the display, each with a queue of its own. */
  @Test
  void atMostOneTaskOfAListenerWaitsWhereItWantsToBeTold() {
    Deque<Runnable> display = new ArrayDeque<>();
    notifier.listen(slow, display::add);
    for (int i = 0; i < 100; i++) {
      events.frameReady("r", "map");
    }
    events.frameReady("r", "camera");
    assertEquals(1, display.size());
    display.poll().run();
    assertEquals(List.of("map", "camera"), told);

    events.frameReady("r", "map");
    display.poll().run();
    assertEquals(List.of("map", "camera", "map"), told, "what comes after a task is told by the next");
  }

  @Test
  void whatFailsInAListenerKeepsNeitherOthersNorItselfFromBeingTold() {
    Deque<Runnable> display = new ArrayDeque<>();
    notifier.listen(new HostListener() {
      @Override
      public void ruicChanged(String ruic) {
        told.add(ruic);
        throw new NoClassDefFoundError("a view whose bundle is incomplete");
      }
    }, display::add);
    notifier.listen(slow, display::add);
    events.changed("a");
    events.changed("b");
    events.alert("", "message");
    display.forEach(Runnable::run);
    assertEquals(List.of("a", "b", "message"), told);
  }

  @Test
  void aListenerWhoseThreadHangsIsToldABoundedNumberOfThings() {
    Deque<Runnable> display = new ArrayDeque<>();
    notifier.listen(slow, display::add);
    for (int i = 0; i < 20_000; i++) {
      events.frameReady("r", "view " + i);
    }
    display.poll().run();
    assertEquals(10_000, told.size());
  }

  @Test
  void whoCannotBeReachedAnyMoreKeepsNobodyFromBeingTold() {
    notifier.listen(slow, task -> {
      throw new IllegalStateException("Device is disposed");
    });
    notifier.listen(slow, Runnable::run);
    events.alert("", "message");
    assertEquals(List.of("message"), told);
  }

  @Test
  void whoStopsListeningIsNotToldWhatWaited() {
    Deque<Runnable> display = new ArrayDeque<>();
    Subscription subscription = notifier.listen(slow, display::add);
    events.alert("", "message");
    subscription.close();
    display.poll().run();
    assertEquals(List.of(), told);
  }

  @Test
  void closedSubscriptionHearsNothing() {
    Subscription subscription = notifier.listen(slow);
    notifier.listen(slow);
    subscription.close();
    events.alert("", "message");
    Await.until("it is told", () -> !told.isEmpty());
    events.alert("", "second");
    Await.until("it is told", () -> told.contains("second"));
    assertEquals(List.of("message", "second"), told);
  }

  @Test
  void theThreadOfTheListenersDoesNotBelongToWhoeverTellsThemFirst() throws InterruptedException {
    List<ThreadGroup> groups = new CopyOnWriteArrayList<>();
    notifier.listen(new HostListener() {
      @Override
      public void ruicsChanged() {
        groups.add(Thread.currentThread().getThreadGroup());
      }
    });
    Thread component = new Thread(new ThreadGroup("component"), events::ruicsChanged);
    component.start();
    component.join();
    Await.until("it is told", () -> !groups.isEmpty());
    assertEquals(List.of(Thread.currentThread().getThreadGroup()), groups);
  }
}
