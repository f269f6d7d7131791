package org.robotui.uic.joints.internal.model;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.LongUnaryOperator;
import java.util.stream.Collectors;
import org.robotui.api.port.Input;
import org.robotui.api.port.SourceId;
import org.robotui.data.joint.JointState;

/** Remembers the joints of all sources. Used by one thread at a time, the tick. */
public final class JointTracks {
  private final Map<SourceId, SourceTracks> sources = new LinkedHashMap<>();
  private final LongUnaryOperator aging;
  private Set<SourceId> asked = Set.of();

  /**
   * Without joints.
   *
   * @param aging translates moments of this machine into the time by which values grow old
   */
  public JointTracks(LongUnaryOperator aging) {
    this.aging = aging;
  }

  /**
   * Takes what came, and forgets sources that are no longer connected.
   *
   * @param input the joints, merged since the last tick
   * @param messages single messages as they came, of which few are asked for: they alone tell where a joint stands
   * @param now in the time by which they grow old
   */
  public void take(Input<JointState> input, Input<JointState> messages, long now) {
    List<SourceId> connected = input.sources();
    sources.keySet().retainAll(connected);
    connected.forEach(this::of);
    input.drain(envelope -> of(envelope.source()).put(envelope.value(), aging.applyAsLong(envelope.receivedNanos())));
    messages.drain(
        message -> Optional.ofNullable(sources.get(message.source())).ifPresent(source -> source.learn(message, now)));
    Set<SourceId> next = sources.entrySet().stream().filter(e -> e.getValue().wantsMessage(now)).map(Map.Entry::getKey)
        .collect(Collectors.toUnmodifiableSet());
    if (!next.equals(asked)) {
      asked = next;
      messages.choose(next);
    }
  }

  /** Forgets what was seen of ranges, and the joints that came no more. */
  public void forget() {
    sources.values().forEach(SourceTracks::forget);
  }

  /** All that is to be shown. */
  public JointsLook look(Input<JointState> input, JointOptions options, long now) {
    List<SourceRow> rows =
        sources.entrySet().stream().map(e -> e.getValue().look(input.state(e.getKey()), now)).toList();
    List<JointRow> joints = sources.entrySet().stream()
        .flatMap(e -> e.getValue().rows(input.state(e.getKey()), options, now)).toList();
    boolean leftOut = sources.values().stream().anyMatch(SourceTracks::leftOut);
    return new JointsLook(input.state(), rows, joints, options.degrees(), leftOut);
  }

  private SourceTracks of(SourceId source) {
    return sources.computeIfAbsent(source, SourceTracks::new);
  }
}
