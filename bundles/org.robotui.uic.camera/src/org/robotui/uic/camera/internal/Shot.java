package org.robotui.uic.camera.internal;

import java.util.List;
import java.util.Optional;
import org.eclipse.swt.graphics.ImageData;
import org.robotui.api.port.InputState;
import org.robotui.api.port.SourceId;
import org.robotui.data.image.CameraInfo;
import org.robotui.entity.image.Picture;
import org.robotui.ui.StateView;

/**
 * All that the view shows, at one moment.
 *
 * @param state what the input has; failed where the newest picture cannot be decoded
 * @param shown the newest that could be decoded
 * @param info the calibration
 * @param candidates what could be connected, where the user must choose
 * @param message what became of a picture that was to be saved, for a few seconds
 */
record Shot(
    InputState state,
    Optional<Shown> shown,
    Optional<CameraInfo> info,
    List<SourceId> candidates,
    Optional<String> message) {
  static final Shot NOTHING =
      new Shot(new InputState.Unconnected("not looked for yet"), Optional.empty(), Optional.empty(), List.of(),
          Optional.empty());

  /**
   * A picture and what is painted of it.
   *
   * @param picture the picture
   * @param pixels the picture, or it as seen from afar
   * @param frame where it was taken
   * @param receivedNanos when it came, {@link System#nanoTime()}
   */
  record Shown(Picture picture, ImageData pixels, String frame, long receivedNanos) {}

  /** The picture, where the state lets it be seen. */
  Optional<Shown> seen() {
    return shown.filter(p -> StateView.showsContent(state));
  }

  /** What stands at the right of the view's title. */
  String note() {
    return seen().map(Shown::picture)
        .map(p -> p.width() + "\u00d7" + p.height() + " " + p.encoding() + " " + StateView.word(state))
        .orElse(StateView.word(state));
  }

  /** The same with what became of saving. */
  Shot with(Optional<String> told) {
    return new Shot(state, shown, info, candidates, told);
  }

  /** Whether it looks other than another. */
  boolean differs(Shot other) {
    return !shown.map(Shown::pixels).equals(other.shown.map(Shown::pixels)) || !note().equals(other.note())
        || !candidates.equals(other.candidates) || !message.equals(other.message)
        || !state.explanation().equals(other.state.explanation());
  }
}
