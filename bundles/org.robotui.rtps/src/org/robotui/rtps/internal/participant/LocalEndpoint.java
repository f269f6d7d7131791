package org.robotui.rtps.internal.participant;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.Consumer;
import org.robotui.rtps.Endpoint;
import org.robotui.rtps.EndpointInfo;
import org.robotui.rtps.EndpointKind;
import org.robotui.rtps.Guid;
import org.robotui.rtps.MatchListener;
import org.robotui.rtps.Mismatch;
import org.robotui.rtps.Qos;
import org.robotui.rtps.internal.endpoint.Destination;

/** A reader or writer of this participant. What it is matched with changes under the lock of {@link Matching}. */
abstract class LocalEndpoint implements Endpoint {

  private final EndpointInfo info;
  private final Matching matching;
  private final Map<Guid, EndpointInfo> matched = new LinkedHashMap<>();
  private final Map<Guid, Mismatch> mismatches = new LinkedHashMap<>();
  private final CopyOnWriteArrayList<MatchListener> listeners = new CopyOnWriteArrayList<>();

  LocalEndpoint(EndpointInfo info, Matching matching) {
    this.info = info;
    this.matching = matching;
  }

  /** Begins to exchange samples with a remote end. */
  abstract void connect(EndpointInfo remote, Destination destination);

  /** Ends that. */
  abstract void disconnect(Guid remote);

  /** Ends all. */
  abstract void end();

  @Override
  public final EndpointInfo info() {
    return info;
  }

  @Override
  public final List<EndpointInfo> matched() {
    synchronized (matching) {
      return List.copyOf(matched.values());
    }
  }

  @Override
  public final List<Mismatch> mismatches() {
    synchronized (matching) {
      return List.copyOf(mismatches.values());
    }
  }

  @Override
  public final void addListener(MatchListener listener) {
    synchronized (matching) {
      if (!listeners.addIfAbsent(listener)) {
        return;
      }
      matched.values().forEach(each -> matching.notices().add(() -> listener.matched(each)));
      mismatches.values().forEach(each -> matching.notices().add(() -> listener.mismatched(each)));
    }
    matching.notices().tell();
  }

  @Override
  public final void close() {
    matching.remove(this);
  }

  /** Whether they speak of one topic, from opposite ends. */
  final boolean concerns(EndpointInfo remote) {
    return remote.kind() != info.kind() && remote.topic().equals(info.topic());
  }

  /** Why it cannot exchange samples with a remote end; empty if it can. */
  final List<String> reasonsAgainst(EndpointInfo remote) {
    boolean writes = info.kind() == EndpointKind.WRITER;
    List<String> reasons = new ArrayList<>();
    if (!remote.type().equals(info.type())) {
      reasons.add("the writer sends " + (writes ? info : remote).type() + ", the reader asks for "
          + (writes ? remote : info).type());
    }
    reasons.addAll(Qos.mismatch((writes ? info : remote).qos(), (writes ? remote : info).qos()));
    return reasons;
  }

  /** A remote end is there, but none of its addresses can be used. */
  final void unreachable(EndpointInfo remote) {
    refuse(remote, List.of("none of the addresses that it announces is reached from here"));
  }

  private void refuse(EndpointInfo remote, List<String> reasons) {
    if (matched.containsKey(remote.guid())) {
      forget(remote.guid(), reasons.getFirst());
    }
    Mismatch mismatch = new Mismatch(remote, reasons);
    if (!mismatch.equals(mismatches.put(remote.guid(), mismatch))) {
      tell(listener -> listener.mismatched(mismatch));
    }
  }

  /** A remote end is there, or says something else than before. */
  final void evaluate(EndpointInfo remote, Destination destination) {
    List<String> against = reasonsAgainst(remote);
    EndpointInfo before = matched.get(remote.guid());
    if (!against.isEmpty()) {
      refuse(remote, against);
    } else if (!remote.equals(before)) {
      mismatches.remove(remote.guid());
      matched.put(remote.guid(), remote);
      connect(remote, destination);
      if (before == null) {
        tell(listener -> listener.matched(remote));
      }
    }
  }

  /** A remote end is no more. */
  final void forget(Guid remote, String reason) {
    mismatches.remove(remote);
    EndpointInfo gone = matched.remove(remote);
    if (gone != null) {
      disconnect(remote);
      tell(listener -> listener.unmatched(gone, reason));
    }
  }

  private void tell(Consumer<MatchListener> event) {
    listeners.forEach(listener -> matching.notices().add(() -> event.accept(listener)));
  }
}
