package org.robotui.rfic.player.internal.link;

import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.BooleanSupplier;
import javax.net.SocketFactory;
import org.robotui.api.RficContext;
import org.robotui.api.link.LinkState;
import org.robotui.api.link.Pulse;
import org.robotui.api.port.Offer;
import org.robotui.api.session.LinkChanges;
import org.robotui.api.session.RobotSession;
import org.robotui.player.client.ClientOptions;
import org.robotui.player.client.PlayerClient;
import org.robotui.player.layout.Layouts;
import org.robotui.player.wire.DeviceAddress;
import org.robotui.rfic.player.internal.PlayerSettings;
import org.robotui.rfic.player.internal.call.PlayerBrowser;
import org.robotui.rfic.player.internal.call.PlayerCalls;
import org.robotui.rfic.player.internal.call.PlayerPorts;
import org.robotui.rfic.player.internal.convert.FrameNames;
import org.robotui.rfic.player.internal.device.DeviceFeed;
import org.robotui.rfic.player.internal.device.FrameTree;
import org.robotui.rfic.player.internal.device.Surroundings;

/** One client, and all that is offered through it. The client keeps the link; this follows what the server has. */
public final class PlayerSession implements RobotSession {
  private static final long LOOK_MILLIS = 50;
  private static final Duration ANSWER = Duration.ofSeconds(3);
  private static final Duration HANDSHAKE = Duration.ofSeconds(5);
  private static final Duration LONGEST_PAUSE = Duration.ofSeconds(5);

  private final RficContext context;
  private final PlayerSettings settings;
  private final PlayerClient client;
  private final FrameTree tree;
  private final Stamps stamps;
  private final Devices devices;
  private final Liveness liveness;
  private final Offer services;
  private final Offer graph;
  private final AtomicBoolean renewed = new AtomicBoolean();
  private volatile org.robotui.player.client.LinkState state = new org.robotui.player.client.LinkState.Connecting();
  /** The latest loss that is not told yet: a link that is made again between two looks was lost all the same. */
  private final AtomicReference<Optional<LinkState>> lost = new AtomicReference<>(Optional.empty());
  private final LinkChanges link;

  /**
   * Begins to connect.
   *
   * @param context what core gives
   * @param settings how the server is reached
   * @param sockets makes its connections
   */
  public PlayerSession(RficContext context, PlayerSettings settings, SocketFactory sockets) {
    this.context = context;
    this.settings = settings;
    this.link = new LinkChanges(context.link());
    Layouts layouts = Layouts.standard();
    Pulse pulse = new Pulse();
    this.stamps = new Stamps(context.clock(), settings.clock());
    this.tree = new FrameTree(context, new FrameNames(context.robot(), settings.frames()));
    this.client = new PlayerClient(settings.host(), settings.port(), layouts, options(sockets));
    this.liveness = new Liveness(client, pulse);
    Surroundings around =
        new Surroundings(context, layouts, tree, stamps, pulse, settings.sonars(), this::isBase, this::carries,
            settings.peer());
    this.devices = new Devices(settings, layouts, address -> new DeviceFeed(client.device(address.id()), around));
    this.services = context.offers().call(PlayerPorts.SERVICES, new PlayerCalls(devices, layouts));
    this.graph = context.offers().browse(PlayerPorts.GRAPH, new PlayerBrowser(client, devices, layouts));
  }

  private ClientOptions options(SocketFactory sockets) {
    ClientOptions s = ClientOptions.standard(context.threads());
    return new ClientOptions(s.threads(), this::linked, settings.key(), settings.pull(), settings.newestOnly(),
        HANDSHAKE, s.messageTime(),
        ANSWER, s.maxRequests(), s.minBackoff(), LONGEST_PAUSE, sockets);
  }

  private void linked(org.robotui.player.client.LinkState now) {
    state = now;
    if (now instanceof org.robotui.player.client.LinkState.Failed failed) {
      stamps.restart();
      lost.set(Optional.of(failed(failed)));
    } else if (now instanceof org.robotui.player.client.LinkState.Connected) {
      renewed.set(true);
    }
  }

  private boolean isBase(String device) {
    return devices.isBase(device);
  }

  /** Who looks at anything of a robot has to know where it is. */
  private boolean carries(String device) {
    return isBase(device) && (tree.wanted() || devices.all().values().stream().anyMatch(DeviceFeed::placedAndWanted));
  }

  /** Follows what the server has until the robot interface ends. */
  @Override
  public Optional<String> follow(BooleanSupplier over) throws InterruptedException {
    List<DeviceAddress> known = List.of();
    while (!over.getAsBoolean()) {
      long now = System.nanoTime();
      if (state instanceof org.robotui.player.client.LinkState.Connected) {
        if (renewed.getAndSet(false)) {
          liveness.restart();
        }
        List<DeviceAddress> listed = liveness.listed();
        if (!listed.equals(known)) {
          devices.follow(listed);
          known = listed;
        }
        liveness.tick(now);
        SilentStreams.look(devices.all().values(), now);
      }
      devices.all().values().forEach(feed -> feed.tick(now));
      report(now);
      Thread.sleep(LOOK_MILLIS);
    }
    return Optional.empty();
  }

  private static LinkState failed(org.robotui.player.client.LinkState.Failed failed) {
    return new LinkState.Failed(Remedies.with(failed.reason()), failed.retryAfter());
  }

  private void report(long now) {
    lost.getAndSet(Optional.empty()).ifPresent(link::report);
    LinkState next = switch (state) {
      case org.robotui.player.client.LinkState.Connecting c -> new LinkState.Connecting(settings.peer());
      case org.robotui.player.client.LinkState.Failed f -> failed(f);
      case org.robotui.player.client.LinkState.Connected c -> connected(now);
      case org.robotui.player.client.LinkState.Closed c -> new LinkState.Disconnected();
    };
    link.report(next);
  }

  private LinkState connected(long now) {
    String silent = liveness.problem(now);
    String problem = silent.isEmpty() ? devices.problem() : silent;
    return problem.isEmpty() ? new LinkState.Connected(settings.peer())
        : new LinkState.Degraded(settings.peer(), problem);
  }

  /** Stops what we drive, closes the devices and then the link; bounded also where the server hangs. */
  @Override
  public void close() {
    services.close();
    graph.close();
    devices.close();
    client.close();
    tree.close();
  }
}
