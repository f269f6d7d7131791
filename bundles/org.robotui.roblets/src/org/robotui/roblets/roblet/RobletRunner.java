package org.robotui.roblets.roblet;

import java.io.IOException;
import java.time.Duration;
import java.util.Optional;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.function.Supplier;
import org.robotui.net.call.Backoff;
import org.robotui.net.log.PeerText;
import org.robotui.net.thread.Uninterruptibles;
import org.robotui.net.thread.Workers;
import org.robotui.roblets.internal.RobletLink;
import org.robotui.roblets.internal.RobletInbox;
import org.robotui.roblets.tree.BodyElement;
import org.robotui.roblets.wire.RobletForm;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Lets one roblet live: starts it, lets it run with its frequency, gives it its messages, and starts another instance
 * of it where it fails. Its beacons go on all the while, so that the brain is told. Safe for all threads.
 */
public final class RobletRunner implements AutoCloseable {
  private static final Logger LOG = LoggerFactory.getLogger(RobletRunner.class);
  private static final double NANOS = 1e9;
  private static final long HANGING_NANOS = Duration.ofSeconds(3).toNanos();
  private static final long WELL_NANOS = Duration.ofSeconds(10).toNanos();
  private static final int LONGEST_PAUSE = 10;
  private static final Duration ENDING = Duration.ofSeconds(2);

  private final Supplier<? extends Roblet> maker;
  private final RobletForm form;
  private final Backoff pauses;
  private final RobletInbox inbox = new RobletInbox();
  private final RobletLink link;
  private final Workers workers;
  private volatile RobletState state = RobletState.STARTING;
  private volatile String reason = "";
  private volatile int restarts;
  private volatile long aliveAt = System.nanoTime();
  private volatile boolean closed;
  private final CountDownLatch ending = new CountDownLatch(1);
  private Optional<Roblet> first; // only on its thread

  /**
   * Starts a roblet.
   *
   * @param maker makes an instance, first and after each failure
   * @param options where it speaks
   * @throws IOException where there is no socket
   * @throws IllegalArgumentException where the roblet does not say what it says and takes
   */
  public RobletRunner(Supplier<? extends Roblet> maker, RobletOptions options) throws IOException {
    Roblet roblet = maker.get();
    this.maker = maker;
    this.first = Optional.of(roblet);
    this.form = roblet.form();
    this.pauses = new Backoff(options.restart(), options.restart().multipliedBy(LONGEST_PAUSE));
    this.workers = new Workers(options.threads());
    this.link = new RobletLink(form, options, inbox, this::beacon);
    workers.start("roblet " + form.name() + " runs", this::live);
  }

  /**
   * What it says and takes.
   *
   * @return its form
   */
  public RobletForm form() {
    return form;
  }

  /**
   * Where it is in its life.
   *
   * @return the state
   */
  public RobletState state() {
    return state == RobletState.RUNNING
        && System.nanoTime() - aliveAt > HANGING_NANOS + Math.round(NANOS / form.frequency())
            ? RobletState.HANGING
            : state;
  }

  /**
   * Why it failed last.
   *
   * @return empty where it never did, or is well again
   */
  public String reason() {
    return state() == RobletState.HANGING ? "it has not returned for more than 3 s" : reason;
  }

  /**
   * How often it was started again.
   *
   * @return 0 where it never failed
   */
  public int restarts() {
    return restarts;
  }

  private BodyElement beacon() {
    return form.element().with("state", state().word()).with("reason", reason()).with("restarts", restarts);
  }

  private void live() {
    while (!closed) {
      long startedAt = System.nanoTime();
      try {
        oneLife();
      } catch (Exception | LinkageError | AssertionError | StackOverflowError e) {
        failed(e, System.nanoTime() - startedAt > WELL_NANOS);
      }
    }
  }

  private void oneLife() throws Exception {
    Roblet roblet = first.isPresent() ? first.get() : maker.get();
    first = Optional.empty();
    try {
      aliveAt = System.nanoTime();
      roblet.start(link);
      state = RobletState.RUNNING;
      reason = "";
      link.beacon();
      run(roblet);
    } finally {
      roblet.stop();
    }
  }

  /** On a grid of time, which begins anew where it was missed by more than a period. */
  private void run(Roblet roblet) throws Exception {
    long period = Math.round(NANOS / form.frequency());
    long next = System.nanoTime();
    while (!closed) {
      aliveAt = System.nanoTime();
      Optional<RobletInbox.Letter> letter = inbox.take(next);
      if (letter.isPresent()) {
        roblet.receive(letter.get().from(), letter.get().message(), link);
      }
      if (!closed && System.nanoTime() - next >= 0) {
        roblet.run(link);
        next += period;
        next = System.nanoTime() - next > period ? System.nanoTime() : next;
      }
    }
  }

  private void failed(Throwable e, boolean wasWell) {
    if (closed) {
      return;
    }
    LOG.warn("the roblet {} failed and is started again", form.name(), e);
    if (wasWell) {
      pauses.reset();
    }
    reason = PeerText.brief(e.getClass().getSimpleName() + (e.getMessage() == null ? "" : ": " + e.getMessage()));
    state = RobletState.FAILED;
    link.beacon();
    long until = System.nanoTime() + pauses.next().toNanos();
    Uninterruptibles.await(until, nanos -> ending.await(nanos, TimeUnit.NANOSECONDS));
    restarts++;
    state = closed ? RobletState.STOPPED : RobletState.STARTING;
    link.again();
  }

  /** Ends it: waits two seconds for it, and tells the brain that it goes. */
  @Override
  public void close() {
    closed = true;
    ending.countDown();
    inbox.close();
    workers.join(System.nanoTime() + ENDING.toNanos());
    state = RobletState.STOPPED;
    link.close();
  }
}
