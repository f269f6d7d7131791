package org.robotui.rfic.player.internal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.time.Duration;
import java.util.Arrays;
import java.util.Deque;
import java.util.List;
import java.util.Map;
import java.util.SplittableRandom;
import java.util.concurrent.ConcurrentLinkedDeque;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.locks.LockSupport;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.condition.EnabledIf;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.robotui.api.link.LinkState;
import org.robotui.testkit.Effort;
import org.robotui.testkit.recorded.SharedData;

/**
 * A network that damages what real servers say: mistakes are told, links close alone, and all goes on when the network
 * is well again.
 */
@EnabledIf(value = "org.robotui.rfic.player.internal.RecordedRobot#available", disabledReason = SharedData.REASON)
class MutatedRobotTest extends PlayerRficCase {
  private static final int[] EVIL = {-1, Integer.MAX_VALUE, Integer.MIN_VALUE, 1 << 28, 1 << 16, 0, 1};
  private static final int HEADER = 40;
  private static final int FRONT = 300;
  private static final int ONE_IN = 12;
  private static final int OF_HEADERS = 20;
  private static final Duration LONG = Duration.ofSeconds(60);

  private final SplittableRandom random = new SplittableRandom(2026);
  private final AtomicBoolean damages = new AtomicBoolean(true);
  private final AtomicInteger damaged = new AtomicInteger();

  /** Mostly bodies, as damage of headers ends a link at once. Locked, since several threads write. */
  private synchronized byte[] damage(byte[] original) {
    if (!damages.get() || original.length <= HEADER || random.nextInt(ONE_IN) != 0) {
      return original;
    }
    damaged.incrementAndGet();
    byte[] bytes = original.clone();
    int from = random.nextInt(OF_HEADERS) == 0 ? 0 : HEADER;
    int front = Math.min(FRONT, bytes.length - from);
    switch (random.nextInt(4)) {
      case 0 -> ByteBuffer.wrap(bytes).putInt(from + random.nextInt(Math.max(1, front / 4)) * 4,
          EVIL[random.nextInt(EVIL.length)]);
      case 1 -> bytes = from == 0 ? Arrays.copyOf(bytes, random.nextInt(bytes.length)) : bytes;
      case 2 -> ByteBuffer.wrap(bytes).putLong(from + random.nextInt(Math.max(1, front / 8)) * 8,
          Double.doubleToRawLongBits(random.nextBoolean() ? Double.NaN : 1e300));
      default -> bytes[from + random.nextInt(front)] ^= (byte) (1 << random.nextInt(8));
    }
    return bytes;
  }

  @ParameterizedTest
  @ValueSource(strings = {"rangers", "dummy_devices", "everything_robot0", "position2d", "simulation_map_properties"})
  @Timeout(1_200)
  void damagedTrafficIsToldAndSurvived(String name) throws IOException {
    Deque<Throwable> thrown = new ConcurrentLinkedDeque<>();
    Thread.UncaughtExceptionHandler before = Thread.getDefaultUncaughtExceptionHandler();
    Thread.setDefaultUncaughtExceptionHandler((thread, e) -> thrown.add(e));
    try (RecordedRobot robot = new RecordedRobot(name, layouts, this::damage)) {
      start(Map.of("port", (long) robot.port()));
      for (Effort effort = Effort.of(30, LONG); effort.goesOn();) {
        List.copyOf(context.demands.entrySet()).forEach(d -> d.getValue().changed(true));
        LockSupport.parkNanos(100_000_000);
        context.published.values().forEach(Deque::clear);
      }
      assertTrue(damaged.get() > 0);
      assertEquals(List.of(), List.copyOf(thrown), "no thread died");
      damages.set(false);
      String port = robot.data().keySet().stream().sorted().findFirst().orElseThrow();
      await("the link is made again, is " + link(),
          () -> !(link() instanceof LinkState.Failed) && !(link() instanceof LinkState.Connecting));
      await("data come again", () -> {
        List.copyOf(context.demands.entrySet()).forEach(d -> d.getValue().changed(true));
        return context.published.entrySet().stream()
            .anyMatch(e -> e.getKey().startsWith(port) && !e.getValue().isEmpty());
      });
      context.links.stream().filter(LinkState.Failed.class::isInstance).forEach(l -> assertFalse(l.reason().isBlank()));
      rfic.close();
      await("no thread is left", () -> context.alive().isEmpty());
      assertEquals(List.of(), List.copyOf(thrown));
    } finally {
      Thread.setDefaultUncaughtExceptionHandler(before);
    }
  }
}
