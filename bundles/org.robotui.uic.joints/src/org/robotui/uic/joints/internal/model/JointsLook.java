package org.robotui.uic.joints.internal.model;

import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.robotui.api.port.InputState;
import org.robotui.ui.Figures;
import org.robotui.ui.StateView;

/**
 * All that the view shows, at one moment.
 *
 * @param state of the whole
 * @param sources in a stable order
 * @param joints of all sources, in the order in which they came first
 * @param degrees whether angles are in degrees
 * @param leftOut whether there are more joints than are listed
 */
public record JointsLook(InputState state, List<SourceRow> sources, List<JointRow> joints, boolean degrees,
    boolean leftOut) {
  /** Copies the lists. */
  public JointsLook {
    sources = List.copyOf(sources);
    joints = List.copyOf(joints);
  }

  /** Whether it must be said where a joint comes from. */
  public boolean several() {
    return sources.size() > 1;
  }

  /** The joints that contain all of some words in name or source. */
  public List<JointRow> matching(String words) {
    List<String> wanted = Stream.of(words.strip().toLowerCase(Locale.ROOT).split("\\s+")).toList();
    return joints.stream().filter(row -> wanted.stream().allMatch(row.key().toLowerCase(Locale.ROOT)::contains))
        .toList();
  }

  /** Whether a joint has no configured unit, so that rad cannot be told from m. */
  public boolean unitsUnknown() {
    return joints.stream().anyMatch(row -> row.unit() == JointUnit.UNKNOWN);
  }

  /** What stands at the right of the view's title. */
  public String note() {
    long stale = joints.stream().filter(JointRow::stale).count();
    return Stream.of(
        joints.size() + (joints.size() == 1 ? " joint" : " joints") + (leftOut ? ", more left out" : ""),
        stale == 0 ? "" : stale + " stale",
        several() ? sources.size() + " sources" : "")
        .filter(part -> !part.isEmpty()).collect(Collectors.joining(" \u00b7 "));
  }

  /** Rate and age of a source. */
  public static String words(SourceRow source) {
    String state = StateView.word(source.state());
    boolean live = source.state() instanceof InputState.Live && !Double.isNaN(source.ageSeconds());
    return live ? state + ", " + Figures.age(source.ageSeconds()) : state;
  }

  /** The same with other angles. */
  public JointsLook inDegrees(boolean wanted) {
    return new JointsLook(state, sources, joints, wanted, leftOut);
  }
}
