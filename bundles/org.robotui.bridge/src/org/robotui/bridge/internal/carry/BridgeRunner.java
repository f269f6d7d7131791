package org.robotui.bridge.internal.carry;

import java.time.Duration;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.locks.Lock;
import java.util.concurrent.locks.LockSupport;
import java.util.concurrent.locks.ReentrantLock;
import java.util.function.Function;
import org.robotui.api.bridge.BridgeConfig;
import org.robotui.api.bridge.BridgeStatus;
import org.robotui.api.bridge.BridgeTransform.Direction;
import org.robotui.api.bridge.BridgeWords;
import org.robotui.api.host.Host;
import org.robotui.bridge.internal.TransformTable;
import org.robotui.net.thread.Uninterruptibles;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Carries values on a thread of its own, so that the threads that receive them never wait. It is woken when values
 * come, and looks by itself for those that have to wait.
 */
public final class BridgeRunner implements AutoCloseable {
  private static final Logger LOG = LoggerFactory.getLogger(BridgeRunner.class);
  private static final long LOOK_NANOS = 200_000_000L;
  private static final long BUSY_PAUSE = 500_000L;
  private static final long IDLE_PAUSE = 50_000_000L;
  private static final long EMPTY_PAUSE = 100_000_000L;
  private static final Duration END = Duration.ofSeconds(2);

  private final Host host;
  private final CarryContext surroundings;
  private final Map<BridgeConfig, List<CarriedWay>> running = new LinkedHashMap<>();
  private final Thread thread = Thread.ofPlatform().daemon().name("robotui-bridges").unstarted(this::run);
  private final AtomicBoolean woken = new AtomicBoolean();
  private volatile List<CarriedWay> ways = List.of();
  private volatile boolean closed;

  /** Begins at once. */
  public BridgeRunner(Host host, TransformTable transforms) {
    this.host = host;
    this.surroundings = new CarryContext(host, transforms, this::wake);
    thread.start();
  }

  /** Once until the thread looks, however much comes: waking a thread costs more than to hand over a value. */
  private void wake() {
    if (!woken.get() && woken.compareAndSet(false, true)) {
      LockSupport.unpark(thread);
    }
  }

  /** How the bridges are doing. */
  public List<BridgeStatus> statuses() {
    return ways.stream().map(CarriedWay::status).toList();
  }

  private void run() {
    long look = System.nanoTime();
    while (!closed) {
      long now = System.nanoTime();
      if (now - look >= 0) {
        guarded(this::follow);
        ways.forEach(way -> guarded(() -> way.look(now)));
        look = now + LOOK_NANOS;
      }
      woken.set(false);
      ways.forEach(way -> guarded(() -> way.carry(now)));
      boolean busy = ways.stream().anyMatch(CarriedWay::isWaiting);
      if (!woken.get()) {
        LockSupport.parkNanos(busy ? BUSY_PAUSE : ways.isEmpty() ? EMPTY_PAUSE : IDLE_PAUSE);
      }
    }
    ways.forEach(way -> guarded(way::close));
  }

  /** One bridge that fails must not end the others. */
  private static void guarded(Runnable part) {
    try {
      part.run();
    } catch (RuntimeException e) {
      LOG.warn("a bridge failed", e);
    }
  }

  /** Those whose configuration stays go on as they are. */
  private void follow() {
    List<BridgeConfig> wanted = host.bridges();
    List<BridgeConfig> gone = running.keySet().stream().filter(config -> !wanted.contains(config)).toList();
    gone.forEach(config -> running.remove(config).forEach(CarriedWay::close));
    wanted.forEach(config -> running.computeIfAbsent(config, this::ways));
    List<CarriedWay> all = new ArrayList<>();
    wanted.forEach(config -> all.addAll(running.get(config)));
    ways = List.copyOf(all);
  }

  private List<CarriedWay> ways(BridgeConfig config) {
    return switch (config.settings().text("kind")) {
      case BridgeWords.VALUES -> ways(config, direction -> new BridgeWay(config, direction, surroundings));
      case BridgeWords.PARAMETER -> {
        Lock shared = new ReentrantLock();
        yield ways(config, direction -> new ParameterWay(config, direction, surroundings, shared));
      }
      default -> List.of(new ServiceWay(config, surroundings));
    };
  }

  private static List<CarriedWay> ways(BridgeConfig config, Function<Direction, CarriedWay> made) {
    CarriedWay forth = made.apply(Direction.FORTH);
    return config.settings().flag("both") ? List.of(forth, made.apply(Direction.BACK)) : List.of(forth);
  }

  /** What bridges move has been stopped, and leases given back, when this returns. */
  @Override
  public void close() {
    closed = true;
    LockSupport.unpark(thread);
    if (Thread.currentThread() != thread) {
      Uninterruptibles.await(System.nanoTime() + END.toNanos(), nanos -> thread.join(Duration.ofNanos(nanos)));
    }
  }
}
