package org.robotui.uic.joints.internal.model;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import org.robotui.api.port.Envelope;
import org.robotui.api.port.InputState;
import org.robotui.api.port.SourceId;
import org.robotui.data.joint.JointState;
import org.robotui.data.joint.JointState.Joint;

/** What is remembered of one source. Used by the tick only. */
final class SourceTracks {
  /** A robot has hundreds of joints at most; one that makes up names must not fill the memory. */
  static final int MOST_JOINTS = 5_000;

  private static final double NANOS = 1e-9;
  private static final int ENOUGH_BARE = 3;
  private static final long RELEARN_NANOS = 30_000_000_000L;

  private final SourceId source;
  private final Map<String, Track> joints = new LinkedHashMap<>();
  private JointPlaces places = JointPlaces.NONE;
  private long newest;
  private boolean heard;
  private boolean leftOut;
  private boolean named;
  private long namedAt;
  private int bare;

  SourceTracks(SourceId source) {
    this.source = source;
  }

  void put(JointState state, long receivedNanos) {
    heard = true;
    newest = receivedNanos;
    state.joints().forEach(joint -> put(joint, receivedNanos));
  }

  private void put(Joint joint, long receivedNanos) {
    Track known = joints.get(joint.name());
    if (known != null) {
      known.put(joint, receivedNanos);
    } else if (joints.size() < MOST_JOINTS) {
      joints.put(joint.name(), new Track(joint, receivedNanos));
      named = false;
    } else {
      leftOut = true;
    }
  }

  /**
   * Learns where joints stand from a message as it came; one without its bytes may be several merged, and counts only
   * if all are so.
   */
  void learn(Envelope<JointState> message, long now) {
    bare = message.raw().isPresent() ? 0 : bare + 1;
    if (bare == 0 || bare >= ENOUGH_BARE) {
      places = places.with(message.record());
      named = true;
      namedAt = now;
      bare = 0;
    }
  }

  /** Whether a message as it came is wanted: joints are new, or might stand elsewhere since a program was restarted. */
  boolean wantsMessage(long now) {
    return !joints.isEmpty() && (!named || now - namedAt > RELEARN_NANOS);
  }

  void forget() {
    joints.values().removeIf(track -> track.isSilent(newest));
    joints.values().forEach(Track::forgetRange);
    leftOut = false;
  }

  /** Whether it has more joints than are shown. */
  boolean leftOut() {
    return leftOut;
  }

  SourceRow look(InputState state, long now) {
    return new SourceRow(source, state, joints.size(), heard ? Math.max(0, (now - newest) * NANOS) : Double.NaN);
  }

  Stream<JointRow> rows(InputState state, JointOptions options, long now) {
    boolean old = !(state instanceof InputState.Live);
    return List.copyOf(joints.entrySet()).stream().map(e -> e.getValue().row(source, options,
        old || e.getValue().isSilent(newest), now, places.fields(), places.of(e.getKey())));
  }
}
