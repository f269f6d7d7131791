package org.robotui.core.internal.life;

import java.time.Duration;
import java.util.List;
import java.util.Optional;
import org.robotui.api.RficType;
import org.robotui.api.config.Settings;
import org.robotui.api.host.ComponentStatus;
import org.robotui.api.link.LinkState;
import org.robotui.core.internal.config.model.ComponentConfig;
import org.robotui.core.internal.match.Supplier;
import org.robotui.core.internal.port.Link;
import org.robotui.core.internal.port.Offered;

/** The place of one robot interface. */
final class RficSlot extends Slot<RficType, RficInstance> {
  /** So long after its last news, a connected robot interface may still find more. */
  static final Duration SETTLING = Duration.ofSeconds(3);

  RficSlot(ComponentConfig config, ComponentHome ruic) {
    super(config, ruic);
  }

  @Override
  Optional<RficType> find() {
    return ruic().services().registry().rfic(config().type());
  }

  @Override
  String missing() {
    return ruic().services().registry().missingRfic(config().type());
  }

  @Override
  RficInstance make(RficType of, Settings settings) {
    return new RficInstance(config(), of, settings, ruic());
  }

  /** What it offers now. */
  List<Offered> offers() {
    return instance().map(i -> i.table().list()).orElse(List.of());
  }

  /** What matching has to know. */
  Supplier supplier() {
    return instance().map(i -> supplier(i.linkNow(), i.table().changedAt()))
        .orElseGet(() -> new Supplier(id(), false, "has failed: " + health().reason()));
  }

  private Supplier supplier(Link link, long offersChanged) {
    if (!link.isUp()) {
      return new Supplier(id(), false, "is not connected yet (" + link.text() + ")");
    }
    long news = Math.max(link.since(), offersChanged);
    boolean settled = ruic().services().clock().nanos() - news >= SETTLING.toNanos();
    return new Supplier(id(), settled, "is connected and still looking for what there is");
  }

  LinkState link() {
    // Without an instance nobody tries again by itself, so that it is no failed link.
    return instance().map(i -> i.linkNow().state()).orElseGet(LinkState.Disconnected::new);
  }

  ComponentStatus status() {
    Health now = health();
    return new ComponentStatus(
        id(), config().type(), ComponentStatus.Kind.RFIC, now.state(), now.reason(), Optional.of(link()));
  }
}
