package org.robotui.api.session;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.BooleanSupplier;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.robotui.api.link.LinkState;

@Timeout(60)
class SessionRficTest {
  private static final Duration SOON = Duration.ofMillis(10);

  private final RecordedLink context = new RecordedLink();
  private final List<String> events = new CopyOnWriteArrayList<>();
  private final AtomicInteger opened = new AtomicInteger();
  private final CountDownLatch reached = new CountDownLatch(1);
  private final CountDownLatch never = new CountDownLatch(1);
  private Optional<SessionRfic> rfic = Optional.empty();

  @AfterEach
  void close() {
    never.countDown();
    rfic.ifPresent(SessionRfic::close);
  }

  private SessionRfic started(SessionFactory sessions) {
    SessionRfic made = new SessionRfic(context, "the robot", SOON, sessions);
    rfic = Optional.of(made);
    made.start();
    return made;
  }

  /** A session whose end is noted. */
  private RobotSession session(Following following) {
    return new RobotSession() {
      @Override
      public Optional<String> follow(BooleanSupplier over) throws IOException, InterruptedException {
        return following.follow(over);
      }

      @Override
      public void close() {
        events.add("session closed");
      }
    };
  }

  @FunctionalInterface
  private interface Following {
    Optional<String> follow(BooleanSupplier over) throws IOException, InterruptedException;
  }

  private Optional<String> hang(BooleanSupplier over) throws InterruptedException {
    reached.countDown();
    never.await();
    return Optional.empty();
  }

  @Test
  void whatCannotBeOpenedIsTriedAgainAndTheLinkToldWhy() throws Exception {
    SessionRfic made = started(scope -> {
      if (opened.incrementAndGet() < 3) {
        throw new IOException("no answer " + opened.get());
      }
      return session(this::hang);
    });
    reached.await();
    made.close();
    assertEquals(List.of(new LinkState.Connecting("the robot"), new LinkState.Failed("no answer 1", SOON),
        new LinkState.Failed("no answer 2", SOON), new LinkState.Disconnected()), context.states);
    assertEquals(List.of("session closed"), events);
    assertEquals(List.of(), context.alive());
  }

  @Test
  void aSessionEndsWithItsReasonOrIsOpenedAgainAtOnce() throws Exception {
    SessionRfic made = started(scope -> switch (opened.incrementAndGet()) {
      case 1 -> session(over -> Optional.empty());
      case 2 -> session(over -> Optional.of("it was ended"));
      default -> session(this::hang);
    });
    reached.await();
    made.close();
    assertEquals(
        List.of(new LinkState.Connecting("the robot"), new LinkState.Failed("it was ended", SOON),
            new LinkState.Disconnected()),
        context.states);
    assertEquals(3, events.size(), "each is closed once");
  }

  @Test
  void whatASessionNeedsIsClosedAfterItAndWhereItCannotBeOpened() throws Exception {
    SessionRfic made = started(scope -> {
      scope.closing("guard", name -> events.add(name + " closed"));
      if (opened.incrementAndGet() == 1) {
        throw new IOException("no answer");
      }
      return session(this::hang);
    });
    reached.await();
    made.close();
    assertEquals(List.of("guard closed", "session closed", "guard closed"), events);
  }

  @Test
  void anEndWhileItConnectsInterruptsIt() throws Exception {
    SessionRfic made = started(scope -> {
      hang(() -> false);
      return session(this::hang);
    });
    reached.await();
    made.close();
    assertEquals(List.of(), context.alive());
    assertEquals(List.of(new LinkState.Connecting("the robot"), new LinkState.Disconnected()), context.states);
  }

  @Test
  void anInterruptDoesNotKeepTheEndFromWaitingForItsThreads() throws Exception {
    Thread closer = Thread.currentThread();
    SessionRfic made = started(scope -> session(over -> {
      reached.countDown();
      while (closer.getState() != Thread.State.TIMED_WAITING) {
        Thread.onSpinWait();
      }
      return Optional.empty();
    }));
    reached.await();
    closer.interrupt();
    made.close();
    assertTrue(Thread.interrupted(), "the caller may want to know");
    assertEquals(List.of(), context.alive());
  }

  @Test
  void aSessionThatHangsInItsCloseHoldsUpTheEndForABoundedTime() throws Exception {
    CountDownLatch closing = new CountDownLatch(1);
    SessionRfic made = started(scope -> new RobotSession() {
      @Override
      public Optional<String> follow(BooleanSupplier over) throws InterruptedException {
        return hang(over);
      }

      @Override
      public void close() {
        closing.countDown();
        boolean over = false;
        while (!over) {
          try {
            never.await();
            over = true;
          } catch (InterruptedException e) {
            events.add("interrupted");
          }
        }
      }
    });
    reached.await();
    made.close();
    assertEquals(new LinkState.Disconnected(), context.states.getLast());
    closing.await();
    assertFalse(context.alive().isEmpty(), "what hangs is seen by the owner of the threads");
  }

  @Test
  void whatWasNeverStartedEnds() {
    new SessionRfic(context, "the robot", SOON, scope -> session(this::hang)).close();
    assertEquals(List.of(new LinkState.Disconnected()), context.states);
  }

  @Test
  void onlyChangesOfALinkAreTold() {
    LinkChanges link = new LinkChanges(context.link());
    link.report(new LinkState.Connected("a"));
    link.report(new LinkState.Connected("a"));
    link.report(new LinkState.Degraded("a", "slow"));
    assertEquals(List.of(new LinkState.Connected("a"), new LinkState.Degraded("a", "slow")), context.states);
  }
}
