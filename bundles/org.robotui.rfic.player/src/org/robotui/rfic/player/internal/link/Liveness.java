package org.robotui.rfic.player.internal.link;

import java.time.Duration;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.atomic.AtomicBoolean;
import org.robotui.api.link.Pulse;
import org.robotui.net.call.Outcome;
import org.robotui.player.client.PlayerClient;
import org.robotui.player.interfaces.Server;
import org.robotui.player.layout.Empty;
import org.robotui.player.wire.DeviceAddress;

/**
 * Whether the server lives, by asking for its devices again and again: a server that hangs, or a network that is cut,
 * leaves a connection as it was. {@link #tick} is for one thread.
 */
final class Liveness {
  private static final long EVERY_NANOS = Duration.ofMillis(1500).toNanos();

  private final PlayerClient client;
  private final Pulse pulse;
  private final AtomicBoolean asking = new AtomicBoolean();
  private long askedAt = System.nanoTime();
  private volatile long answeredAt = System.nanoTime();
  private volatile boolean silent;
  private volatile List<DeviceAddress> listed = List.of();

  Liveness(PlayerClient client, Pulse pulse) {
    this.client = client;
    this.pulse = pulse;
  }

  /** A link was made. */
  void restart() {
    listed = client.devices();
    answeredAt = System.nanoTime();
    silent = false;
  }

  /** The devices by the latest answer: drivers may come and go while a server runs. */
  List<DeviceAddress> listed() {
    return listed;
  }

  void tick(long nowNanos) {
    if (nowNanos - askedAt < EVERY_NANOS || !asking.compareAndSet(false, true)) {
      return;
    }
    askedAt = nowNanos;
    client.server().request(Server.DEVICES, new Empty()).thenAccept(this::answered);
  }

  private void answered(Outcome<Server.DeviceList> outcome) {
    asking.set(false);
    if (outcome instanceof Outcome.TimedOut<Server.DeviceList>) {
      silent = true;
    } else if (!(outcome instanceof Outcome.Failed<Server.DeviceList>)) {
      silent = false;
      answeredAt = System.nanoTime();
      pulse.answered(answeredAt);
      outcome.toOptional().ifPresent(list -> listed = list.devices().stream()
          .map(d -> new DeviceAddress((int) d.host(), (int) d.robot(), d.interfaceCode(), d.index())).toList());
    }
  }

  /** What is wrong with it, empty where it lives. */
  String problem(long nowNanos) {
    return silent
        ? String.format(Locale.ROOT,
            "the server has not answered for %.0f s: it hangs, or the network is cut; what is shown may be old",
            (nowNanos - answeredAt) / 1e9)
        : "";
  }
}
