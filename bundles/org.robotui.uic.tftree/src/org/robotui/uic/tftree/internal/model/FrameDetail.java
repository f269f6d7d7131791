package org.robotui.uic.tftree.internal.model;

import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import org.robotui.data.FrameId;

/**
 * All that is known of the selected frame.
 *
 * @param frame which
 * @param reference the frame in which its pose is given
 * @param missing why there is no pose, none where there is one
 * @param values names and figures, the pose first
 */
public record FrameDetail(FrameId frame, FrameId reference, Optional<String> missing, List<Value> values) {
  /** Copies the list. */
  public FrameDetail {
    values = List.copyOf(values);
  }

  /**
   * A name and its figure.
   *
   * @param name what
   * @param value how much, with its unit
   */
  public record Value(String name, String value) {}

  /** All of it, for the clipboard. */
  public String text() {
    return frame + " in " + reference + "\n" + missing.map(why -> why + "\n").orElse("")
        + values.stream().map(v -> v.name() + "\t" + v.value()).collect(Collectors.joining("\n")) + "\n";
  }
}
