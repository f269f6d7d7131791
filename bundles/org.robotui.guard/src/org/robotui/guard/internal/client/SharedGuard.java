package org.robotui.guard.internal.client;

import java.io.IOException;
import java.net.InetSocketAddress;
import java.time.Duration;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.atomic.LongAdder;
import org.robotui.guard.Guard;
import org.robotui.guard.GuardState;
import org.robotui.guard.internal.wire.Wire;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** Keeps one process alive while somebody uses it, and what is to be said with it. */
public final class SharedGuard {
  private static final Logger LOG = LoggerFactory.getLogger(SharedGuard.class);
  private static final long PAUSE = Duration.ofSeconds(1).toNanos();

  /** What is to be said to whom. */
  private record Words(InetSocketAddress to, byte[] bytes) {}

  private final Launch launch;
  private final Map<Integer, Words> farewells = new LinkedHashMap<>();
  private final LongAdder overflows = new LongAdder();
  private final LongAdder silences = new LongAdder();
  private Optional<GuardProcess> process = Optional.empty();
  private int users;
  private int nextId;
  private int kept;
  private long starts;
  private long lastStart;

  /**
   * Runs nothing yet.
   *
   * @param launch how a process is started
   */
  public SharedGuard(Launch launch) {
    this.launch = launch;
  }

  /**
   * One more user.
   *
   * @return what it has
   * @throws IOException where no process can be started
   */
  public synchronized Guard open() throws IOException {
    users++;
    try {
      running();
    } catch (IOException e) {
      release();
      throw e;
    }
    return new GuardUse(this);
  }

  /** The process, started again where it is gone; after that not before a second has passed. */
  synchronized GuardProcess running() throws IOException {
    Optional<GuardProcess> alive = process.filter(GuardProcess::isAlive);
    if (alive.isPresent()) {
      return alive.get();
    }
    if (users == 0) {
      throw new IOException("the guard is closed");
    }
    if (starts > 0 && System.nanoTime() - lastStart < PAUSE) {
      throw new IOException("the guard ended, and is started again in a moment");
    }
    lastStart = System.nanoTime();
    starts++;
    GuardProcess started = GuardProcess.start(launch, new Ears());
    process = Optional.of(started);
    for (Map.Entry<Integer, Words> farewell : farewells.entrySet()) {
      started.keep(farewell.getKey(), farewell.getValue().to(), farewell.getValue().bytes());
    }
    return started;
  }

  synchronized Optional<Integer> keep(InetSocketAddress to, byte[] words) {
    boolean fits = words.length <= Wire.MOST_WORDS && kept + words.length <= Wire.ALL_WORDS
        && farewells.size() < Wire.MOST_FAREWELLS;
    if (!fits || to.isUnresolved()) {
      LOG.warn("a farewell of {} bytes to {} is not kept: {} with {} bytes are", words.length, to, farewells.size(),
          kept);
      return Optional.empty();
    }
    int id = nextId++;
    farewells.put(id, new Words(to, words.clone()));
    kept += words.length;
    tell(alive -> alive.keep(id, to, words));
    return Optional.of(id);
  }

  synchronized void withdraw(int id) {
    Words withdrawn = farewells.remove(id);
    if (withdrawn != null) {
      kept -= withdrawn.bytes().length;
      tell(alive -> alive.withdraw(id));
    }
  }

  /** What may fail with the process. */
  @FunctionalInterface
  private interface Telling {
    void to(GuardProcess process) throws IOException;
  }

  /** Where the process is gone, the next one is told all. */
  private void tell(Telling telling) {
    try {
      Optional<GuardProcess> alive = process.filter(GuardProcess::isAlive);
      if (alive.isPresent()) {
        telling.to(alive.get());
      }
    } catch (IOException e) {
      LOG.debug("not told: {}", e.getMessage());
    }
  }

  synchronized void release() {
    users--;
    if (users == 0) {
      process.ifPresent(GuardProcess::close);
      process = Optional.empty();
    }
  }

  synchronized GuardState state() {
    return new GuardState(process.filter(GuardProcess::isAlive).map(GuardProcess::pid).orElse(0L), starts,
        overflows.sum(), silences.sum());
  }

  /** What a process tells. */
  private final class Ears implements GuardProcess.Listener {
    @Override
    public void overflow() {
      overflows.increment();
    }

    @Override
    public void silence() {
      silences.increment();
    }

    @Override
    public void lost() {
      LOG.warn("the guard ended; it is started again");
      try {
        Thread.sleep(Duration.ofNanos(PAUSE));
        running();
      } catch (IOException e) {
        LOG.debug("not started: {}", e.getMessage());
      } catch (InterruptedException e) {
        Thread.currentThread().interrupt();
      }
    }
  }
}
