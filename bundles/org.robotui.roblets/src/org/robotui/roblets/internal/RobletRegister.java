package org.robotui.roblets.internal;

import java.net.InetSocketAddress;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import org.robotui.roblets.body.Bodymap;
import org.robotui.roblets.tree.BodyElement;
import org.robotui.roblets.wire.ArrivalOrder;
import org.robotui.roblets.wire.BodyDatagram;
import org.robotui.roblets.wire.RobletForm;
import org.robotui.roblets.wire.RobletStatus;

/** The roblets that a brain knows by their beacons. Safe for all threads. */
public final class RobletRegister {
  private static final long SILENT_NANOS = Duration.ofSeconds(2).toNanos();
  private static final ArrivalOrder.Tally NOTHING = new ArrivalOrder.Tally(0, 0, 0, 0, 0);

  private final Map<String, Known> roblets = new TreeMap<>();

  private static final class Known {
    private final RobletForm form;
    private final BodyElement beacon;
    private final InetSocketAddress address;
    private final long heardAt;
    private final boolean gone;

    Known(RobletForm form, BodyElement beacon, InetSocketAddress address, long heardAt, boolean gone) {
      this.form = form;
      this.beacon = beacon;
      this.address = address;
      this.heardAt = heardAt;
      this.gone = gone;
    }
  }

  /** False where there are too many. */
  public synchronized boolean beacon(BodyDatagram datagram, InetSocketAddress from, long nowNanos) {
    RobletForm form = RobletForm.of(datagram.body().orElseThrow(() -> new IllegalArgumentException("an empty beacon")));
    if (!form.name().equals(datagram.from())) {
      throw new IllegalArgumentException("a beacon of " + datagram.from() + " about " + form.name());
    }
    if (roblets.size() >= Bodymap.MOST_ROBLETS && !roblets.containsKey(form.name())) {
      return false;
    }
    roblets.put(form.name(), new Known(form, datagram.body().get(), from, nowNanos, false));
    return true;
  }

  /** Whether a roblet speaks from there. */
  public synchronized boolean isFrom(String roblet, InetSocketAddress from) {
    Known known = roblets.get(roblet);
    return known != null && known.address.equals(from);
  }

  /** It goes with a word, where that is its own. */
  public synchronized void leave(String roblet, InetSocketAddress from) {
    if (isFrom(roblet, from)) {
      Known known = roblets.get(roblet);
      roblets.put(roblet, new Known(known.form, known.beacon, known.address, known.heardAt, true));
    }
  }

  /** Where a roblet is that is there. */
  public synchronized Optional<InetSocketAddress> address(String roblet) {
    return Optional.ofNullable(roblets.get(roblet)).filter(k -> !k.gone).map(k -> k.address);
  }

  public synchronized Optional<RobletForm> form(String roblet) {
    return Optional.ofNullable(roblets.get(roblet)).map(k -> k.form);
  }

  /** What a roblet has to know of others: where its friends are, and who may speak to it. */
  public synchronized List<BodyElement> neighbours(RobletForm form) {
    List<BodyElement> all = new ArrayList<>();
    roblets.values().stream().filter(k -> !k.gone).forEach(other -> {
      if (form.friends().contains(other.form.name())) {
        all.add(place("friend", other));
      }
      if (other.form.friends().contains(form.name())) {
        all.add(place("speaker", other));
      }
    });
    return all;
  }

  private static BodyElement place(String what, Known known) {
    return BodyElement.of(what).with("name", known.form.name())
        .with("host", known.address.getAddress().getHostAddress()).with("port", known.address.getPort());
  }

  public synchronized List<RobletStatus> statuses(ArrivalOrder order, long nowNanos) {
    return roblets.values().stream().map(k -> status(k, order, nowNanos)).toList();
  }

  private static RobletStatus status(Known known, ArrivalOrder order, long nowNanos) {
    long silence = nowNanos - known.heardAt;
    boolean silent = silence > SILENT_NANOS;
    String state = known.gone ? RobletStatus.STOPPED
        : silent ? RobletStatus.SILENT : known.beacon.attribute("state").orElse(RobletStatus.RUNNING);
    String reason = known.gone ? "it was ended"
        : silent ? "no beacon of it comes any more" : known.beacon.attribute("reason").orElse("");
    return new RobletStatus(known.form, state, reason,
        known.address.getAddress().getHostAddress() + ":" + known.address.getPort(),
        (long) known.beacon.number("restarts").orElse(0), silence / 1e9,
        order.tally(known.form.name()).orElse(NOTHING));
  }
}
