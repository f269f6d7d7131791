package org.robotui.rfic.player.internal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Collection;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.locks.LockSupport;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.robotui.player.client.ClientOptions;
import org.robotui.player.client.DeviceState;
import org.robotui.player.client.PlayerClient;
import org.robotui.player.client.PlayerDevice;
import org.robotui.player.interfaces.Pose2d;
import org.robotui.player.interfaces.Position2d;
import org.robotui.player.server.ServedDevice;
import org.robotui.player.server.TypedHandler;
import org.robotui.player.wire.DeviceId;

/**
 * A server that keeps a rule of Stage: a model is switched on when a client opens it, and off when any client closes
 * it.
 */
class SilentStreamTest extends PlayerRficCase {
  private static final Position2d.State STATE = new Position2d.State(new Pose2d(1, 2, 0), new Pose2d(0, 0, 0), false);

  private final AtomicBoolean ended = new AtomicBoolean();
  private final AtomicInteger closings = new AtomicInteger();

  /** A model that sends fifty times a second while it is switched on. */
  private final class Model {
    private final AtomicBoolean on = new AtomicBoolean();
    private final AtomicInteger opened = new AtomicInteger();
    private final ServedDevice device;

    Model(String name) {
      device = add(name, new TypedHandler(layouts, count -> switchTo(name, count)));
      DAEMONS.newThread(this::run).start();
    }

    private void switchTo(String name, int count) {
      boolean more = count > opened.getAndSet(count);
      on.set(more);
      clients.put(name, count);
      if (!more && name.equals("position2d:0")) {
        closings.incrementAndGet();
      }
    }

    private void run() {
      while (!ended.get()) {
        if (on.get()) {
          device.publish(Position2d.STATE, STATE, STAMP);
        }
        LockSupport.parkNanos(20_000_000);
      }
    }
  }

  @AfterEach
  void endModels() {
    ended.set(true);
  }

  private int count(String port) {
    return Optional.ofNullable(context.published.get(port)).map(Collection::size).orElse(0);
  }

  @Test
  void whatStopsWhenAnotherClientLeavesIsAskedForAgain() {
    new Model("position2d:0");
    Model second = new Model("position2d:1");
    startConnected();
    want("position2d:0");
    want("position2d:1");
    await("both come regularly", () -> count("position2d:0") > 60 && count("position2d:1") > 60);

    try (PlayerClient other = new PlayerClient("127.0.0.1", server.port(), layouts, ClientOptions.standard(DAEMONS))) {
      PlayerDevice shared = other.device(new DeviceId(4, 1));
      shared.subscribe((message, nanos) -> {});
      await("the other client has it open", () -> shared.state() instanceof DeviceState.Open);
      await("two have it open", () -> clients.get("position2d:1") == 2);
    }
    await("the other has gone, and the model is off", () -> clients.get("position2d:1") == 1 && !second.on.get());
    int before = count("position2d:1");
    await("data come again", () -> count("position2d:1") > before + 20);
    assertTrue(second.on.get());
    assertEquals(1, clients.get("position2d:1"), "it is open once");
    assertEquals(0, closings.get(), "what comes is left alone");
  }
}
