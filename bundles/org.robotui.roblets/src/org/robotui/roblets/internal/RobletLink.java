package org.robotui.roblets.internal;

import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.UnknownHostException;
import java.time.Duration;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.Supplier;
import org.robotui.roblets.roblet.RobletOptions;
import org.robotui.roblets.roblet.RobletSpeech;
import org.robotui.roblets.tree.BodyElement;
import org.robotui.roblets.wire.ArrivalOrder;
import org.robotui.roblets.wire.BodyDatagram;
import org.robotui.roblets.wire.DatagramKind;
import org.robotui.roblets.wire.RobletForm;

/** How one roblet is heard and hears: beacons, where brain and friends are, and what they say. */
public final class RobletLink implements DatagramEndpoint.Handler, RobletSpeech, AutoCloseable {
  private static final String BRAIN = "brain";
  private static final long BEACON_NANOS = Duration.ofMillis(500).toNanos();
  private static final long FIRST_NANOS = Duration.ofMillis(100).toNanos();
  private static final long SILENCE_NANOS = Duration.ofSeconds(3).toNanos();

  private final RobletForm form;
  private final RobletOptions options;
  private final RobletInbox inbox;
  private final Supplier<BodyElement> beacon;
  private final DatagramEndpoint endpoint;
  private final ArrivalOrder order = new ArrivalOrder();
  private final Map<String, SenderRun> toFriends = new ConcurrentHashMap<>();
  private volatile SenderRun sender;
  private volatile Optional<InetSocketAddress> brain = Optional.empty();
  private volatile Map<String, InetSocketAddress> friends = Map.of();
  private volatile Map<String, InetSocketAddress> speakers = Map.of();
  private volatile long heardAt;
  private long beaconAt = System.nanoTime(); // only on the reading thread, as the next one
  private long pauseNanos = FIRST_NANOS;

  public RobletLink(RobletForm form, RobletOptions options, RobletInbox inbox, Supplier<BodyElement> beacon)
      throws IOException {
    this.form = form;
    this.options = options;
    this.inbox = inbox;
    this.beacon = beacon;
    this.sender = SenderRun.of(form.name());
    this.endpoint = DatagramEndpoint.bound(new InetSocketAddress(options.own(), 0), "roblet " + form.name(),
        options.threads());
    endpoint.open(this);
  }

  /** What it says from now on belongs to another run. */
  public void again() {
    sender = sender.again();
    toFriends.clear();
    inbox.clear();
  }

  @Override
  public void idle(long nowNanos) {
    if (nowNanos - beaconAt >= 0) {
      beacon();
      beaconAt = nowNanos + pauseNanos;
      // not more often where no answer comes: a brain that has no time would be given still more to read
      pauseNanos = Math.min(BEACON_NANOS, 2 * pauseNanos);
    }
    if (brain.isPresent() && nowNanos - heardAt > SILENCE_NANOS) {
      brain = Optional.empty(); // another one may answer a broadcast
    }
  }

  /** Tells the brain at once how it is. One after the other: else what it was before could be told last. */
  public synchronized void beacon() {
    endpoint.say(sender, DatagramKind.BEACON, BRAIN, Optional.of(beacon.get()), options.brain());
  }

  @Override
  public void arrived(BodyDatagram datagram, byte[] bytes, InetSocketAddress from, long nowNanos) {
    boolean ours = datagram.to().equals(form.name()) && datagram.body().isPresent();
    if (ours && datagram.kind() == DatagramKind.WELCOME && trusted(from)) {
      heardAt = nowNanos;
      brain = Optional.of(from);
      friends = addresses(datagram.body().get(), "friend");
      speakers = addresses(datagram.body().get(), "speaker");
    } else if (ours && datagram.kind() == DatagramKind.MESSAGE && maySpeak(datagram.from(), from)
        && order.judge(datagram, nowNanos).isNew()) {
      inbox.put(datagram.from(), datagram.body().get());
    }
  }

  /** The brain whose address was told; where that was a broadcast, the first one that answers. */
  private boolean trusted(InetSocketAddress from) {
    return from.equals(options.brain()) || brain.map(from::equals)
        .orElse(from.getPort() == options.brain().getPort() && !options.brain().getAddress().isLoopbackAddress());
  }

  private boolean maySpeak(String name, InetSocketAddress from) {
    return name.equals(BRAIN) ? brain.filter(from::equals).isPresent() : from.equals(speakers.get(name));
  }

  private static Map<String, InetSocketAddress> addresses(BodyElement welcome, String what) {
    Map<String, InetSocketAddress> all = new HashMap<>();
    welcome.children().stream().filter(c -> c.name().equals(what)).forEach(c -> all.put(c.attribute("name").orElse(""),
        address(c.attribute("host").orElse(""), (int) c.needed("port"))));
    return Map.copyOf(all);
  }

  /** Numbers alone: a name would be looked up. */
  private static InetSocketAddress address(String host, int port) {
    if (!host.matches("[0-9.]{7,15}|[0-9A-Fa-f:.]{2,45}") || port < 1 || port > 0xffff) {
      throw new IllegalArgumentException("'" + host + "' and " + port + " are no address");
    }
    try {
      return new InetSocketAddress(InetAddress.getByName(host), port);
    } catch (UnknownHostException e) {
      throw new IllegalArgumentException(e);
    }
  }

  @Override
  public void say(BodyElement message) {
    brain.ifPresent(there -> endpoint.say(sender, DatagramKind.MESSAGE, BRAIN, Optional.of(message), there));
  }

  @Override
  public boolean tell(String friend, BodyElement message) {
    InetSocketAddress there = friends.get(friend);
    return there != null && form.friends().contains(friend)
        && endpoint.say(toFriends.computeIfAbsent(friend, name -> sender.beside()), DatagramKind.MESSAGE, friend,
            Optional.of(message), there);
  }

  @Override
  public void close() {
    endpoint.say(sender, DatagramKind.LEAVE, BRAIN, Optional.empty(), brain.orElse(options.brain()));
    endpoint.close();
  }
}
