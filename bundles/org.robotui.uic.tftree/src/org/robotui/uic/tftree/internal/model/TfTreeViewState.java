package org.robotui.uic.tftree.internal.model;

import java.util.List;
import java.util.Optional;
import org.robotui.api.port.InputState;
import org.robotui.ui.Health;
import org.robotui.ui.diagram.Diagram;

/**
 * All that is seen of the view.
 *
 * @param ask what was asked for
 * @param state whether there are frames at all
 * @param rows those that are listed
 * @param drawing those as a tree
 * @param notices what is wrong, the worst first
 * @param detail of the selected frame
 * @param frames how many there are
 * @param trees how many trees they make
 */
public record TfTreeViewState(
    Ask ask, InputState state, List<FrameRow> rows, Diagram drawing, List<Notice> notices, Optional<FrameDetail> detail,
    int frames, int trees) {
  /** The short text of the title line. */
  public String title() {
    return frames == 0 ? ""
        : frames + (frames == 1 ? " frame" : " frames") + (trees == 1 ? "" : ", " + trees + " trees");
  }

  /**
   * What stands in place of the frames where none is shown.
   *
   * @param health its dot
   * @param title a few words
   * @param sentence what is so
   */
  public record Nothing(Health health, String title, String sentence) {}

  /** Why no frame is shown although there are some. */
  public Optional<Nothing> nothing() {
    if (!rows.isEmpty() || frames == 0) {
      return Optional.empty();
    }
    return Optional.of(ask.words().isEmpty()
        ? new Nothing(Health.OK, "No problems", "All " + frames + " frames are as they should be.")
        : new Nothing(Health.NONE, "No match", "No frame contains these words. Esc clears the filter."));
  }
}
