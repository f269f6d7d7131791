package org.robotui.ui.scene;

import java.util.List;
import java.util.Optional;
import org.robotui.api.frame.Frames;
import org.robotui.data.FrameId;

/** Chooses what is drawn at rest. */
public final class FixedFrame {
  private static final List<String> PREFERRED = List.of("map", "odom");

  private FixedFrame() {}

  /**
   * Chooses.
   *
   * @param wanted the user's choice: a frame's name, or robot:name
   * @param frames the known frames
   * @param named frames that data are given in, used where no transform is known at all
   * @return the frame that things are shown in; none where nothing names any
   */
  public static Optional<FrameId> choose(Optional<String> wanted, Frames frames, List<FrameId> named) {
    List<FrameId> known = frames.all();
    return wanted.isPresent() ? asked(wanted.get(), known, named) : best(frames, known, named);
  }

  private static Optional<FrameId> best(Frames frames, List<FrameId> known, List<FrameId> named) {
    return PREFERRED.stream()
        .flatMap(name -> uppermost(frames, known.stream().filter(f -> f.name().equals(name)).toList()).stream())
        .findFirst()
        .or(() -> known.stream().filter(f -> frames.parent(f).isEmpty()).findFirst())
        .or(() -> PREFERRED.stream().flatMap(name -> named.stream().filter(f -> f.name().equals(name))).findFirst())
        .or(() -> named.stream().filter(f -> !f.name().isEmpty()).findFirst());
  }

  /** Of the maps of several robots the one that carries the others, where the configuration joins them. */
  private static Optional<FrameId> uppermost(Frames frames, List<FrameId> same) {
    return same.stream().filter(f -> frames.parent(f).filter(same::contains).isEmpty()).findFirst();
  }

  private static Optional<FrameId> asked(String wanted, List<FrameId> known, List<FrameId> named) {
    Optional<FrameId> match = known.stream().filter(f -> matches(wanted, f)).findFirst()
        .or(() -> named.stream().filter(f -> matches(wanted, f)).findFirst());
    // A frame that is not there yet is waited for: the layers say what they lack.
    return match.or(() -> first(known, named).map(f -> new FrameId(f.robot(), wanted)));
  }

  private static Optional<FrameId> first(List<FrameId> known, List<FrameId> named) {
    return known.stream().findFirst().or(() -> named.stream().findFirst());
  }

  private static boolean matches(String wanted, FrameId frame) {
    return wanted.equals(frame.name()) || wanted.equals(frame.toString());
  }
}
