package org.robotui.core.internal.life;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicBoolean;
import org.robotui.api.UicType;
import org.robotui.api.host.Match;
import org.robotui.api.host.MatchState;
import org.robotui.api.host.ViewFit;
import org.robotui.api.port.PortKind;
import org.robotui.api.port.SourceId;
import org.robotui.core.internal.config.model.ConnectionConfig;
import org.robotui.core.internal.config.model.RuicConfig;
import org.robotui.core.internal.match.Choice;
import org.robotui.core.internal.match.Have;
import org.robotui.core.internal.match.Matcher;
import org.robotui.core.internal.match.Supplier;
import org.robotui.core.internal.match.ViewFits;
import org.robotui.core.internal.match.Want;
import org.robotui.core.internal.port.Offered;

/** Matches the ports of one RUIC again and again, and connects them as matching says. */
public final class Wiring {
  private record Key(PortKind kind, SourceId id) {}

  private final RuicParts ruic;
  private final Components components;
  private final Runnable changed;
  private final AtomicBoolean requested = new AtomicBoolean();
  private final AtomicBoolean scheduled = new AtomicBoolean();
  private volatile List<Match> matches = List.of();

  Wiring(RuicParts ruic, Components components, Runnable changed) {
    this.ruic = ruic;
    this.components = components;
    this.changed = changed;
  }

  /** Has it matched again soon, once for any number of requests. */
  void request() {
    if (requested.compareAndSet(false, true)) {
      ruic.serial().execute(this::rematch);
    }
  }

  /** Matches now. On the worker. */
  void rematch() {
    requested.set(false);
    List<Offered> offers = components.rfics().stream().flatMap(s -> s.offers().stream()).toList();
    List<Have> haves = offers.stream().map(o -> new Have(o.id(), o.port())).toList();
    List<Want> wants = components.shown().stream().flatMap(s -> s.wants().stream()).toList();
    List<Supplier> suppliers = components.rfics().stream().map(RficSlot::supplier).toList();
    List<Match> result = Matcher.match(wants, haves, suppliers, choices());
    apply(result, offers);
    boolean news = !result.equals(matches);
    matches = result;
    if (news) {
      changed.run();
    }
    lookAgain(suppliers);
  }

  /** How well types of views fit what the robots offer now. */
  List<ViewFit> fits(List<UicType> types) {
    List<Have> haves = components.rfics().stream().flatMap(s -> s.offers().stream())
        .map(o -> new Have(o.id(), o.port())).toList();
    return ViewFits.of(types, haves, components.rfics().stream().map(RficSlot::supplier).toList());
  }

  /** What is pending because an interface is still looking must not stay so when it has found all there is. */
  private void lookAgain(List<Supplier> suppliers) {
    boolean open = suppliers.stream().anyMatch(s -> !s.settled());
    if (open && scheduled.compareAndSet(false, true)) {
      ruic.services().timer().schedule(() -> {
        scheduled.set(false);
        request();
      }, RficSlot.SETTLING.toMillis() + 1, TimeUnit.MILLISECONDS);
    }
  }

  /** The connections that were named: in the file, and, before that, by the user. */
  public static Map<SourceId, Choice> choices(RuicConfig config, Map<SourceId, SourceId> chosen) {
    Map<SourceId, Choice> choices = new HashMap<>();
    for (ConnectionConfig c : config.connections()) {
      choices.put(c.port(), new Choice(c.peers(), config.file() + ":" + c.line()));
    }
    chosen.forEach((port, peer) -> choices.put(port, new Choice(List.of(peer), "your own choice")));
    return choices;
  }

  /** The connections that are named now. */
  Map<SourceId, Choice> choices() {
    return choices(ruic.config(), ruic.overlay().connections());
  }

  private void apply(List<Match> result, List<Offered> offers) {
    Map<Key, Offered> byId = new HashMap<>();
    offers.forEach(o -> byId.put(new Key(o.port().kind(), o.id()), o));
    for (Match match : result) {
      List<SourceId> fitting = leavesTheChoice(match) ? match.candidates() : match.peers();
      List<Offered> peers = fitting.stream().map(p -> byId.get(new Key(match.kind(), p))).toList();
      ends(match.port().component()).ifPresent(e -> e.connect(match, peers));
    }
  }

  private Optional<UicEnds> ends(String uic) {
    return components.uic(uic).flatMap(Slot::instance).map(UicInstance::ends);
  }

  /** What matching says; the peers of ports whose views choose are what is chosen now. */
  List<Match> matches() {
    return matches.stream().map(this::withChosen).toList();
  }

  private Match withChosen(Match match) {
    return leavesTheChoice(match)
        ? ends(match.port().component()).map(e -> withPeers(match, e.sources(match))).orElse(match)
        : match;
  }

  /** Whether all that fits is connected, and the view chooses among it. */
  private static boolean leavesTheChoice(Match match) {
    return match.state() == MatchState.CONNECTED && match.peers().isEmpty();
  }

  private static Match withPeers(Match m, List<SourceId> peers) {
    return new Match(m.port(), m.kind(), m.typeName(), m.arity(), m.state(), peers, m.candidates(), m.reason());
  }

  void clear() {
    matches = List.of();
  }
}
