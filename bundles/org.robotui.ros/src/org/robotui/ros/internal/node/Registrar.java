package org.robotui.ros.internal.node;

import java.time.Duration;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.Condition;
import java.util.concurrent.locks.ReentrantLock;
import org.robotui.message.MessageInfo;
import org.robotui.net.call.Backoff;
import org.robotui.net.call.Outcome;
import org.robotui.net.thread.Uninterruptibles;
import org.robotui.ros.LinkEvent.Kind;
import org.robotui.ros.LinkState;
import org.robotui.ros.SystemState;
import org.robotui.ros.XmlRpcValue;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Keeps the master informed, on a thread of its own: registers what is new, unregisters what is gone, and checks
 * periodically that the master still knows all of it, so that a restarted master hears of this node again.
 */
final class Registrar {

  private static final Logger LOG = LoggerFactory.getLogger(Registrar.class);

  /** The whole state with every so many checks. */
  private static final int WHOLE = 5;

  private final NodeContext context;
  private final RosApi master;
  private final String masterName;
  private final ReentrantLock lock = new ReentrantLock();
  private final Condition changed = lock.newCondition();
  /** What should be known, and whether it is. */
  private final Map<Registration, Boolean> wanted = new LinkedHashMap<>();
  private final List<Registration> unwanted = new ArrayList<>();
  private final UnregisterCalls lastWords;
  private final CountDownLatch ended = new CountDownLatch(1);
  private boolean dirty;
  private boolean closed;
  private boolean connected;
  private boolean everRegistered;
  private Optional<XmlRpcValue> runId = Optional.empty();
  private int checks;

  Registrar(NodeContext context, RosApi master, String masterName) {
    this.context = context;
    this.master = master;
    this.masterName = masterName;
    this.lastWords = new UnregisterCalls(context.options().farewells(), master);
  }

  void start() {
    context.start("master", this::run);
  }

  void add(Registration registration) {
    locked(() -> {
      unwanted.remove(registration);
      wanted.put(registration, false);
      dirty = true;
    });
  }

  void remove(Registration registration) {
    locked(() -> {
      if (wanted.remove(registration) != null) {
        unwanted.add(registration);
        dirty = true;
      }
    });
  }

  /** Drops a registration that another one of the same kind keeps alive at the master. */
  void forget(Registration registration) {
    locked(() -> wanted.remove(registration));
    lastWords.withdraw(registration);
  }

  private void locked(Runnable change) {
    lock.lock();
    try {
      change.run();
      changed.signalAll();
    } finally {
      lock.unlock();
    }
  }

  boolean awaitRegistered(Duration timeout) {
    long left = timeout.toNanos();
    lock.lock();
    try {
      while (left > 0 && !closed && !(unwanted.isEmpty() && !wanted.containsValue(false))) {
        left = changed.awaitNanos(left);
      }
      return unwanted.isEmpty() && !wanted.containsValue(false);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      return false;
    } finally {
      lock.unlock();
    }
  }

  /** Ends the thread after the call under way; answers what the master may know and should forget. */
  List<Registration> close() {
    lock.lock();
    try {
      closed = true;
      changed.signalAll();
      List<Registration> all = new ArrayList<>(unwanted);
      all.addAll(wanted.keySet());
      return everRegistered ? all : List.of();
    } finally {
      lock.unlock();
    }
  }

  /** Waits until nothing is registered any more, after it was closed; answers whether that is so. */
  boolean awaitEnd(Duration patience) {
    Uninterruptibles.await(System.nanoTime() + patience.toNanos(), nanos -> ended.await(nanos, TimeUnit.NANOSECONDS));
    return ended.getCount() == 0;
  }

  private void run() {
    try {
      keepInformed();
    } finally {
      ended.countDown();
    }
  }

  private void keepInformed() {
    Backoff backoff = context.backoff();
    report(new LinkState.Connecting());
    while (!isClosed()) {
      Optional<String> problem = reconcile();
      if (problem.isPresent()) {
        Duration pause = backoff.next();
        failed(problem.get(), pause);
        await(pause, false);
      } else {
        backoff.reset();
        succeeded();
        await(context.options().masterCheck(), true);
      }
    }
  }

  /** After the master was told all, or cannot be told. */
  void withdrawUnregisterCalls() {
    lastWords.withdrawAll();
  }

  private Optional<String> reconcile() {
    Optional<String> problem = check();
    for (Registration registration : snapshot(unwanted)) {
      problem = problem.isPresent() || isClosed() ? problem : unregister(registration);
    }
    for (Registration registration : missing()) {
      problem = problem.isPresent() || isClosed() ? problem : register(registration);
    }
    return problem;
  }

  /**
   * A master that restarts has another run id, which is a small question. All that it knows is a large answer where
   * there are many nodes, and only shows what others took from us; so it is asked for less often.
   */
  private Optional<String> check() {
    Outcome<XmlRpcValue> id = master.call("getParam", XmlRpcValue.of(context.name().text()), XmlRpcValue.of("/run_id"));
    if (id instanceof Outcome.Done<XmlRpcValue> done) {
      boolean same = runId.equals(Optional.of(done.value()));
      if (same && checks++ % WHOLE != 0) {
        return Optional.empty();
      }
      runId = Optional.of(done.value());
      if (!same) {
        forgetAll();
      }
    }
    return id instanceof Outcome.Done || id instanceof Outcome.Refused ? compare() : Optional.of(id.reason());
  }

  private Optional<String> compare() {
    Outcome<SystemState> state =
        master.call("getSystemState", XmlRpcValue.of(context.name().text())).map(GraphCodec::state);
    state.toOptional().ifPresent(this::compare);
    return switch (state) {
      case Outcome.Done<SystemState> done -> Optional.empty();
      case Outcome.Refused<SystemState> refused -> Optional
          .of(masterName + " refused to tell its state: " + refused.reason());
      default -> Optional.of(state.reason());
    };
  }

  private void forgetAll() {
    locked(() -> wanted.replaceAll((registration, known) -> false));
  }

  private void compare(SystemState state) {
    locked(() -> wanted.replaceAll((registration, known) -> known && registration.agreesWith(state)));
  }

  /** A refusal concerns this registration alone: the others go on, and it is tried again with the next check. */
  private Optional<String> register(Registration registration) {
    locked(() -> everRegistered = true);
    lastWords.leave(registration);
    Outcome<XmlRpcValue> outcome = registration.register(master);
    if (outcome instanceof Outcome.Done<XmlRpcValue> done) {
      locked(() -> wanted.computeIfPresent(registration, (key, known) -> true));
      registration.registered(done.value());
      return Optional.empty();
    }
    if (outcome instanceof Outcome.Refused) {
      LOG.warn("{}: the master refused {}: {}", context.name(), registration.what(), outcome.reason());
      return Optional.empty();
    }
    return Optional.of(registration.what() + ": " + outcome.reason());
  }

  /** A master that refuses does not know it any more: that is fine, too. */
  private Optional<String> unregister(Registration registration) {
    Outcome<XmlRpcValue> outcome = registration.unregister(master);
    if (outcome instanceof Outcome.Done || outcome instanceof Outcome.Refused) {
      lastWords.withdraw(registration);
      locked(() -> unwanted.remove(registration));
      return Optional.empty();
    }
    return Optional.of(registration.what() + ": " + outcome.reason());
  }

  private List<Registration> missing() {
    lock.lock();
    try {
      return wanted.entrySet().stream().filter(entry -> !entry.getValue()).map(Map.Entry::getKey).toList();
    } finally {
      lock.unlock();
    }
  }

  private List<Registration> snapshot(List<Registration> list) {
    lock.lock();
    try {
      dirty = false;
      return List.copyOf(list);
    } finally {
      lock.unlock();
    }
  }

  private boolean isClosed() {
    lock.lock();
    try {
      return closed;
    } finally {
      lock.unlock();
    }
  }

  private void await(Duration pause, boolean wakeOnChange) {
    long left = pause.toNanos();
    lock.lock();
    try {
      while (left > 0 && !closed && !(wakeOnChange && dirty)) {
        left = changed.awaitNanos(left);
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      closed = true;
    } finally {
      lock.unlock();
    }
  }

  private void succeeded() {
    boolean before = setConnected(true);
    if (!before) {
      report(new LinkState.Connected(masterName, MessageInfo.any()));
    }
  }

  private void failed(String reason, Duration retryAfter) {
    if (!isClosed()) {
      setConnected(false);
      report(new LinkState.Failed(reason, retryAfter));
    }
  }

  private boolean setConnected(boolean value) {
    lock.lock();
    try {
      boolean before = connected;
      connected = value;
      return before;
    } finally {
      lock.unlock();
    }
  }

  private void report(LinkState state) {
    context.report(Kind.MASTER, context.name().text(), masterName, state);
  }
}
